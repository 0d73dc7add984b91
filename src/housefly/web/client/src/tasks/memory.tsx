import { signal } from "@preact/signals";
import { Feed } from "../feed/feed";
import { sentence } from "../format";
import { Told } from "../messages/told";
import { board } from "./board";
import { Clips } from "./clips";
import { Ended } from "./ended";
import { Rules } from "./rules";
import { t, translated } from "../messages/language";

const TABS = { feed: "Lately", history: "History", clips: "Clips", rules: "Rules" } as const;
type Tab = keyof typeof TABS;
const tab = signal<Tab>("feed");
const SHOWN = { feed: Feed, history: Ended, clips: Clips, rules: Rules };

/** What came of earlier tasks, what was recorded, and which rules ask for tasks. */
export function Memory() {
  const Shown = SHOWN[tab.value];
  return (
    <section class="card memory" aria-label={t("What was")}>
      <div class="tabs" role="tablist" aria-label={t("What was")}>
        {(Object.keys(TABS) as Tab[]).map((name) => (
          <button
            type="button"
            key={name}
            role="tab"
            id={`tab-${name}`}
            aria-selected={tab.value === name}
            aria-controls="tab-shown"
            onClick={() => (tab.value = name)}
          >
            {t(TABS[name])}
          </button>
        ))}
      </div>
      {(board.value?.notices ?? []).map((words) => (
        <p key={words} role="status">
          △ <Told words={sentence(translated(words))} />
        </p>
      ))}
      <div id="tab-shown" role="tabpanel" aria-labelledby={`tab-${tab.value}`}>
        <Shown />
      </div>
    </section>
  );
}
