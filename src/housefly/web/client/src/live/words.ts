// Times and ages as people say them, and what sort of thing something is.
import type { SituationAnswer, EventAnswer } from "../wire/room-messages";
import type { Key } from "../messages/en";
import { nameOf, things, type Seen } from "./store";
import { language, t, translated } from "../messages/language";
import { capital } from "../format";
import { causeOf } from "../tasks/words";

const NOW = 2;
const UNITS: [number, Key][] = [
  [86400, "{n} days ago"],
  [3600, "{n} h ago"],
  [60, "{n} min ago"],
  [1, "{n} s ago"],
];

export function ago(age: number): string {
  if (age < NOW) return t("now");
  const [length, words] = UNITS.find(([seconds]) => age >= 2 * seconds) ?? UNITS[3]!;
  return t(words, { n: Math.floor(age / length) });
}

/** Time of day, and the day when it is not today. */
export function clock(unix: number): string {
  const date = new Date(1000 * unix);
  const time = date.toTimeString().slice(0, 8);
  if (date.toDateString() === new Date().toDateString()) return time;
  return `${date.toLocaleDateString(language.value, { month: "short", day: "numeric" })} ${time}`;
}

/** Sensor floors number the people on them; the catalogue may not know those. */
export function kindOf(thing: Seen): string {
  return thing.kind === "object" && thing.thing.startsWith("person-") ? "person" : thing.kind;
}

export function happened(event: EventAnswer): string {
  const words = capital(translated(event.words));
  const whose = things.value.has(event.thing) ? `: ${nameOf(event.thing)}` : "";
  const by = event.cause ? ` ${t("by {name}", { name: causeOf(nameOf(event.cause)) })}` : "";
  const said =
    event.source !== event.thing && things.value.has(event.source)
      ? ` (${nameOf(event.source)})`
      : "";
  return words + whose + by + said;
}

const ORDINARY =
  /^(person (present|walking|standing|sitting|lying)|bed occupied|appliance on|contact open)$/;

/** Whether somebody should look; that a person walks about is no worry. */
export const isWorry = (kind: string): boolean => !ORDINARY.test(kind);

/** Worries first; that a person is there goes without saying where more is known of them. */
export function worthSaying(held: SituationAnswer[]): SituationAnswer[] {
  const known = held.filter(
    (one) =>
      one.kind !== "person present" ||
      !held.some((other) => other !== one && other.thing === one.thing),
  );
  return [...known].sort((a, b) => Number(isWorry(b.kind)) - Number(isWorry(a.kind)));
}
