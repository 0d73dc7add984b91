import { computed } from "@preact/signals";
import { board, running, unixNow } from "../tasks/board";

/** For how long a clip is offered on the picture after its task [s]. */
const OFFERED = 300;

/** The newest clip of the task that flies or has just flown, or "". */
const clip = computed(() => {
  if (!running.value) return "";
  const lately = (board.value?.ended ?? []).filter(
    (one) => unixNow.value - (one.ended_at ?? 0) < OFFERED,
  );
  const tasks = [...(board.value?.tasks ?? []), ...lately];
  return tasks.find((one) => one.clips.length > 0)?.clips.at(-1) ?? "";
});

/** What was kept of this picture, one press away. */
export function PictureClip() {
  if (!clip.value) return null;
  return (
    <a class="button on-picture" href={`#clip/${clip.value}`}>
      ▣ Clip
    </a>
  );
}
