import { translated } from "../messages/speech";
import { Told } from "../messages/told";
import type { HeardView } from "../wire/draft-messages";

/** What a live test said. */
export function Words({ said }: { said: HeardView | null }) {
  return (
    <div role="status">
      {said && (
        <ul class="notes">
          {said.words.map((words, k) => (
            <li key={k}>
              <Told words={translated(words)} />
            </li>
          ))}
        </ul>
      )}
    </div>
  );
}
