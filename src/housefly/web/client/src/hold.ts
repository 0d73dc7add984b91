// Hold instead of click: the action runs after a long enough hold that stays allowed throughout.
import { effect, signal, type ReadonlySignal, type Signal } from "@preact/signals";
import { explain, hint } from "./said";
import { t } from "./messages/language";

export interface Hold {
  seconds: number;
  /** Why it cannot be done now, in words, or "". */
  objection: ReadonlySignal<string>;
  held: Signal<boolean>;
  /** The button that shows it, if any is on the screen. */
  button: Element | null;
  begin(): void;
  cancel(): void;
  /** End it without a word: its button is gone. */
  stop(): void;
}

export function createHold(
  seconds: number,
  objection: ReadonlySignal<string>,
  action: (button: Element | null) => void,
): Hold {
  const held = signal(false);
  let timer = 0;
  const stop = (): void => {
    clearTimeout(timer);
    held.value = false;
  };
  const begin = (): void => {
    if (held.peek()) return;
    if (objection.peek()) {
      explain(objection, hold.button);
      return;
    }
    held.value = true;
    timer = window.setTimeout(() => {
      stop();
      action(hold.button);
    }, seconds * 1000);
  };
  const cancel = (): void => {
    if (held.peek()) hint(t("Hold it for {n} s: a tap does nothing.", { n: seconds }), hold.button);
    stop();
  };
  effect(() => {
    if (!objection.value) return;
    // Whoever holds is told why nothing comes of it, also when it is over in a moment.
    if (held.peek()) hint(objection.value, hold.button);
    stop();
  });
  const hold: Hold = { seconds, objection, held, button: null, begin, cancel, stop };
  return hold;
}
