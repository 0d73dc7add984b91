import { computed, signal } from "@preact/signals";
import { sentence } from "../format";
import type { Key } from "../messages/en";
import { board, running } from "../tasks/board";
import { clipAddress, takePhoto } from "../tasks/tasks-client";
import { picture } from "../wire/video";
import type { ClipInfo } from "../wire/task-messages";
import { language, t, translated } from "../messages/language";

const NOBODY_KEEPS: Key = "No services run here, and only they keep pictures: nothing was kept.";

/** What became of the last press. */
type Photo = { clip: ClipInfo } | { trouble: string };

const photo = signal<Photo | null>(null);
const busy = signal(false);

// Why nothing was kept is of the mode that was.
computed(() => board.value?.mode).subscribe(() => (photo.value = null));

/** Keep the picture that is on the screen now, not the one that comes while this is sent. */
async function snap(): Promise<void> {
  if (busy.value) return;
  if (!running.value) {
    photo.value = { trouble: t(NOBODY_KEEPS) };
    return;
  }
  busy.value = true;
  const at = picture.value?.receivedAt ?? 0;
  try {
    const { clips } = await takePhoto(at);
    photo.value = clips[0] ? { clip: clips[0] } : { trouble: t("Nothing was kept.") };
  } catch (error) {
    photo.value = { trouble: sentence(translated((error as Error).message)) };
  }
  busy.value = false;
}

export function PhotoButton() {
  return (
    <button
      type="button"
      aria-disabled={busy.value}
      title={t("Keep this picture as a photo")}
      onClick={() => void snap()}
    >
      ◉ {t("Snap")}
    </button>
  );
}

const day = (unix: number): string =>
  new Date(1000 * unix).toLocaleDateString(language.value, { dateStyle: "medium" });

/** That a photo was kept, where it is, and how to take it along; or why none was. */
export function PhotoKept() {
  const made = photo.value;
  if (!made) return null;
  return (
    <div class="photo-kept" role="status">
      {"clip" in made ? <Kept clip={made.clip} /> : <p>△ {made.trouble}</p>}
      <button type="button" aria-label={t("Close")} onClick={() => (photo.value = null)}>
        ✕
      </button>
    </div>
  );
}

function Kept({ clip }: { clip: ClipInfo }) {
  const where =
    clip.keep_until === null
      ? t("in Tasks, Clips.")
      : t("in Tasks, Clips, until {date}.", { date: day(clip.keep_until) });
  return (
    <>
      <p>
        <strong>{t("Photo kept")}</strong>
        <span class="where">
          {" "}
          {where}
        </span>
      </p>
      <a class="button" href={clipAddress(clip.id, "&download=1")} download>
        {t("Save")}
      </a>
      <a class="button show" href={`#clip/${clip.id}`}>
        {t("Show")}
      </a>
    </>
  );
}
