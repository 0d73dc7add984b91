import { hasDrone, panel, toggle } from "../store";
import { RingButton } from "./ring";
import { running } from "../tasks/board";
import { ideas } from "../tasks/ideas";
import { Chips } from "../tasks/sentence-answer";
import { t } from "../messages/language";
import { askFor } from "./asked-words";
import { ordering } from "./dock";

const IDEAS = 4;

/** Beside STOP: where to fly, what one may ask with one tap, and the bell of a simulated room. */
export function Quick() {
  return (
    <div class="quick">
      {hasDrone.value && (
        <button
          type="button"
          class="to-fly"
          aria-expanded={panel.value === "fly"}
          onClick={() => toggle("fly")}
        >
          {t("Fly to …")}
        </button>
      )}
      <RingButton />
      {running.value && !ordering.value && (
        <Chips words={ideas().slice(0, IDEAS)} go={(words) => void askFor(words)} />
      )}
    </div>
  );
}
