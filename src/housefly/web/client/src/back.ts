// Back closes what was opened last, and leaves only from the plain live scene: the history of the
// browser has an entry for each thing that is open, whose state is how many are.
import { effect } from "@preact/signals";

const closers: (() => void)[] = [];
let isDue = false;
/** The address to keep while entries that nothing needs are left, or "". */
let leaving = "";

/** Make the history as long as it should be, once all that changes together has changed. */
function settle(): void {
  if (isDue) return;
  isDue = true;
  queueMicrotask(() => {
    isDue = false;
    if (leaving) return;
    while (closers.length > history.state) history.pushState(history.state + 1, "");
    if (closers.length === history.state) return;
    leaving = location.href;
    history.go(closers.length - history.state);
  });
}

/** Let Back close something while it is open. */
export function layer(isOpen: () => boolean, close: () => void): void {
  effect(() => {
    const at = closers.indexOf(close);
    if (isOpen() === at < 0) {
      if (at < 0) closers.push(close);
      else closers.splice(at, 1);
    }
    settle();
  });
}

history.replaceState(history.state ?? 0, "");
window.addEventListener("popstate", () => {
  if (history.state === null && !leaving) {
    // A link within the page made this entry; what it opens comes in a moment.
    history.replaceState(closers.length + 1, "");
    return;
  }
  if (leaving) history.replaceState(history.state, "", leaving);
  else while (closers.length > history.state) closers.pop()!();
  leaving = "";
  settle();
});
