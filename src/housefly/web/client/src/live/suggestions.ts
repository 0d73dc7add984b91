// What somebody could have meant: names that share pairs of letters with what was typed.
import type { ThingAnswer } from "../wire/room-messages";

const MAX_SUGGESTIONS = 4;
const MIN_LIKENESS = 0.25;

function pairs(words: string): Set<string> {
  const text = ` ${words.toLowerCase()} `;
  return new Set(Array.from({ length: text.length - 1 }, (_, k) => text.slice(k, k + 2)));
}

/** Share of pairs of letters that two names have in common, 0 to 1. */
function likeness(one: Set<string>, other: string): number {
  const own = pairs(other);
  return (2 * [...own].filter((pair) => one.has(pair)).length) / (own.size + one.size);
}

export function suggestions(words: string, things: ThingAnswer[]): string[] {
  const wanted = pairs(words);
  const scored = things.map((one) => ({
    name: one.name,
    score: Math.max(...[one.name, ...one.aliases].map((name) => likeness(wanted, name))),
  }));
  return scored
    .filter(({ score }) => score >= MIN_LIKENESS)
    .sort((a, b) => b.score - a.score)
    .slice(0, MAX_SUGGESTIONS)
    .map(({ name }) => name);
}
