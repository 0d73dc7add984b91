// Keeps the screen on while the drone flies.
import { computed, effect, signal } from "@preact/signals";
import { flying } from "./store";

const held = signal<WakeLockSentinel | null>(null);
/** Whether the screen may go dark although the drone flies. */
export const mayGoDark = computed(() => flying.value && held.value === null);

export function keepAwake(): void {
  let asking = false;
  const update = async (): Promise<void> => {
    if (!flying.peek()) {
      await held.peek()?.release();
    } else if (!held.peek() && !asking && document.visibilityState === "visible") {
      asking = true;
      const lock = (await navigator.wakeLock?.request("screen").catch(() => null)) ?? null;
      asking = false;
      lock?.addEventListener("release", () => (held.value = null));
      held.value = lock;
      if (!flying.peek()) await lock?.release();
    }
  };
  effect(() => {
    flying.value;
    void update();
  });
  document.addEventListener("visibilitychange", () => void update());
}
