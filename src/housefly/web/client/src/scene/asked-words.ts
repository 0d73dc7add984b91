// What somebody typed into the ask bar: a place to fly to, a thing to find, or a sentence.
import { choosePlace, choosePoint } from "../goal";
import { find, unfind } from "../live/room-client";
import { catalogue } from "../live/store";
import { room } from "../store";
import { ask, forget } from "../tasks/ask";
import { running } from "../tasks/board";
import { services, request } from "../tasks/tasks-client";
import type { PlaceView } from "../wire/messages";
import type { WhereAnswer } from "../wire/room-messages";

const GO = /^(?:go|fly|look)\s+(?:to|at)?\s*(?:the\s+)?(.+?)[.!?]*$/i;
const WHERE = /^where(?:\s+is|\s+are|'s)?\s+(.+?)[.?!]*$/i;

const same = (one: string, other: string): boolean => one.toLowerCase() === other.toLowerCase();

function placeCalled(words: string): PlaceView | undefined {
  return room.value?.places.find((one) => same(one.title, words) || same(one.name, words));
}

const isThing = (words: string): boolean =>
  catalogue.value.some((one) => [one.name, ...one.aliases].some((name) => same(name, words)));

/** What may be asked for, for the list below the field. */
export function ideasFor(): string[] {
  const quiet = ["sensor", "structure"];
  const things = catalogue.value.filter((one) => !quiet.includes(one.kind));
  const places = (room.value?.places ?? []).filter((one) => one.name !== "home");
  return [
    ...places.map((one) => `Go to ${one.title}`),
    ...new Set(things.flatMap((one) => [one.name, ...one.aliases]).map((one) => `Where is ${one}`)),
  ];
}

export async function askFor(typed: string): Promise<void> {
  const words = typed.trim();
  forget();
  unfind();
  if (!words) return;
  const target = GO.exec(words)?.[1] ?? "";
  const place = placeCalled(target || words);
  const thing = WHERE.exec(words)?.[1] ?? words;
  if (place) choosePlace(place);
  else if (target && isThing(target)) await find(target);
  else if (isThing(thing) || !running.value) await find(thing);
  else await ask(words);
}

/** Send the drone to look at what was found: by the task for it, or as a goal on the map. */
export async function lookThere(found: WhereAnswer): Promise<void> {
  if (running.value) {
    const look = (await services()).services.find((one) => one.name === "look");
    const subject = look?.parameters.find((one) => one.type === "place_or_thing");
    if (look && subject) {
      await request(look.name, { [subject.name]: found.thing });
      return;
    }
  }
  const known = catalogue.value.find((one) => one.thing === found.thing);
  const spot = known?.viewpoints[0]?.position ?? found.position;
  if (spot) choosePoint([spot[0], spot[1]], found.name);
}
