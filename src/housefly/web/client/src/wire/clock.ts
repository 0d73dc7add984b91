// The server's clock as this browser knows it: every age on the screen is counted against it.
import { signal } from "@preact/signals";

const KEPT = 10;

interface Sample {
  lag: number;
  offset: number;
}

const samples: Sample[] = [];

/** Round trip to the server [s], or null before the first answer. */
export const lag = signal<number | null>(null);

/** This browser's own clock [s]. */
export function localNow(): number {
  return performance.now() / 1000;
}

/** The server's clock now [s]. */
export function serverNow(): number {
  const best = samples.reduce<Sample | null>((a, b) => (a === null || b.lag < a.lag ? b : a), null);
  return localNow() + (best?.offset ?? 0);
}

/** Learn from one answered ping; the quickest of the last ten is trusted. */
export function learn(sent: number, server: number): void {
  const received = localNow();
  samples.push({ lag: received - sent, offset: server - (sent + received) / 2 });
  if (samples.length > KEPT) samples.shift();
  lag.value = received - sent;
}

/** Take the server's word before the first ping is answered. */
export function assume(server: number): void {
  samples.length = 0;
  samples.push({ lag: 1, offset: server - localNow() });
}

/** Server time that ticks five times a second, for ages on the screen. */
export const now = signal(0);
setInterval(() => {
  now.value = serverNow();
}, 200);
