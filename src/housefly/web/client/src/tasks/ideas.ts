// What one may ask here, for somebody who sees this for the first time: each is one tap.
import { catalogue } from "../live/store";
import { hasDrone, room } from "../store";
import { language, type Language } from "../messages/language";

const MEANT = "object";

/** In the language in which the words are read; names only where the language has them. */
const IDEAS: Record<Language, () => string[]> = {
  en: () => [
    "Who is at the door?",
    ...(hasDrone.value ? places() : []).map((one) => `Look at the ${one.toLowerCase()}`),
    ...things().map((one) => `Where is ${one}?`),
    "Is anybody in the room?",
  ],
  de: () => [
    "Wer ist an der Tür?",
    "Ist jemand da?",
    "Ist alles in Ordnung?",
    "Was ist heute passiert?",
  ],
  ja: () => ["玄関に誰がいますか", "誰かいますか", "大丈夫ですか", "今日何がありましたか"],
};

export const ideas = (): string[] => IDEAS[language.value]();

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
