// Sounds made of tones: nothing is loaded for them. Browsers allow them only after a press.
import { signal } from "@preact/signals";

/** One tone: frequency [Hz], begin and length [s]. */
type Tone = [number, number, number];

export type Sound = "bell" | "fault";

const DING: Tone[] = [
  [880, 0, 0.5],
  [659, 0.4, 0.9],
];
const BEEPS: Tone[] = [
  [988, 0, 0.14],
  [988, 0.2, 0.14],
  [740, 0.4, 0.3],
];
const TONES: Record<Sound, Tone[]> = {
  bell: [...DING, ...DING.map(([pitch, at, length]): Tone => [pitch, at + 1.8, length])],
  fault: [0, 1.4, 2.8].flatMap((begin) =>
    BEEPS.map(([pitch, at, length]): Tone => [pitch, begin + at, length]),
  ),
};
const LOUD = 0.5;

let audio: AudioContext | null = null;

/** Whether this page may sound now. */
export const canSound = signal(false);

/** Get ready to sound; only in a press. */
export function unlock(): void {
  audio ??= new AudioContext();
  audio.onstatechange = () => (canSound.value = audio?.state === "running");
  canSound.value = audio.state === "running";
  // A machine without loudspeakers may never come to it.
  void audio.resume().catch(() => undefined);
}

/** Sound at once; what could not be heard now is not heard later. */
export function play(sound: Sound): void {
  if (!audio || audio.state !== "running") return;
  for (const tone of TONES[sound]) add(audio, tone);
}

function add(to: AudioContext, [pitch, at, length]: Tone): void {
  const begin = to.currentTime + at;
  const tone = new OscillatorNode(to, { frequency: pitch, type: "triangle" });
  const loudness = new GainNode(to, { gain: 0 });
  loudness.gain.setTargetAtTime(LOUD, begin, 0.01);
  loudness.gain.setTargetAtTime(0, begin + length * 0.6, length * 0.15);
  tone.connect(loudness).connect(to.destination);
  tone.start(begin);
  tone.stop(begin + length + 0.5);
}
