// Screens whose code is fetched apart from the first: when there is time, or when opened.
import { signal } from "@preact/signals";
import type { ComponentChild } from "preact";
import { useEffect } from "preact/hooks";
import { t } from "./messages/language";

const SOON = 1500;
const AGAIN = 1000;

type Component = () => ComponentChild;

/** Return a component that shows a screen as soon as its code is there, and tries until it is. */
export function lazyScreen(load: () => Promise<Component>): Component {
  const loaded = signal<Component | null>(null);
  const failed = signal(false);
  let loading = false;
  const fetchCode = async (): Promise<void> => {
    if (loading || loaded.peek()) return;
    loading = true;
    try {
      const found = await load();
      loaded.value = found;
      failed.value = false;
    } catch {
      // No contact with the server; a module that did not load may be asked for again.
      failed.value = true;
      setTimeout(() => void fetchCode(), AGAIN);
    }
    loading = false;
  };
  setTimeout(() => void fetchCode(), SOON);
  return function Lazy() {
    useEffect(() => void fetchCode(), []);
    const Shown = loaded.value;
    if (Shown) return <Shown />;
    return (
      <main class="loading quiet">{failed.value ? t("No contact with the server.") : "…"}</main>
    );
  };
}
