// What a phone has beside the live scene: a stage that is swiped, and a sheet from below.
import { useEffect, useRef } from "preact/hooks";
import { hasDrone, swapped } from "../store";
import { BottomSheet } from "./bottom-sheet";
import { listenToSwipes, show } from "./swipe";
import { t } from "../messages/language";

const VIEWS = [
  ["Map", false],
  ["Picture", true],
] as const;

export const OnPhone = () => (
  <>
    {hasDrone.value && <StageSwitch />}
    <BottomSheet />
  </>
);

/** Which of the two has the stage; a swipe does the same. */
function StageSwitch() {
  const box = useRef<HTMLDivElement>(null);
  useEffect(() => listenToSwipes(box.current!.parentElement!), []);
  return (
    <div ref={box} class="stage-switch" role="group" aria-label={t("On the stage")}>
      {VIEWS.map(([name, isPicture]) => (
        <button
          type="button"
          key={name}
          aria-pressed={swapped.value === isPicture}
          onClick={() => show(isPicture)}
        >
          {t(name)}
        </button>
      ))}
    </div>
  );
}
