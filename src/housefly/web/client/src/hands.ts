// What hands do to a box, heard before anything in it hears them.

type Heard = { [Name in keyof HTMLElementEventMap]?: (event: HTMLElementEventMap[Name]) => void };

/** Listen until the returned function is called. */
export function listen(box: EventTarget, heard: Heard): () => void {
  const off = new AbortController();
  const how = { capture: true, passive: false, signal: off.signal };
  for (const [name, hear] of Object.entries(heard))
    box.addEventListener(name, hear as (event: Event) => void, how);
  return () => off.abort();
}
