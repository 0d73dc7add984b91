// Hold instead of click: the action runs after a long enough hold that stays allowed throughout.
import { effect, signal, type ReadonlySignal, type Signal } from "@preact/signals";
import { explain } from "./preflight";

export interface Hold {
  seconds: number;
  /** Why it cannot be done now, in words, or "". */
  objection: ReadonlySignal<string>;
  held: Signal<boolean>;
  begin(): void;
  cancel(): void;
}

export function createHold(
  seconds: number,
  objection: ReadonlySignal<string>,
  action: () => void,
): Hold {
  const held = signal(false);
  let timer = 0;
  const cancel = (): void => {
    clearTimeout(timer);
    held.value = false;
  };
  const begin = (): void => {
    if (held.peek()) return;
    if (objection.peek()) {
      explain(objection);
      return;
    }
    held.value = true;
    timer = window.setTimeout(() => {
      cancel();
      action();
    }, seconds * 1000);
  };
  effect(() => {
    if (objection.value) cancel();
  });
  return { seconds, objection, held, begin, cancel };
}
