import { useEffect, useRef } from "preact/hooks";
import { computed } from "@preact/signals";
import { HoldButton } from "../controls/hold-button";
import { sentence } from "../format";
import { createHold } from "../hold";
import { at, found, nameOf } from "../live/store";
import { clock } from "../live/words";
import { refuse } from "../said";
import { hasDrone, panel } from "../store";
import { answer, said, trouble } from "../tasks/ask";
import { running } from "../tasks/board";
import { learnNames } from "../tasks/names";
import { SentenceAnswerView } from "../tasks/sentence-answer";
import { askFor, ideasFor, lookThere, unask } from "./asked-words";
import { t, tongue, translated } from "../messages/language";

const HOLD = 0.6;
const nowhere = computed(() => {
  const known = found.value.answer;
  const somewhere = known?.position || known?.inside.length;
  return somewhere ? "" : t("Nobody knows where that is.");
});
const look = createHold(HOLD, nowhere, (from) => {
  const known = found.peek().answer;
  if (known)
    lookThere(known).then(
      unask,
      (error: Error) => refuse(translated(error.message), from),
    );
});

/** Where is it, go there, or whatever else one may ask; the answer lies over the map. */
export function Ask() {
  const field = useRef<HTMLInputElement>(null);
  useEffect(learnNames, []);
  useEffect(() => {
    if (panel.value === "ask") field.current?.focus();
  }, [panel.value]);
  const go = (words: string): void => {
    if (field.current) field.current.value = words;
    if (panel.value === "ask") panel.value = "";
    void askFor(words);
  };
  const shown = found.value.answer || found.value.problem || said.value || trouble.value;
  return (
    <section class="ask-line find" aria-label={t("Ask")}>
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
          aria-label={t("Where is, go to")}
          placeholder={t("Where is … / go to …")}
          list="names"
          maxLength={200}
          autocomplete="off"
          onInput={(event) => event.currentTarget.value === "" && unask()}
        />
        <button type="submit">{t("Ask")}</button>
        <datalist id="names">
          {ideasFor().map((one) => (
            <option key={one} value={one} />
          ))}
        </datalist>
      </form>
      {shown && (
        <div class="answer card" role="status">
          <button type="button" class="shut" aria-label={t("Close the answer")} onClick={unask}>
            ×
          </button>
          {said.value || answer.value ? <SentenceAnswerView go={go} /> : <Whereabouts go={go} />}
        </div>
      )}
    </section>
  );
}

/** A thing or person: what is known of it, what is in it, and the way there. */
function Whereabouts({ go }: { go: (words: string) => void }) {
  const { answer: known, problem, meant } = found.value;
  if (!known)
    return (
      <>
        <p lang={tongue(translated(problem))}>△ {sentence(translated(problem))}</p>
        <Names names={meant} go={go} />
      </>
    );
  const perhaps = known.alternatives.map((one) => one.thing).filter((id) => id);
  const around = [...new Set([...known.inside, ...perhaps])];
  return (
    <>
      {at.value !== null && (
        <strong class="then">{t("At {time}:", { time: clock(at.value) })} </strong>
      )}
      <p class="words" lang={tongue(translated(known.words))}>
        {translated(known.words)}
      </p>
      <Names names={around.map(nameOf)} go={go} />
      {at.value === null && hasDrone.value && (
        <HoldButton
          hold={look}
          class="secondary"
          label={running.value ? t("Fly there and look") : t("Choose it as the goal")}
        >
          <span>{t("Look there")}</span>
          <small aria-hidden="true">{t("hold")}</small>
        </HoldButton>
      )}
    </>
  );
}

function Names({ names, go }: { names: string[]; go: (words: string) => void }) {
  if (names.length === 0) return null;
  return (
    <p class="chips">
      {names.map((name) => (
        <button type="button" key={name} onClick={() => go(name)}>
          {name}
        </button>
      ))}
    </p>
  );
}
