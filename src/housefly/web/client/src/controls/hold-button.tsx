import type { ComponentChildren } from "preact";
import type { Hold } from "../hold";

interface Props {
  hold: Hold;
  class?: string;
  label: string;
  children: ComponentChildren;
}

/** A button that acts when it was held long enough; a bar shows how far the hold is. */
export function HoldButton({ hold, class: kind = "", label, children }: Props) {
  const objection = hold.objection.value;
  return (
    <button
      type="button"
      class={`hold ${kind}`}
      aria-label={label}
      aria-disabled={objection !== ""}
      aria-description={objection || `hold ${hold.seconds} s`}
      title={objection || `${label}: hold ${hold.seconds} s`}
      data-held={hold.held.value}
      style={{ "--hold": `${hold.seconds}s` }}
      onPointerDown={(event) => event.button === 0 && hold.begin()}
      onPointerUp={hold.cancel}
      onPointerLeave={hold.cancel}
      onPointerCancel={hold.cancel}
      onContextMenu={(event) => event.preventDefault()}
      onKeyDown={(event) => event.key === "Enter" && !event.repeat && hold.begin()}
      onKeyUp={(event) => event.key === "Enter" && hold.cancel()}
      onBlur={hold.cancel}
    >
      <span class="fill" aria-hidden="true" />
      <span class="face">{children}</span>
    </button>
  );
}
