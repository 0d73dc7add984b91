import { computed } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { SwapIcon } from "../controls/icons";
import { RecordedPicture } from "../replay/recorded";
import { replaying } from "../replay/replay";
import { PictureClip } from "../scene/picture-clip";
import { freshness, swapped } from "../store";
import { board } from "../tasks/board";
import { soundRecording } from "../tasks/recording-tone";
import { now } from "../wire/clock";
import { proof } from "../wire/session";
import { decodesVideo, picture, watch } from "../wire/video";
import { milliseconds } from "../format";
import { t } from "../messages/language";

/** Whether the mode of the house lets nobody see the picture. */
const isPrivate = computed(() => board.value?.mode === "privacy");

/** The drone's picture. */
export function VideoView() {
  useEffect(soundRecording, []);
  if (replaying.value) return <RecordedPicture />;
  return decodesVideo ? <LiveVideo /> : <JpegVideo />;
}

function JpegVideo() {
  return (
    <section
      class="view video"
      aria-label={t("Picture from the drone")}
      data-private={isPrivate.value || undefined}
    >
      <img src={`/video.mjpeg?proof=${proof()}`} alt={t("Picture from the drone")} />
      <p class="veil">{isPrivate.value && t("Privacy")}</p>
      <PictureClip />
      <SwapButton to="picture" />
    </section>
  );
}

/** Time since the picture on the screen was taken [s], counted when it is no longer new. */
const age = computed(() => {
  if (!picture.value) return Infinity;
  const age = now.value - picture.value.receivedAt;
  return freshness(age) === "fresh" ? 0 : age;
});

function LiveVideo() {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => watch(canvas.current!), []);
  return (
    <section
      class="view video"
      aria-label={t("Picture from the drone")}
      data-age={freshness(age.value)}
      data-private={isPrivate.value || undefined}
    >
      <canvas ref={canvas} width={640} height={360} />
      <p class="veil">{veil(age.value)}</p>
      <PictureClip />
      <SwapButton to="picture" />
    </section>
  );
}

function veil(age: number): string {
  if (isPrivate.value) return t("Privacy");
  if (!Number.isFinite(age)) return t("No picture yet");
  if (freshness(age) !== "dead") return "";
  return t("No new picture for {time}", { time: milliseconds(age) });
}

const LARGE = {
  map: "Make the map large, or small again",
  picture: "Make the picture large, or small again",
} as const;

/** Makes the small view large. */
export function SwapButton({ to }: { to: "map" | "picture" }) {
  return (
    <button
      type="button"
      class="swap"
      aria-label={t(LARGE[to])}
      title={t("Swap (M)")}
      onClick={() => (swapped.value = !swapped.value)}
    >
      <SwapIcon />
    </button>
  );
}
