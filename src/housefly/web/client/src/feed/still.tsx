import { useState } from "preact/hooks";
import { stillAddress } from "../tasks/tasks-client";

const CALM = matchMedia("(prefers-reduced-motion: reduce)");

/** Play the film in an element, or show its beginning again. */
function turn(plays: boolean): (event: { currentTarget: Element }) => void {
  return ({ currentTarget }) => {
    const film = currentTarget.querySelector("video");
    if (!film || (plays && CALM.matches)) return;
    if (plays) void film.play().catch(() => undefined);
    else {
      film.pause();
      film.currentTime = 0;
    }
  };
}

/** For whatever holds a still: its film plays while somebody points at it. */
export const PLAYS = {
  onPointerEnter: turn(true),
  onPointerLeave: turn(false),
  onFocus: turn(true),
  onBlur: turn(false),
};

/** The small picture of a clip or snapshot; nothing where its file is gone. */
export function Still({ id, isPhoto = false }: { id: string; isPhoto?: boolean }) {
  // Of a clip only the id may be known: what is no film may be a photo.
  const [tried, tryNext] = useState(Number(isPhoto));
  const next = (): void => tryNext(tried + 1);
  const src = stillAddress(id);
  if (tried === 0)
    return <video src={src} muted loop playsInline preload="metadata" onError={next} />;
  return tried === 1 ? <img src={src} alt="" loading="lazy" onError={next} /> : null;
}
