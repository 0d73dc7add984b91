// What a button has to say: held too short, not now, or refused; the last stays until it is read.
import { signal, type ReadonlySignal } from "@preact/signals";
import { sentence } from "./format";
import type { OrderKind, OrderRefused } from "./wire/messages";
import { translated } from "./messages/language";

interface Said {
  words: string;
  /** Beside what it is shown; without, or when that is gone, above STOP. */
  anchor: Element | null;
  stays: boolean;
}

export const said = signal<Said | null>(null);

const RECENTLY = 8000;
const REFUSED_WITHIN = 5000;
let timer = 0;
let forget: (() => void) | null = null;

function show(words: string, anchor: Element | null, stays: boolean): void {
  clearTimeout(timer);
  forget?.();
  forget = null;
  said.value = { words, anchor, stays };
  if (!stays) timer = window.setTimeout(unsay, RECENTLY);
}

export function unsay(): void {
  clearTimeout(timer);
  forget?.();
  forget = null;
  said.value = null;
}

/** Say for a while what to do otherwise; what still has to be read is not pushed away. */
export function hint(words: string, anchor: Element | null): void {
  if (!said.peek()?.stays) show(words, anchor, false);
}

/** Say for a while, as long as it holds, why a button did nothing. */
export function explain(objection: ReadonlySignal<string>, anchor: Element | null): void {
  show(objection.peek(), anchor, false);
  whileSame(objection);
}

/** Say why something was refused, or what was lost, until it is read; or as long as it holds. */
export function refuse(
  words: string,
  anchor: Element | null,
  holds?: ReadonlySignal<unknown>,
): void {
  show(sentence(words), anchor, true);
  if (holds) whileSame(holds);
}

function whileSame(holds: ReadonlySignal<unknown>): void {
  const then = holds.peek();
  forget = holds.subscribe((now) => now !== then && setTimeout(unsay));
}

let asked: { order: OrderKind; at: number; anchor: Element | null } | null = null;

/** Remember which button gave an order: the pilot answers later. */
export function remember(order: OrderKind, anchor: Element | null): void {
  asked = { order, at: Date.now(), anchor };
  if (said.peek()) unsay();
}

/** What the pilot refused goes back to the button that asked for it. */
export function tellRefusal({ order, reason }: OrderRefused): void {
  const mine = asked?.order === order && Date.now() - asked.at < REFUSED_WITHIN;
  if (mine) refuse(translated(reason), asked!.anchor);
}
