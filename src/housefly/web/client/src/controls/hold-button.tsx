import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import type { Hold } from "../hold";
import { flying } from "../store";
import { hint } from "../said";
import { t } from "../messages/language";

interface Props {
  hold: Hold;
  class?: string;
  label: string;
  children: ComponentChildren;
}

/**
 * A button that acts when it was held long enough; a bar shows how far the hold is. Its name is
 * what stands on it; `label` tells more.
 */
export function HoldButton({ hold, class: kind = "", label, children }: Props) {
  const objection = hold.objection.value;
  const told = objection || t("{label}: hold {n} s", { label, n: hold.seconds });
  const button = useRef<HTMLButtonElement>(null);
  useEffect(() => {
    hold.button = button.current;
    const own = button.current;
    return () => {
      // Another button of the same order may stand already where this one was.
      if (hold.button !== own) return;
      hold.stop();
      hold.button = null;
    };
  }, [hold]);
  return (
    <button
      type="button"
      ref={button}
      class={`hold ${kind}`}
      aria-disabled={objection !== ""}
      aria-description={told}
      title={told}
      data-held={hold.held.value}
      style={{ "--hold": `${hold.seconds}s` }}
      onPointerDown={(event) => {
        hold.button = button.current;
        if (event.button === 0) hold.begin();
      }}
      onPointerUp={hold.cancel}
      onPointerLeave={hold.cancel}
      onPointerCancel={hold.cancel}
      onContextMenu={(event) => event.preventDefault()}
      onKeyDown={(event) => event.key === "Enter" && !event.repeat && hold.begin()}
      onKeyUp={(event) => {
        if (event.key === "Enter") hold.cancel();
        // In flight Space is STOP, wherever the focus is.
        else if (event.key === " " && !flying.value) hint(t("Hold Enter."), button.current);
      }}
      onBlur={hold.cancel}
    >
      <span class="fill" aria-hidden="true" />
      <span class="face">{children}</span>
    </button>
  );
}
