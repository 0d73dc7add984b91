import type { ComponentChildren } from "preact";
import { t } from "../messages/language";

interface Props {
  go: (words: string) => void;
  class?: string;
  isOff?: boolean;
  /** The field, and what stands beside it. */
  children: ComponentChildren;
}

/** One line to ask in. */
export const AskForm = ({ go, class: kind = "", isOff = false, children }: Props) => (
  <form
    role="search"
    class={kind}
    aria-label={t("Ask")}
    onSubmit={(event) => {
      event.preventDefault();
      go(event.currentTarget.querySelector("input")!.value);
    }}
  >
    {children}
    <button type="submit" class="primary" aria-disabled={isOff}>
      {t("Ask")}
    </button>
  </form>
);
