// Hands on the sheet of a phone: its handle is dragged, and a tap beside it closes it.
import { listen } from "../hands";
import { panel } from "../store";
import { large } from "./swipe";

/** A finger that moves less is a tap [px]; one that is faster flings [px/ms]. */
const STILL = 8;
const FAST = 0.5;
/** Let go below the first share of the stage it closes, above the second it is full. */
const [SHUT, FULL] = [0.28, 0.78];

/** What cannot be reached while the sheet is open: what it covers, and what opens other panels. */
const BEHIND = ".who, .readiness, .scene > .view, .stage-switch";
/** A tap on anything else is one beside the sheet. */
const KEPT = ".bottom-sheet, .dock, .quick, .stopbar, .said, .questions";

/** Take the focus, and give it back when the returned function is called; a tap beside closes. */
export function holdFocus(sheet: HTMLElement): () => void {
  const opener = document.activeElement as HTMLElement | null;
  const behind = [...document.querySelectorAll<HTMLElement>(BEHIND)];
  for (const one of behind) one.inert = true;
  const click = ({ target }: Event): void => {
    if (!(target as Element).closest(KEPT)) panel.value = "";
  };
  const unhear = listen(document, { click });
  requestAnimationFrame(() => sheet.querySelector<HTMLElement>("[aria-current=true]")?.focus());
  return () => {
    unhear();
    for (const one of behind) one.inert = false;
    const now = document.activeElement;
    if (now !== document.body && !sheet.contains(now)) return;
    const back = opener?.isConnected ? opener : document.querySelector<HTMLElement>(".to-fly");
    back?.focus();
  };
}

/** Let a handle drag its sheet; `settle` is told how high it is then, as a share of the stage. */
export function listenToHandle(handle: HTMLElement, settle: (share: number) => void): () => void {
  const sheet = handle.parentElement!;
  let [start, height, speed, last] = [null as PointerEvent | null, 0, 0, 0];
  let dragged = false;

  const down = (event: PointerEvent): void => {
    if (!event.isPrimary || event.button !== 0) return;
    [start, height, speed, last, dragged] = [event, sheet.offsetHeight, 0, event.timeStamp, false];
  };
  const move = (event: PointerEvent): void => {
    if (!start) return;
    const up = start.clientY - event.clientY;
    if (!dragged && Math.abs(up) <= STILL) return;
    // Not before: a tap is of the button below it.
    if (!dragged) handle.setPointerCapture(event.pointerId);
    dragged = true;
    const before = sheet.offsetHeight;
    sheet.dataset["dragged"] = "";
    sheet.style.height = `${Math.min(large().offsetHeight, Math.max(0, height + up))}px`;
    speed = (sheet.offsetHeight - before) / Math.max(1, event.timeStamp - last);
    last = event.timeStamp;
  };
  const end = (): void => {
    if (start && dragged) {
      const whole = large().offsetHeight;
      const flung = speed > 0 ? 1 : height > FULL * whole ? 0.5 : 0;
      settle(Math.abs(speed) < FAST ? nearest(sheet.offsetHeight / whole) : flung);
    }
    start = null;
    delete sheet.dataset["dragged"];
    sheet.style.height = "";
  };
  /** The click that ends a drag is none. */
  const click = (event: MouseEvent): void => {
    if (dragged && event.detail > 0) event.stopPropagation();
    dragged = false;
  };

  return listen(handle, {
    pointerdown: down,
    pointermove: move,
    pointerup: end,
    pointercancel: end,
    click,
  });
}

const nearest = (share: number): number => (share < SHUT ? 0 : share > FULL ? 1 : 0.5);
