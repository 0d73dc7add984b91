import type { ComponentChildren } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";
import { sentence } from "../format";
import { LanguageChoice } from "../messages/language-choice";
import { translated } from "../messages/speech";
import { Told } from "../messages/told";
import type { Said } from "../wire/draft-messages";
import { act, busy, draft, keep, kept, said, trouble, view } from "./draft";
import { DroneStep } from "./drone-step";
import { Button } from "./fields";
import { FrameStep } from "./frame-step";
import { t } from "./messages/texts";
import { STEPS } from "./names";
import { ObjectsStep } from "./objects-step";
import { Plan } from "./plan";
import { RoomStep } from "./room-step";
import { SaveStep } from "./save-step";
import { PadStep, PlacesStep, ZonesStep } from "./spot-steps";
import { chosen, openStep, step, type Step } from "./tools";
import { TrackingStep } from "./tracking-step";

const BODIES: Record<Step, () => ComponentChildren> = {
  room: () => <RoomStep />,
  objects: () => <ObjectsStep />,
  pad: () => <PadStep />,
  places: () => <PlacesStep />,
  zones: () => <ZonesStep />,
  tracking: () => <TrackingStep />,
  frame: () => <FrameStep />,
  drone: () => <DroneStep />,
  save: () => <SaveStep />,
};

const MARKS = { lacks: "△", well: "✓", later: "·" };

/** The plan, and beside it the steps from nothing to a site. */
export function App() {
  if (!view.value || !draft.value)
    return (
      <p class="veil" role="status">
        {trouble.value ? told(trouble.value.words) : t("Waiting for the draft …")}
      </p>
    );
  return (
    <div class="app new">
      <Top />
      <main class="new-deck">
        <Plan />
        <section class="card edit" aria-label={t("Steps")}>
          {trouble.value && (
            <p class="wrong" role="alert">
              △ {told(trouble.value.words)}
            </p>
          )}
          <ol class="steps">
            {STEPS.map((one, index) => (
              <StepItem key={one.step} index={index} />
            ))}
          </ol>
          <LanguageChoice />
        </section>
      </main>
    </div>
  );
}

const told = (words: Said) => <Told words={sentence(translated(words))} />;

function Top() {
  const { undoable, redoable } = view.value!;
  return (
    <header class="top">
      <div class="brand">
        <h1>Housefly</h1>
        <span class="site">
          {t("new site: {name}", { name: draft.value!.name || t("without a name") })}
        </span>
      </div>
      <p role="status" class="kept" data-kept={kept.value}>
        {status()}
      </p>
      <Button ready={undoable || !kept.value} press={undo}>
        {t("Undo")}
      </Button>
      <Button ready={redoable} press={redo}>
        {t("Redo")}
      </Button>
    </header>
  );
}

function status() {
  if (busy.value) return busy.value;
  if (!kept.value) return trouble.value ? t("△ Not kept") : t("Keeping …");
  if (!view.value!.settled) return t("Kept; checking where one can fly …");
  return said.value ? told(said.value) : t("Everything is kept.");
}

/** Undo what is kept; what could not be kept is dropped instead. */
export async function undo(): Promise<void> {
  if (!(await keep())) {
    draft.value = view.value!.draft;
    kept.value = true;
    trouble.value = null;
    chosen.value = null;
    return;
  }
  chosen.value = null;
  await act("/draft/undo", {});
}

export async function redo(): Promise<void> {
  chosen.value = null;
  await act("/draft/redo", {});
}

function StepItem({ index }: { index: number }) {
  const { step: name, title, words } = STEPS[index]!;
  const missing = view.value!.missing.filter((one) => one.step === name);
  const all = name === "save" ? view.value!.missing : missing;
  const lacks = all.some((one) => one.hinders);
  const state = lacks ? "lacks" : missing[0] || !draft.value!.bounds ? "later" : "well";
  const open = step.value === name;
  const next = STEPS[index + 1];
  const row = useRef<HTMLLIElement>(null);
  useLayoutEffect(() => {
    if (open && index > 0) row.current!.scrollIntoView({ block: "start" });
  }, [open]);
  return (
    <li ref={row} data-state={state} data-open={open}>
      <h2>
        <button type="button" aria-expanded={open} onClick={() => openStep(name)}>
          <span class="mark" aria-hidden="true">
            {name === "save" && !lacks ? "" : MARKS[state]}
          </span>
          <span>{t(title)}</span>
          <small class="quiet">{words(draft.value!)}</small>
        </button>
      </h2>
      {missing
        .filter((one) => open || one.hinders)
        .map((one, k) => (
          <p key={k} class={one.hinders ? "lack" : "quiet advice"}>
            {told(one.words)} {open && told(one.mend)}
          </p>
        ))}
      {open && (
        <div class="body">
          {BODIES[name]()}
          {next && (
            <button type="button" class="next" onClick={() => openStep(next.step)}>
              {t("Next: {title}", { title: t(next.title) })}
            </button>
          )}
        </div>
      )}
    </li>
  );
}
