// Whether somebody is at the door: by the room's events, or by a task that asks because of it.
import { computed, effect, signal } from "@preact/signals";
import { events, hubNow } from "../live/store";
import { room, state } from "../store";
import { asked } from "../tasks/board";
import { language, t } from "../messages/language";

/** Who rang waits about as long [s]. */
const WAITS = 60;

/** Rings that were looked at or ignored, by their time [s]. */
const answered = signal(0);

const ring = computed(() => {
  const last = events.value.filter((one) => one.kind === "bell pressed").at(-1);
  return last && last.at > answered.value && hubNow.value - last.at < WAITS ? last : null;
});
const asks = computed(() =>
  asked.value.some(({ task }) => /bell/.test(task.cause) || task.service === "visitor"),
);

/** Whether a bell rings that nobody has answered. */
export const bellRings = computed(() => ring.value !== null || asks.value);
/** Whether it needs a card of its own: no task asks about it, and nothing flies. */
export const bellAsks = computed(
  () => ring.value !== null && !asks.value && state.value?.phase === "idle",
);
/** Where a visitor stands. */
export const door = computed(() => {
  const places = (room.value?.places ?? []).filter((one) => one.name !== "home");
  return places.find((one) => /entrance|door/i.test(one.name + one.title)) ?? places[0] ?? null;
});
export const atTheDoor = computed(() => {
  const title = door.value?.title ?? t("door");
  return t("Someone at the {place}", {
    place: language.value === "en" ? title.toLowerCase() : title,
  });
});

export function answerBell(): void {
  answered.value = ring.peek()?.at ?? 0;
}

effect(() => {
  document.title = bellRings.value ? `● ${atTheDoor.value} · Housefly` : "Housefly";
});
