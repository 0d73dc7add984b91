// Screens whose code is fetched apart from the first: when there is time, or when opened.
import type { ComponentChild } from "preact";
import { lazyPart } from "./lazy-part";
import { t } from "./messages/language";

/** Return a component that shows a screen as soon as its code is there. */
export const lazyScreen = (
  load: () => Promise<() => ComponentChild>,
  isRare = false,
): (() => ComponentChild) => {
  const Screen = lazyPart(
    load,
    (failed) => (
      <main class="loading quiet">{failed ? t("No contact with the server.") : "…"}</main>
    ),
    isRare,
  );
  return () => <Screen />;
};
