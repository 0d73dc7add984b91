// The console as an app of this device: its shell is kept, and the browser may offer to install it.
import { signal } from "@preact/signals";

interface InstallOffer extends Event {
  prompt(): Promise<void>;
}

const offer = signal<InstallOffer | null>(null);
const standalone = matchMedia("(display-mode: standalone)").matches;
const isApple = /iPhone|iPad/.test(navigator.userAgent);

/** How this device comes to have the console as an app; "" when it has it, or cannot. */
export function installing(): "" | "offered" | "by hand" {
  if (standalone) return "";
  return offer.value ? "offered" : isApple ? "by hand" : "";
}

export async function install(): Promise<void> {
  const asked = offer.value;
  offer.value = null;
  await asked?.prompt();
}

/** Keep the shell. Not on loopback: its ports belong to whichever program runs there today. */
export function keepShell(): void {
  window.addEventListener("beforeinstallprompt", (event) => {
    event.preventDefault();
    offer.value = event as InstallOffer;
  });
  if (location.protocol !== "https:") return;
  // Without the authority's certificate on this device browsers refuse; the page works without it.
  navigator.serviceWorker
    ?.register("/service-worker.js", { updateViaCache: "none" })
    .catch(() => undefined);
}
