// A soft tone where the picture is shown, when the camera begins and ceases to be recorded.
import { effect } from "@preact/signals";
import { records } from "./board";

const BEGINS = [660, 880];
const ENDS = [880, 660];
const NOTE = 0.18;
const VOLUME = 0.05;
/** A browser that lets a page sound only later sounds nothing late [ms]. */
const LATE = 500;

let context: AudioContext | null = null;

/** Sound from now on; the function that is returned ends it. */
export function soundRecording(): () => void {
  let before = records.peek();
  return effect(() => {
    const now = records.value;
    if (now !== before) void sound(now ? BEGINS : ENDS);
    before = now;
  });
}

async function sound(notes: readonly number[]): Promise<void> {
  const asked = performance.now();
  context ??= new AudioContext();
  const speaker = context;
  await speaker.resume();
  if (performance.now() - asked > LATE) return;
  notes.forEach((frequency, place) => {
    const begins = speaker.currentTime + place * NOTE;
    const loudness = speaker.createGain();
    loudness.gain.setValueAtTime(0, begins);
    loudness.gain.linearRampToValueAtTime(VOLUME, begins + NOTE / 4);
    loudness.gain.linearRampToValueAtTime(0, begins + NOTE);
    const note = speaker.createOscillator();
    note.frequency.value = frequency;
    note.connect(loudness).connect(speaker.destination);
    note.start(begins);
    note.stop(begins + NOTE);
  });
}
