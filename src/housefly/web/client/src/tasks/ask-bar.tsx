import { useRef } from "preact/hooks";
import { answer, ask } from "./ask";
import { AskForm } from "./ask-form";
import { running } from "./board";
import { ideas } from "./ideas";
import { Chips, SentenceAnswerView } from "./sentence-answer";
import { t } from "../messages/language";

/** Ask in a sentence; what would fly shows its rehearsal and waits for a yes. */
export function AskBar() {
  const field = useRef<HTMLInputElement>(null);
  const go = (words: string): void => {
    if (field.current) field.current.value = words;
    void ask(words);
  };
  return (
    <section class="card ask" aria-label={t("Ask")}>
      <AskForm go={go} isOff={!running.value}>
        <input
          ref={field}
          type="search"
          enterkeyhint="go"
          aria-label={t("Ask for something")}
          placeholder={t("Look at the entrance, where is the cup …")}
          maxLength={500}
          autocomplete="off"
        />
      </AskForm>
      <div class="answer" role="status">
        <SentenceAnswerView go={go} />
      </div>
      {!answer.value?.suggestions.length && <Chips words={ideas()} go={go} />}
    </section>
  );
}
