import { useEffect, useRef } from "preact/hooks";
import { answer, ask } from "./ask";
import { running } from "./board";
import { ideas } from "./ideas";
import { learnNames } from "./names";
import { Chips, SentenceAnswerView } from "./sentence-answer";
import { t } from "../messages/language";

/** Ask in a sentence; what would fly shows its rehearsal and waits for a yes. */
export function AskBar() {
  const field = useRef<HTMLInputElement>(null);
  useEffect(learnNames, []);
  const go = (words: string): void => {
    if (field.current) field.current.value = words;
    void ask(words);
  };
  return (
    <section class="card ask" aria-label={t("Ask")}>
      <form
        role="search"
        onSubmit={(event) => {
          event.preventDefault();
          go(field.current!.value);
        }}
      >
        <input
          ref={field}
          type="search"
          enterkeyhint="go"
          aria-label={t("Ask for something")}
          placeholder={t("Look at the entrance, where is the cup …")}
          maxLength={500}
          autocomplete="off"
        />
        <button type="submit" class="primary" aria-disabled={!running.value}>
          {t("Ask")}
        </button>
      </form>
      <div class="answer" role="status">
        <SentenceAnswerView go={go} />
      </div>
      {!answer.value?.suggestions.length && <Chips words={ideas()} go={go} />}
    </section>
  );
}
