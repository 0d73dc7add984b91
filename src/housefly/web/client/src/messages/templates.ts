// English sentences of the server with numbers and names in them, put into another language.

import type { Templates } from "./speech";

interface Rule {
  pattern: RegExp;
  names: string[];
  own: string;
}

const KEPT = 500;

const NUMBER = "([-+]?(?:[\\d.]*\\d|inf|nan))";
const NAME = "([^;]+?)";
const WORDS = "(.+?)";
/** A placeholder of one letter is a number. */
const isNumber = (name: string): boolean => name.length === 1;
/** Placeholders of names, which stay as they are; every other is words that need a template. */
const NAMES = ["who", "place", "goal", "thing", "name"];
const literal = (words: string): string => words.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
const weight = (template: string): number => template.replace(/\{\w+\}/g, "").length;

function rule([english, own]: [string, string]): Rule {
  const names = [...english.matchAll(/\{(\w+)\}/g)].map((found) => found[1]!);
  const pattern = english
    .split(/(\{\w+\})/)
    .map((part) => {
      const name = /^\{(\w+)\}$/.exec(part)?.[1];
      if (!name) return literal(part);
      return isNumber(name) ? NUMBER : NAMES.includes(name) ? NAME : WORDS;
    })
    .join("");
  return { pattern: new RegExp(`^${pattern}$`, "s"), names, own };
}

/** How a language writes numbers, and how it ends a sentence. */
export interface Habits {
  point: string;
  stop: string;
}

/** Return what puts a sentence into the language of the templates, or null where none fits. */
export function teller(templates: Templates, habits: Habits): (english: string) => string | null {
  const rules = Object.entries(templates)
    .sort(([a], [b]) => weight(b) - weight(a))
    .map(rule);
  const known = new Map<string, string | null>();

  function whole(english: string): string | null {
    const exact = templates[english];
    if (exact !== undefined) return exact;
    for (const { pattern, names, own } of rules) {
      const found = pattern.exec(english);
      if (!found || names.length === 0) continue;
      const values = new Map(names.map((name, k) => [name, value(name, found[k + 1]!)]));
      if ([...values.values()].includes(null)) continue;
      return own.replace(/\{(\w+)\}/g, (_, name: string) => values.get(name)!);
    }
    return null;
  }

  function value(name: string, english: string): string | null {
    if (isNumber(name)) return english.replace(".", habits.point);
    return put(english) ?? (NAMES.includes(name) ? english : null);
  }

  /** A template has no full stop, and a capital only where the server writes one. */
  function put(english: string): string | null {
    const open = english.replace(/\.$/, "");
    const bare = open.charAt(0).toLowerCase() + open.slice(1);
    const own = whole(open) ?? whole(bare);
    return own === null || open === english ? own : own + habits.stop;
  }

  return (english) => {
    const before = known.get(english);
    if (before !== undefined) return before;
    const own = put(english);
    if (known.size >= KEPT) known.clear();
    known.set(english, own);
    return own;
  };
}
