// Decodes and draws the drone's pictures beside the page: whatever the page does, they go on, and
// whatever they cost, a press of STOP does not wait for them.
import { wallClock } from "./wall-clock";
import type { Picture } from "./video";

/** What the page hands over once. */
export interface VideoStart {
  canvas: OffscreenCanvas;
  address: string;
  protocols: string[];
}

/** A picture that was drawn; its time is the page's wall clock [ms]. */
export interface DrawnPicture extends Omit<Picture, "latency"> {
  drawnAt: number;
}

interface Message {
  about: Omit<DrawnPicture, "drawnAt">;
  keyframe: boolean;
  data: Uint8Array;
}

const HEADER = 24;
const KEY_FRAME = 1;
const DECODING_MAX = 3;
const MICRO = 1e6;
const AGAIN = 1000;
/** How often the page is told of the pictures that were drawn [ms]: its words need no more. */
const TOLD = 100;

function parse(buffer: ArrayBuffer): Message {
  const view = new DataView(buffer);
  return {
    keyframe: (view.getUint8(1) & KEY_FRAME) !== 0,
    about: {
      width: view.getUint16(2, true),
      height: view.getUint16(4, true),
      number: Number(view.getBigUint64(8, true)),
      receivedAt: view.getFloat64(16, true),
    },
    data: new Uint8Array(buffer, HEADER),
  };
}

/** The codec string from profile, constraints and level in a key frame's parameter set. */
function codecOf(data: Uint8Array): string | null {
  for (let i = 0; i + 6 < data.length; i++) {
    if (data[i] === 0 && data[i + 1] === 0 && data[i + 2] === 1 && (data[i + 3]! & 0x1f) === 7) {
      const parts = [data[i + 4]!, data[i + 5]!, data[i + 6]!];
      return `avc1.${parts.map((part) => part.toString(16).padStart(2, "0")).join("")}`;
    }
  }
  return null;
}

/** Show the drone's pictures on a canvas for as long as this worker lives. */
function show({ canvas, address, protocols }: VideoStart): void {
  const screen = canvas.getContext("2d", { alpha: false })!;
  const decoded = new Map<number, Message["about"]>();
  let decoder: VideoDecoder | null = null;
  let codec: string | null = null;
  let socket: WebSocket | null = null;
  let owed = 0;
  let toldAt = -Infinity;

  const draw = (frame: VideoFrame): void => {
    if (canvas.width !== frame.displayWidth || canvas.height !== frame.displayHeight) {
      canvas.width = frame.displayWidth;
      canvas.height = frame.displayHeight;
    }
    screen.drawImage(frame, 0, 0);
    const about = decoded.get(frame.timestamp);
    decoded.delete(frame.timestamp);
    frame.close();
    const drawnAt = wallClock();
    if (!about || drawnAt - toldAt < TOLD) return;
    toldAt = drawnAt;
    postMessage({ ...about, drawnAt } satisfies DrawnPicture);
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
    decoded.clear();
    answer();
  };

  const receive = ({ keyframe, about, data }: Message): void => {
    owed += 1;
    if (keyframe) {
      const found = codecOf(data);
      if (found && (found !== codec || !decoder)) {
        restart();
        codec = found;
        decoder = new VideoDecoder({ output: draw, error: restart });
        decoder.ondequeue = answer;
        decoder.configure({ codec, optimizeForLatency: true });
      }
    }
    if (decoder?.state === "configured") {
      const timestamp = Math.round(about.receivedAt * MICRO);
      decoded.set(timestamp, about);
      const type = keyframe ? "key" : "delta";
      decoder.decode(new EncodedVideoChunk({ type, timestamp, data }));
    }
    answer();
  };

  const connect = (): void => {
    socket = new WebSocket(address, protocols);
    socket.binaryType = "arraybuffer";
    socket.onmessage = (event: MessageEvent<ArrayBuffer>) => receive(parse(event.data));
    socket.onclose = () => {
      owed = 0;
      restart();
      setTimeout(connect, AGAIN);
    };
  };
  connect();
}

self.onmessage = (event: MessageEvent<VideoStart>) => show(event.data);
