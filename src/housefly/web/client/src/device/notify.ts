// Sound and notifications for the bell and for faults. Off until a person switches them on; what
// is told is what the page shows.
import { effect, signal, type ReadonlySignal } from "@preact/signals";
import { sentence } from "../format";
import { banner, isConnecting } from "../headline";
import { atTheDoor, bellRings } from "../scene/bell";
import { events } from "../store";
import { canSound, play, unlock, type Sound } from "./sounds";
import { t, translated } from "../messages/language";
import type { Said } from "../wire/messages";

const KEY = "housefly notify";
const PAUSE = 6000;

export const notifies = signal(localStorage.getItem(KEY) === "on");
/** What the browser says of notifications; "none" where it has none. */
export const permission = signal<NotificationPermission | "none">(
  "Notification" in window ? Notification.permission : "none",
);

/** Switch on, in a press: the browser asks the person, and the page may sound from now on. */
export async function switchOn(): Promise<void> {
  notifies.value = true;
  localStorage.setItem(KEY, "on");
  unlock();
  when(canSound, () => play("bell"));
  if (permission.value === "default") permission.value = await Notification.requestPermission();
}

/** Do something once, when a signal is or becomes true. */
function when(signal: ReadonlySignal<boolean>, act: () => void): void {
  const stop = effect(() => {
    if (signal.value) queueMicrotask(() => (stop(), act()));
  });
}

export function switchOff(): void {
  notifies.value = false;
  localStorage.removeItem(KEY);
  void withdraw("bell");
  void withdraw("fault");
}

async function tell(kind: Sound, title: string, words: string): Promise<void> {
  if (!notifies.peek()) return;
  play(kind);
  navigator.vibrate?.(kind === "bell" ? [200, 100, 200] : [400, 150, 400, 150, 400]);
  if (permission.peek() !== "granted" || document.hasFocus()) return;
  const look = { body: words, tag: kind, icon: "/static/icon-192.png", requireInteraction: true };
  const worker = await navigator.serviceWorker?.getRegistration();
  try {
    if (worker) await worker.showNotification(title, look);
    else new Notification(title, look).onclick = () => window.focus();
  } catch {
    // Phones notify by a service worker only, and have none where the certificate is not trusted.
  }
}

/** Take back what is no longer so. */
async function withdraw(kind: Sound): Promise<void> {
  const worker = await navigator.serviceWorker?.getRegistration();
  for (const one of (await worker?.getNotifications({ tag: kind })) ?? []) one.close();
}

let lastFault = 0;
let toldAt = -Infinity;

function tellFault(words: Said): void {
  if (!notifies.peek() || performance.now() - toldAt < PAUSE) return;
  toldAt = performance.now();
  void tell("fault", t("Housefly: look at the drone"), sentence(translated(words)));
}

/** Listen for what is to be told. */
export function notify(): void {
  effect(() => {
    if (bellRings.value) void tell("bell", atTheDoor.peek(), t("The bell rings."));
    else void withdraw("bell");
  });
  let had = false;
  effect(() => {
    // Who has just come sees it on the page.
    if (isConnecting.value) return;
    const words = banner.value;
    if (words && !had) tellFault(words);
    if (!words && had) void withdraw("fault");
    had = words !== "";
  });
  effect(() => {
    const fault = events.value.filter((event) => event.severity === "fault").at(-1);
    const number = fault?.number ?? 0;
    if (fault && number > lastFault && lastFault > 0) tellFault(fault.text);
    lastFault = Math.max(number, events.value.at(-1)?.number ?? 0, lastFault);
  });
  // A page that was opened anew may sound from the first touch on.
  const once = { once: true, capture: true };
  window.addEventListener("pointerdown", () => notifies.value && unlock(), once);
}
