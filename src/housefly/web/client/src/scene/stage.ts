// The picture takes the stage by itself while the drone looks and at a bell, and gives it back. An
// answer that lay over the map would lie over a face, and is of before.
import { computed, effect } from "@preact/signals";
import { lineLives, link, swapped, verdict } from "../store";
import { unask } from "./asked-words";
import { bellRings } from "./bell";

const looks = computed(
  () =>
    lineLives.value &&
    link.value?.link.video_connected === true &&
    (verdict.value?.is_showing === true || bellRings.value),
);

let before: boolean | null = null;

effect(() => {
  const wanted = looks.value;
  if (wanted && before === null) {
    before = swapped.peek();
    swapped.value = true;
    unask();
  } else if (!wanted && before !== null) {
    // Whoever has made the map large again meanwhile keeps it so.
    if (swapped.peek()) swapped.value = before;
    before = null;
  }
});
