// Live pictures: H.264 over a WebSocket, decoded by WebCodecs, drawn on a canvas. Every picture is
// acknowledged with one byte, late when the decoder is behind, so that the server skips to a key
// frame instead of letting the picture lag.
import { signal } from "@preact/signals";
import { serverNow } from "./clock";
import { openSocket } from "./open-socket";

const HEADER = 24;
const KEY_FRAME = 1;
const DECODING_MAX = 3;
const MICRO = 1e6;

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
export const decodesVideo = "VideoDecoder" in window;

interface Message extends Picture {
  keyframe: boolean;
  data: Uint8Array;
}

function parse(buffer: ArrayBuffer): Message {
  const view = new DataView(buffer);
  return {
    keyframe: (view.getUint8(1) & KEY_FRAME) !== 0,
    width: view.getUint16(2, true),
    height: view.getUint16(4, true),
    number: Number(view.getBigUint64(8, true)),
    receivedAt: view.getFloat64(16, true),
    latency: 0,
    data: new Uint8Array(buffer, HEADER),
  };
}

/** The codec string from profile, constraints and level in a key frame's parameter set. */
export function codecOf(data: Uint8Array): string | null {
  for (let i = 0; i + 6 < data.length; i++) {
    if (data[i] === 0 && data[i + 1] === 0 && data[i + 2] === 1 && (data[i + 3]! & 0x1f) === 7) {
      const parts = [data[i + 4]!, data[i + 5]!, data[i + 6]!];
      return `avc1.${parts.map((part) => part.toString(16).padStart(2, "0")).join("")}`;
    }
  }
  return null;
}

/** Show the drone's pictures on a canvas; returns a function that stops it. */
export function watch(canvas: HTMLCanvasElement): () => void {
  const screen = canvas.getContext("2d", { alpha: false })!;
  const shown = new Map<number, Picture>();
  let decoder: VideoDecoder | null = null;
  let codec: string | null = null;
  let socket: WebSocket | null = null;
  let over = false;
  let owed = 0;

  const draw = (frame: VideoFrame): void => {
    if (canvas.width !== frame.displayWidth || canvas.height !== frame.displayHeight) {
      canvas.width = frame.displayWidth;
      canvas.height = frame.displayHeight;
    }
    screen.drawImage(frame, 0, 0);
    const about = shown.get(frame.timestamp);
    shown.delete(frame.timestamp);
    frame.close();
    if (about) {
      const latency = Math.max(0, serverNow() - about.receivedAt);
      picture.value = { ...about, latency };
      canvas.dataset.picture = String(about.number);
      canvas.dataset.latency = latency.toFixed(4);
    }
  };

  const answer = (): void => {
    const behind = decoder?.state === "configured" && decoder.decodeQueueSize > DECODING_MAX;
    while (owed > 0 && !behind) {
      if (socket?.readyState === WebSocket.OPEN) socket.send("1");
      owed -= 1;
    }
  };

  const restart = (): void => {
    if (decoder && decoder.state !== "closed") decoder.close();
    decoder = null;
    shown.clear();
    answer();
  };

  const receive = (message: Message): void => {
    owed += 1;
    if (message.keyframe) {
      const found = codecOf(message.data);
      if (found && (found !== codec || !decoder)) {
        restart();
        codec = found;
        decoder = new VideoDecoder({ output: draw, error: restart });
        decoder.ondequeue = answer;
        decoder.configure({ codec, optimizeForLatency: true });
      }
    }
    if (decoder?.state === "configured") {
      const timestamp = Math.round(message.receivedAt * MICRO);
      shown.set(timestamp, message);
      decoder.decode(
        new EncodedVideoChunk({
          type: message.keyframe ? "key" : "delta",
          timestamp,
          data: message.data,
        }),
      );
    }
    answer();
  };

  const connect = (): void => {
    socket = openSocket("/video");
    socket.binaryType = "arraybuffer";
    socket.onmessage = (event: MessageEvent<ArrayBuffer>) => receive(parse(event.data));
    socket.onclose = () => {
      owed = 0;
      restart();
      if (!over) setTimeout(connect, 1000);
    };
  };

  connect();
  return () => {
    over = true;
    socket?.close();
    restart();
  };
}
