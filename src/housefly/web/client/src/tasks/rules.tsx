import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { sentence } from "../format";
import { clock } from "../live/words";
import { Told } from "../messages/told";
import { board, running, unixNow } from "./board";
import { dryRun, rules as askRules } from "./tasks-client";
import type { RuleFiring, RuleStatus } from "../wire/task-messages";
import { causeOf } from "./words";
import { t, translated } from "../messages/language";

const WEEK = 7 * 86400;

const known = signal<RuleStatus[] | null>(null);
const firings = signal<RuleFiring[] | null>(null);
const trouble = signal("");

async function look(): Promise<void> {
  try {
    known.value = (await askRules()).rules;
    trouble.value = "";
  } catch (error) {
    trouble.value = (error as Error).message;
  }
}

async function lastWeek(): Promise<void> {
  try {
    firings.value = (await dryRun(Math.max(0, unixNow.value - WEEK))).firings;
    trouble.value = "";
  } catch (error) {
    trouble.value = (error as Error).message;
  }
}

/** Which rules ask for tasks, what each did last, and what they would have done last week. */
export function Rules() {
  useEffect(() => void look(), [running.value, board.value?.ended[0]?.id]);
  return (
    <>
      {known.value?.length === 0 && <p class="quiet">{t("There is no rule.")}</p>}
      <ul class="rules">
        {known.value?.map((rule) => (
          <li key={rule.name}>
            <strong>
              {rule.name}
              {!rule.enabled && ` ${t("(off)")}`}
            </strong>
            <p>
              <Told words={sentence(translated(rule.words))} />
            </p>
            {rule.last_at !== null && (
              <p class="quiet">
                {clock(rule.last_at)}: <Told words={translated(rule.last_words)} />
              </p>
            )}
          </li>
        ))}
      </ul>
      <button type="button" onClick={() => void lastWeek()}>
        {t("What would have happened last week?")}
      </button>
      <p role="status">{trouble.value && `△ ${sentence(translated(trouble.value))}`}</p>
      {firings.value && (
        <ol class="firings" aria-label={t("What the rules would have done")}>
          {firings.value.length === 0 && <li class="quiet">{t("Nothing.")}</li>}
          {firings.value.map((one) => (
            <li key={`${one.rule} ${one.at}`}>
              <time>{clock(one.at)}</time> {sentence(causeOf(one.cause))}{" "}
              <Told words={sentence(translated(one.words))} />
            </li>
          ))}
        </ol>
      )}
    </>
  );
}
