// The sheet of a phone: places and tasks, over the stage, and never over an order or STOP.
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { Places } from "../controls/mission";
import { hasDrone, open, panel } from "../store";
import { ideas } from "../tasks/ideas";
import { OpenTasks } from "../tasks/open-tasks";
import { Chips } from "../tasks/sentence-answer";
import { askFor } from "./asked-words";
import { ordering } from "./dock";
import { holdFocus, listenToHandle } from "./sheet-hands";
import { t } from "../messages/language";

type Tab = "fly" | "tasks";
const isTab = (name: string): name is Tab => name === "fly" || name === "tasks";

/** Places and tasks: closed, half or full; it stays here while it is closed, so that it glides. */
export function BottomSheet() {
  const sheet = useRef<HTMLElement>(null);
  const handle = useRef<HTMLDivElement>(null);
  const isFull = useSignal(false);
  const shown = useRef<Tab>("fly");
  const isOpen = isTab(panel.value);
  if (isTab(panel.value)) shown.current = panel.value;
  useEffect(() => {
    if (!isOpen) return undefined;
    const release = holdFocus(sheet.current!);
    return () => {
      isFull.value = false;
      release();
    };
  }, [isOpen]);
  useEffect(
    () =>
      listenToHandle(handle.current!, (share) => {
        isFull.value = share === 1;
        if (share === 0) panel.value = "";
      }),
    [],
  );
  return (
    <section
      ref={sheet}
      class="bottom-sheet"
      role="dialog"
      aria-label={t("Places and tasks")}
      data-height={isOpen ? (isFull.value ? "full" : "half") : "closed"}
    >
      <div ref={handle} class="handle">
        {hasDrone.value && <TabButton name="fly" words={t("Fly to …")} shown={shown.current} />}
        <TabButton name="tasks" words={t("Tasks")} shown={shown.current} />
        <button
          type="button"
          class="higher"
          aria-label={t("Whole height")}
          aria-pressed={isFull.value}
          onClick={() => (isFull.value = !isFull.value)}
        >
          {isFull.value ? "▾" : "▴"}
        </button>
        <button type="button" aria-label={t("Close")} onClick={() => (panel.value = "")}>
          ×
        </button>
      </div>
      <div class="inside" data-scrolls>
        {shown.current === "fly" ? <Places /> : <Tasks />}
      </div>
    </section>
  );
}

const TabButton = ({ name, words, shown }: { name: Tab; words: string; shown: Tab }) => (
  <button
    type="button"
    aria-current={name === shown}
    onClick={() => (panel.value = name)}
  >
    {words}
  </button>
);

function askHere(words: string): void {
  panel.value = "";
  void askFor(words);
}

/** What flies and waits, and more; what one may ask stands below already while it rests. */
const Tasks = () => (
  <>
    <OpenTasks />
    {ordering.value && <Chips words={ideas()} go={askHere} />}
    <div class="row">
      {ordering.value && (
        <button type="button" onClick={() => (panel.value = "ask")}>
          {t("Ask")}
        </button>
      )}
      <button type="button" onClick={() => open("tasks")}>
        {t("All tasks")}
      </button>
    </div>
  </>
);
