// Keeps the screen on while the drone flies.
import { effect } from "@preact/signals";
import { flying } from "./store";

export function keepAwake(): void {
  let lock: WakeLockSentinel | null = null;
  const update = async (): Promise<void> => {
    if (flying.peek() && !lock && document.visibilityState === "visible") {
      lock = (await navigator.wakeLock?.request("screen").catch(() => null)) ?? null;
      lock?.addEventListener("release", () => (lock = null));
    } else if (!flying.peek() && lock) {
      await lock.release();
    }
  };
  effect(() => {
    flying.value;
    void update();
  });
  document.addEventListener("visibilitychange", () => void update());
}
