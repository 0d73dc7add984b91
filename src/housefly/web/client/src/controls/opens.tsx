import type { ComponentChildren } from "preact";
import { panel, toggle, type Panel } from "../store";

interface Props {
  name: Panel;
  class: string;
  /** What a picture on it says. */
  label?: string;
  children: ComponentChildren;
}

/** Opens a panel, and closes it again. */
export const Opens = ({ name, class: kind, label, children }: Props) => (
  <button
    type="button"
    class={kind}
    {...(label && { "aria-label": label })}
    aria-expanded={panel.value === name}
    onClick={() => toggle(name)}
  >
    {children}
  </button>
);
