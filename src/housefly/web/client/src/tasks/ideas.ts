// What one may ask here, for somebody who sees this for the first time: each is one tap.
import { catalogue } from "../live/store";
import { hasDrone, room } from "../store";
import { ideasToAsk } from "../messages/language";

const MEANT = "object";

/** In the language of the page; names only where that language has them. */
export const ideas = (): string[] =>
  ideasToAsk() ?? [
    "Who is at the door?",
    ...(hasDrone.value ? places() : []).map((one) => `Look at the ${one.toLowerCase()}`),
    ...things().map((one) => `Where is ${one}?`),
    "Is anybody in the room?",
  ];

/** The place that is looked at first. */
function places(): string[] {
  const known = (room.value?.places ?? []).filter((one) => one.name !== "home");
  return known.slice(0, 1).map((one) => one.title);
}

/** Something that is carried about. */
function things(): string[] {
  const known = catalogue.value.filter((one) => one.kind === MEANT);
  return known.slice(0, 1).map((one) => one.name);
}
