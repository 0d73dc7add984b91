import { useLayoutEffect, useRef } from "preact/hooks";
import { said, unsay } from "../said";
import { tongue } from "../messages/language";

const EDGE = 8;
const GAP = 8;

/** What a button has to say, beside it; never over STOP. */
export function SaidBubble() {
  const box = useRef<HTMLDivElement>(null);
  const now = said.value;
  useLayoutEffect(() => {
    const place = (): void => box.current && now ? put(box.current, now.anchor) : undefined;
    place();
    window.addEventListener("resize", place);
    return () => window.removeEventListener("resize", place);
  }, [now]);
  if (!now) return null;
  return (
    <div class="said" ref={box} role="alert" data-stays={now.stays}>
      <p lang={tongue(now.words)}>
        {now.stays && "△ "}
        {now.words}
      </p>
      {now.stays && (
        <button type="button" onClick={unsay}>
          OK
        </button>
      )}
    </div>
  );
}

/** The button itself, or the one that stands now where it was held. */
function stillThere(anchor: Element | null): Element | null {
  if (!anchor || anchor.isConnected) return anchor;
  return anchor.matches(".primary") ? document.querySelector(".acts > :first-child") : null;
}

function put(box: HTMLElement, anchor: Element | null): void {
  const bar = document.querySelector(".stopbar")?.getBoundingClientRect().top ?? innerHeight;
  const lowest = bar - GAP - box.offsetHeight;
  const at = stillThere(anchor)?.getBoundingClientRect() ?? null;
  const middle = at && at.width ? at.left + at.width / 2 : innerWidth / 2;
  const left = middle - box.offsetWidth / 2;
  const above = at && at.width ? at.top - GAP - box.offsetHeight : lowest;
  const top = above >= EDGE ? above : (at?.bottom ?? 0) + GAP;
  box.style.left = `${Math.max(EDGE, Math.min(innerWidth - EDGE - box.offsetWidth, left))}px`;
  box.style.top = `${Math.max(EDGE, Math.min(lowest, top))}px`;
}
