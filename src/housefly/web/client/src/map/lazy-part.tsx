// Parts of a screen whose code the first paint does not need: fetched soon after it, or when shown.
import { signal } from "@preact/signals";
import type { ComponentChild } from "preact";
import { useEffect } from "preact/hooks";

const SOON = 1000;
const AGAIN = 1000;

type Part<Props> = (props: Props) => ComponentChild;

/** Return a component that shows a part as soon as its code is there, and nothing before. */
export function lazyPart<Props extends object>(load: () => Promise<Part<Props>>): Part<Props> {
  const loaded = signal<Part<Props> | null>(null);
  let loading = false;
  const fetchCode = async (): Promise<void> => {
    if (loading || loaded.peek()) return;
    loading = true;
    try {
      const found = await load();
      loaded.value = found;
    } catch {
      setTimeout(() => void fetchCode(), AGAIN); // no contact with the server
    }
    loading = false;
  };
  setTimeout(() => void fetchCode(), SOON);
  return function Lazy(props: Props) {
    useEffect(() => void fetchCode(), []);
    const Shown = loaded.value;
    return Shown && <Shown {...props} />;
  };
}
