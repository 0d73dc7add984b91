// What somebody typed into the ask bar: a place to fly to, a thing to find, or a sentence.
import { signal } from "@preact/signals";
import { choosePlace, choosePoint } from "../goal";
import { find, unfind } from "../live/room-client";
import { catalogue } from "../live/store";
import { hasDrone, room } from "../store";
import { ask, forget } from "../tasks/ask";
import { running } from "../tasks/board";
import { services, request } from "../tasks/tasks-client";
import type { PlaceView } from "../wire/messages";
import type { WhereAnswer } from "../wire/room-messages";
import { t } from "../messages/language";

/** Whether the field holds half a question: without it the next letters would be commands. */
export const writing = signal(false);

const GO = [
  /^(?:go|fly|look)\s+(?:to|at)?\s*(?:the\s+)?(.+?)[.!?]*$/i,
  /^(.+?)(?:へ|に|まで|を)(?:行って|飛んで|見て|行く|飛ぶ|見る).*$/,
  /^(?:flieg|fliege|geh|gehe|schau)\s+(?:zu[mr]?|nach|an|auf)?\s*(.+?)[.!?]*$/i,
];
const WHERE = [
  /^where(?:\s+is|\s+are|'s)?\s+(.+?)[.?!]*$/i,
  /^(.+?)(?:は|って)(?:どこ).*$/,
  /^wo(?:\s+ist|\s+sind)?\s+(?:de[rn]|die|das)?\s*(.+?)[.?!]*$/i,
];

/** What a pattern of any language finds: people mix them. */
const part = (patterns: RegExp[], words: string): string | undefined =>
  patterns.map((one) => one.exec(words)?.[1]).find((found) => found);

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
  const names = things.flatMap((one) => [one.name, ...one.aliases]);
  const places = (room.value?.places ?? []).filter((one) => one.name !== "home");
  return [
    ...(hasDrone.value ? places.map((one) => t("Go to {place}", { place: one.title })) : []),
    ...new Set(names.map((thing) => t("Where is {thing}", { thing }))),
  ];
}

/** Put away what was asked, and its answer. */
export function unask(): void {
  forget();
  unfind();
}

export async function askFor(typed: string): Promise<void> {
  const words = typed.trim();
  writing.value = false;
  unask();
  if (!words) return;
  const target = part(GO, words) ?? "";
  const place = hasDrone.peek() ? placeCalled(target || words) : undefined;
  const thing = part(WHERE, words) ?? words;
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
