import { useEffect, useRef } from "preact/hooks";
import { computed } from "@preact/signals";
import { HoldButton } from "../controls/hold-button";
import { AskIcon } from "../controls/icons";
import { sentence } from "../format";
import { createHold } from "../hold";
import { at, found, nameOf } from "../live/store";
import { clock } from "../live/words";
import { refuse } from "../said";
import { hasDrone, panel } from "../store";
import { answer, said, trouble } from "../tasks/ask";
import { AskForm } from "../tasks/ask-form";
import { running } from "../tasks/board";
import { SentenceAnswerView } from "../tasks/sentence-answer";
import { askFor, ideasFor, lookThere, unask, writing } from "./asked-words";
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

async function go(words: string): Promise<void> {
  if (panel.value === "ask") panel.value = "";
  await askFor(words);
}

/** Where is it, go there, or whatever else one may ask. */
export function Ask() {
  const field = useRef<HTMLInputElement>(null);
  useEffect(() => {
    if (panel.value === "ask") field.current?.focus();
  }, [panel.value]);
  return (
    <AskForm class="ask-line" go={(words) => void go(words)}>
      <AskIcon />
      <input
        ref={field}
        type="search"
        enterkeyhint="go"
        aria-label={t("Where is, go to")}
        placeholder={t("What would you like?")}
        list="names"
        maxLength={200}
        autocomplete="off"
        onInput={(event) => {
          writing.value = event.currentTarget.value !== "";
          if (!writing.value) unask();
        }}
        onBlur={() => (writing.value = false)}
      />
      <datalist id="names">
        {ideasFor().map((one) => (
          <option key={one} value={one} />
        ))}
      </datalist>
    </AskForm>
  );
}

/** What came of it, above the field, until somebody puts it away. */
export function Answer() {
  if (!(found.value.answer || found.value.problem || said.value || trouble.value)) return null;
  return (
    <div class="answer card" role="status">
      <button type="button" class="shut" aria-label={t("Close the answer")} onClick={unask}>
        ×
      </button>
      {said.value || answer.value ? <SentenceAnswerView go={go} /> : <Whereabouts />}
    </div>
  );
}

/** A thing or person: what is known of it, what is in it, and the way there. */
function Whereabouts() {
  const { answer: known, problem, meant } = found.value;
  if (!known)
    return (
      <>
        <p lang={tongue(translated(problem))}>△ {sentence(translated(problem))}</p>
        <Names names={meant} />
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
      <Names names={around.map(nameOf)} />
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

function Names({ names }: { names: string[] }) {
  if (names.length === 0) return null;
  return (
    <p class="chips">
      {names.map((name) => (
        <button type="button" key={name} onClick={() => void go(name)}>
          {name}
        </button>
      ))}
    </p>
  );
}
