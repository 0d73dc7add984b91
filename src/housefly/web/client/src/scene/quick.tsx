import { Opens } from "../controls/opens";
import { hasDrone } from "../store";
import { asked, running } from "../tasks/board";
import { ideas } from "../tasks/ideas";
import { Chips } from "../tasks/sentence-answer";
import { t } from "../messages/language";
import { askFor } from "./asked-words";
import { ordering } from "./dock";
import { isPhone } from "./phone";
import { RingButton } from "./ring";

const IDEAS = 4;

/** Beside STOP: where to fly, what one may ask with one tap, and the bell of a simulated room. */
export function Quick() {
  return (
    <div class="quick">
      {hasDrone.value && (
        <Opens name="fly" class="to-fly">
          {t("Fly to …")}
        </Opens>
      )}
      {isPhone.value && (
        <Opens name="tasks" class="to-tasks">
          {t("Tasks")}
          {asked.value.length > 0 && <span class="count"> {asked.value.length}</span>}
        </Opens>
      )}
      <RingButton />
      {running.value && !ordering.value && (
        <Chips words={ideas().slice(0, IDEAS)} go={(words) => void askFor(words)} />
      )}
    </div>
  );
}
