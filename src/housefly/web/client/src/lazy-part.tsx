// Parts whose code the first paint does not need: fetched soon after it, or when they are shown.
import { signal } from "@preact/signals";
import type { ComponentChild } from "preact";
import { useEffect } from "preact/hooks";

const SOON = 1000;
const AGAIN = 1000;

type Part<Props> = (props: Props) => ComponentChild;

/**
 * Return a component that shows a part as soon as its code is there, and tries until it is.
 * Before that it shows what `waiting` says, if anything. Its code is fetched soon after the first
 * paint, or, for what few people open, only when it is shown.
 */
export function lazyPart<Props extends object>(
  load: () => Promise<Part<Props>>,
  waiting: (failed: boolean) => ComponentChild = () => null,
  isRare = false,
): Part<Props> {
  const loaded = signal<Part<Props> | null>(null);
  const failed = signal(false);
  let loading = false;
  const fetchCode = async (): Promise<void> => {
    if (loading || loaded.peek()) return;
    loading = true;
    try {
      const found = await load();
      loaded.value = found;
    } catch {
      // No contact with the server; a module that did not load may be asked for again.
      failed.value = true;
      setTimeout(() => void fetchCode(), AGAIN);
    }
    loading = false;
  };
  if (!isRare) setTimeout(() => void fetchCode(), SOON);
  return function Lazy(props: Props) {
    useEffect(() => void fetchCode(), []);
    const Shown = loaded.value;
    return Shown ? <Shown {...props} /> : waiting(failed.value);
  };
}
