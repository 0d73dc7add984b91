// Small drawings, all in a 24 x 24 field and in the colour of the text around them.
import type { ComponentChildren } from "preact";
import type { Shape } from "../headline";

function Icon({ children }: { children: ComponentChildren }) {
  return (
    <svg class="icon" viewBox="0 0 24 24" width="20" height="20" aria-hidden="true">
      {children}
    </svg>
  );
}

/** Drawn as a line of the colour of the text around it. */
const stroke = { class: "stroke" };

const OCTAGON = "M8 2h8l6 6v8l-6 6H8l-6-6V8z";

/** An icon of one stroked path. */
const outline = (d: string) => () => <Icon><path d={d} {...stroke} /></Icon>;

export const TakeOffIcon = outline("M12 16V4M7 9l5-5 5 5M5 20h14");
export const LandIcon = outline("M12 4v12M7 11l5 5 5-5M5 20h14");
export const HomeIcon = outline("M4 11l8-7 8 7v9H4zM10 20v-6h4v6");
export const ResumeIcon = outline("M7 5l12 7-12 7z");
export const ResetIcon = outline("M5 12a7 7 0 1 0 2-5M5 4v4h4");
export const SwapIcon = outline("M4 9h14l-4-4M20 15H6l4 4");
export const MoreIcon = outline("M5 12h.01M12 12h.01M19 12h.01");
export const AskIcon = outline("M16 16l5 5M10.5 4a6.5 6.5 0 1 0 0 13a6.5 6.5 0 1 0 0-13z");
export const PlaceIcon = outline("M12 21s-7-6.5-7-11a7 7 0 0 1 14 0c0 4.500-7 11-7 11zM12 10h.01");
export const BatteryIcon = outline("M3 8h15v8H3zM21 11v2M6 12h5");
export const ListIcon = outline("M5 6h14M5 12h14M5 18h9");
export const CutIcon = outline("M13 3L6 13h6l-1 8 7-11h-6z");
export const StopIcon = () => <Icon><path d={OCTAGON} fill="currentColor" /></Icon>;
export const HoverIcon = () => (
  <Icon>
    <path d="M12 7v10M7 12h10" {...stroke} />
    <circle cx="12" cy="12" r="9" {...stroke} />
  </Icon>
);

const SHAPES: Record<Shape, ComponentChildren> = {
  ready: <circle cx="12" cy="12" r="8" {...stroke} />,
  moving: <path d="M12 3l8 17-8-4-8 4z" fill="currentColor" />,
  holding: (
    <>
      <circle cx="12" cy="12" r="8" {...stroke} />
      <circle cx="12" cy="12" r="3.5" fill="currentColor" />
    </>
  ),
  stopped: <path d={OCTAGON} fill="currentColor" />,
  warning: (
    <>
      <path d="M12 3l10 18H2z" {...stroke} />
      <path d="M12 10v5M12 18v.01" {...stroke} />
    </>
  ),
  lost: <path d="M5 5l14 14M19 5L5 19" {...stroke} />,
};

export const ShapeIcon = ({ shape }: { shape: Shape }) => <Icon>{SHAPES[shape]}</Icon>;
