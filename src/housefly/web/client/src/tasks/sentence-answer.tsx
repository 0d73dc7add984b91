import { HoldButton } from "../controls/hold-button";
import { sentence } from "../format";
import { ago } from "../live/words";
import { accept, answer, answeredAt, said, trouble } from "./ask";
import { running, unixNow } from "./board";

/** What came of a sentence: words, what could be meant, or what would be done about it. */
export function SentenceAnswerView({ go }: { go: (words: string) => void }) {
  const found = answer.value;
  if (trouble.value) return <p>△ {sentence(trouble.value)}</p>;
  if (!found) return said.value ? <p class="quiet">…</p> : null;
  return (
    <>
      <p class="quiet asked">
        “{said.value}”, answered {ago(unixNow.value - answeredAt.value)}
      </p>
      <p class="words" data-understood={found.understood}>
        {!found.understood && "△ "}
        {sentence(found.words)}
      </p>
      {found.offer && (
        <HoldButton hold={accept} class="primary" label="Yes, do it">
          <span>Yes, do it</span>
          <small aria-hidden="true">hold</small>
        </HoldButton>
      )}
      {found.suggestions.length > 0 && <Chips words={found.suggestions} go={go} />}
    </>
  );
}

export function Chips({ words, go }: { words: string[]; go: (words: string) => void }) {
  return (
    <p class="chips">
      {words.map((one) => (
        <button
          type="button"
          key={one}
          aria-disabled={!running.value}
          onClick={() => running.value && go(one)}
        >
          {one}
        </button>
      ))}
    </p>
  );
}
