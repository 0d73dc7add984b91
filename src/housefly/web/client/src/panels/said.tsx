import { said, unsay } from "../said";
import { tongue } from "../messages/language";

/** What a button has to say, in a lane of its own: over no order, no face and never over STOP. */
export function Said() {
  const now = said.value;
  if (!now) return null;
  return (
    <div class="said" role="alert" data-stays={now.stays}>
      <p lang={tongue(now.words)}>
        {now.stays && "△ "}
        {now.words}
      </p>
      {now.stays && (
        <button type="button" onClick={unsay}>
          OK
        </button>
      )}
    </div>
  );
}
