import { effect, signal } from "@preact/signals";
import { sentence } from "../format";
import { hint } from "../said";
import { contact } from "../store";
import { bell, pressBell } from "./tasks-client";
import { t, translated } from "../messages/language";

const simulated = signal(false);
const pressing = signal(false);
const words = signal("");

effect(() => {
  if (contact.value === "open")
    bell()
      .then((one) => (simulated.value = one.simulated))
      .catch(() => undefined);
});

async function press(): Promise<void> {
  if (pressing.value) return;
  pressing.value = true;
  words.value = "";
  try {
    const { rung, words: told } = await pressBell();
    words.value = rung ? told : `△ ${told}`;
  } catch (error) {
    words.value = `△ ${(error as Error).message}`;
  }
  pressing.value = false;
}

/** The bell of a simulated room: somebody comes and rings; what the house does is told beside. */
export function Bell() {
  if (!simulated.value) return null;
  return (
    <section class="card bell" aria-label={t("Simulated doorbell")}>
      <button type="button" aria-disabled={pressing.value} onClick={() => void press()}>
        <BellIcon />
        {t("Ring the doorbell")}
      </button>
      <p role="status">
        {pressing.value
          ? "…"
          : words.value
            ? sentence(translated(words.value))
            : t("This room is simulated: press, and a visitor comes to the door.")}
      </p>
    </section>
  );
}

/** The same as one button beside STOP; what the house does is said above it. */
export function RingButton() {
  const ring = async (from: Element): Promise<void> => {
    await press();
    hint(sentence(translated(words.value)), from);
  };
  if (!simulated.value) return null;
  return (
    <button
      type="button"
      class="ring"
      title={t("This room is simulated: press, and a visitor comes to the door.")}
      aria-disabled={pressing.value}
      onClick={(event) => void ring(event.currentTarget)}
    >
      <BellIcon />
      <span>{t("Ring the doorbell")}</span>
    </button>
  );
}

function BellIcon() {
  return (
    <svg viewBox="0 0 24 24" width="22" height="22" aria-hidden="true">
      <path
        fill="currentColor"
        d="M12 2a2 2 0 0 1 2 2v.4a6 6 0 0 1 4 5.6v5l2 3H4l2-3v-5a6 6 0 0 1 4-5.6V4a2 2 0 0 1 2-2z"
      />
      <path fill="currentColor" d="M9.5 19.5h5a2.5 2.5 0 0 1-5 0z" />
    </svg>
  );
}
