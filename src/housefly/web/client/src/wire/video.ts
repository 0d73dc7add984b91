// Live pictures: H.264 over a WebSocket, decoded by WebCodecs and drawn on a canvas by a worker.
// Every picture is acknowledged with one byte, late when the decoder is behind, so that the server
// skips to a key frame instead of letting the picture lag.
import { signal } from "@preact/signals";
import { serverNow } from "./clock";
import { socketAddress } from "./open-socket";
import type { DrawnPicture, VideoStart } from "./video-worker";
import { wallClock } from "./wall-clock";

const WORKER = "/static/video-worker.js";

export interface Picture {
  number: number;
  receivedAt: number;
  /** From the pilot's receipt to the screen [s]. */
  latency: number;
  width: number;
  height: number;
}

/** The newest picture on the screen, or null before the first. */
export const picture = signal<Picture | null>(null);
/** WebCodecs needs a secure address, such as loopback; elsewhere the server sends JPEG pictures. */
export const decodesVideo =
  "VideoDecoder" in window && "transferControlToOffscreen" in HTMLCanvasElement.prototype;

/** Show the drone's pictures on a canvas; returns a function that stops it. */
export function watch(canvas: HTMLCanvasElement): () => void {
  const worker = new Worker(WORKER);
  worker.onmessage = (event: MessageEvent<DrawnPicture>) => {
    const { drawnAt, ...about } = event.data;
    const waited = (wallClock() - drawnAt) / 1000;
    const latency = Math.max(0, serverNow() - waited - about.receivedAt);
    picture.value = { ...about, latency };
    canvas.dataset.picture = String(about.number);
    canvas.dataset.latency = latency.toFixed(4);
  };
  const [address, protocols] = socketAddress("/video");
  const drawn = canvas.transferControlToOffscreen();
  worker.postMessage({ canvas: drawn, address, protocols } satisfies VideoStart, [drawn]);
  return () => worker.terminate();
}
