import { HoldButton } from "../controls/hold-button";
import { sentence } from "../format";
import { ago } from "../live/words";
import { Told } from "../messages/told";
import { accept, answer, answeredAt, said, trouble } from "./ask";
import { running, unixNow } from "./board";
import { t, translated } from "../messages/language";

/** What came of a sentence: words, what could be meant, or what would be done about it. */
export function SentenceAnswerView({ go }: { go: (words: string) => void }) {
  const found = answer.value;
  if (trouble.value) return <p>△ {sentence(translated(trouble.value))}</p>;
  if (!found) return said.value ? <p class="quiet">…</p> : null;
  return (
    <>
      <p class="quiet asked">
        {t("“{words}”, answered {age}", {
          words: said.value,
          age: ago(unixNow.value - answeredAt.value),
        })}
      </p>
      <p class="words" data-understood={found.understood}>
        {!found.understood && "△ "}
        <Told words={sentence(translated(found.words))} />
      </p>
      {found.offer && (
        <HoldButton hold={accept} class="primary" label={t("Yes, do it")}>
          <span>{t("Yes, do it")}</span>
          <small aria-hidden="true">{t("hold")}</small>
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
