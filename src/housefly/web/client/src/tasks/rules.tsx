import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { sentence } from "../format";
import { clock } from "../live/words";
import { Told } from "../messages/told";
import { role } from "../store";
import { board, running, unixNow } from "./board";
import { Field } from "./field";
import { MODES } from "./mode";
import { changeRule, dryRun, rules as askRules, type Parameters } from "./tasks-client";
import type { RuleFiring, RulesAnswer, RuleStatus } from "../wire/task-messages";
import { language, t, translated } from "../messages/language";

const CONFIRMS = {
  ask: "ask me, then",
  auto: "at once",
  never: "only tell me",
} as const;

const known = signal<RuleStatus[] | null>(null);
/** What each would have done today, by name. */
const today = signal<RuleFiring[] | null>(null);
/** What went wrong, and with which rule; "" is with all. */
const trouble = signal({ rule: "", words: "" });
const fresh = signal<Parameters>({});

async function learn(asking: Promise<RulesAnswer>, rule = ""): Promise<void> {
  try {
    known.value = (await asking).rules;
    trouble.value = { rule: "", words: "" };
    const midnight = new Date(1000 * unixNow.peek()).setHours(0, 0, 0, 0) / 1000;
    today.value = (await dryRun(midnight)).firings;
  } catch (error) {
    trouble.value = { rule, words: (error as Error).message };
  }
}

const change = (rule: string, changed: object): void =>
  void learn(changeRule(rule, changed), rule);

/** What the house does by itself: a sentence with a switch each, and what it would have done. */
export function Rules() {
  useEffect(() => {
    void learn(askRules());
  }, [running.value, board.value?.ended[0]?.id]);
  return (
    <>
      {known.value?.length === 0 && <p class="quiet empty rule">{t("There is no rule.")}</p>}
      <ul class="rules">
        {known.value?.map((rule) =>
          rule.when === "" ? (
            <li key={rule.name}>△ {sentence(rule.words)}</li>
          ) : (
            <Rule key={rule.name} rule={rule} />
          ),
        )}
      </ul>
      <Trouble rule="" />
    </>
  );
}

const refusedOf = (rule: string): string =>
  trouble.value.rule === rule ? translated(trouble.value.words) : "";

function Trouble({ rule }: { rule: string }) {
  const words = refusedOf(rule);
  return <p role="status">{words && `△ ${sentence(words)}`}</p>;
}

/** "When the bell rings, ask me, then look who is at the door": with what may be set in it. */
function Rule({ rule }: { rule: RuleStatus }) {
  const { name, modes } = rule;
  const when = translated(rule.when);
  const mayNot = role.value !== "admin";
  const on = modes.length ? modes : MODES;
  const toggle = (mode: (typeof modes)[number]): void => {
    const left = on.includes(mode) ? on.filter((one) => one !== mode) : [...on, mode];
    if (left.length) change(name, { mode: left });
  };
  const names = rule.parameters.map((one) => one.default).filter((one) => isNaN(Number(one)));
  const said = modes.map((mode) => t(`${mode}^mode`));
  if (!said.length) said.push(`${t("Mode")}: ${t("any")}`);
  // What was refused is shown as it is, not as somebody wanted it.
  const key = refusedOf(name);
  return (
    <li data-on={rule.enabled} aria-label={when}>
      <label class="switch">
        <span>
          <strong>
            <Told words={when} />
          </strong>{" "}
          {t(CONFIRMS[rule.confirm])} <Told words={inSentence(translated(rule.title))} />
        </span>
        <input
          key={key}
          type="checkbox"
          role="switch"
          checked={rule.enabled}
          disabled={mayNot}
          onChange={(event) => change(name, { enabled: event.currentTarget.checked })}
        />
      </label>
      <Trouble rule={name} />
      <details>
        <summary class="quiet">
          {[...said, ...names].join(", ")}
          {rule.is_remembered && <Today rule={name} />}
        </summary>
        <fieldset key={key} class="filters" disabled={mayNot}>
          <select
            aria-label={when}
            onChange={(event) => change(name, { confirm: event.currentTarget.value })}
          >
            {(Object.keys(CONFIRMS) as (keyof typeof CONFIRMS)[]).map((one) => (
              <option key={one} value={one} selected={rule.confirm === one}>
                {t(CONFIRMS[one])}
              </option>
            ))}
          </select>
          <div class="chips" role="group" aria-label={t("Mode of the house")}>
            {MODES.map((mode) => (
              <button
                type="button"
                key={mode}
                aria-pressed={on.includes(mode)}
                onClick={() => toggle(mode)}
              >
                {t(`${mode}^mode`)}
              </button>
            ))}
          </div>
          {rule.parameters.map((one) => (
            <Field
              key={`${one.name} ${one.default}`}
              parameter={one}
              value={one.default}
              put={(value) => (fresh.value = { [one.name]: value })}
              done={() => change(name, { parameters: fresh.value })}
            />
          ))}
          {rule.changed_by && (
            <button type="button" onClick={() => change(name, { as_written: true })}>
              {t("As written, not as {who} changed it", { who: rule.changed_by })}
            </button>
          )}
        </fieldset>
      </details>
    </li>
  );
}

/** A title within a sentence; in English it begins small there. */
const inSentence = (title: string): string =>
  language.value === "en" ? title.charAt(0).toLowerCase() + title.slice(1) : title;

/** When it would have asked for its service today. */
function Today({ rule }: { rule: string }) {
  if (!today.value) return null;
  const fired = today.value.filter((one) => one.rule === rule && one.code === "ok");
  const times = fired.map((one) => clock(one.at).slice(0, 5)).join(", ");
  const n = fired.length;
  return <span>{n ? t("{n}× today: {times}", { n, times }) : t("Not once today.")}</span>;
}
