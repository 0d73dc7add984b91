import { computed } from "@preact/signals";
import { board, running, unixNow } from "../tasks/board";
import { PhotoButton, PhotoKept } from "./photo";
import { t } from "../messages/language";

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

/** What can be kept of this picture, and what was kept of it, one press away. */
export function PictureClip() {
  return (
    <>
      <div class="on-picture">
        <PhotoButton />
        {clip.value && (
          <a class="button" href={`#clip/${clip.value}`}>
            ▣ {t("Clip")}
          </a>
        )}
      </div>
      <PhotoKept />
    </>
  );
}
