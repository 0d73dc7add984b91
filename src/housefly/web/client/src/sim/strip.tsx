import "../later-style";
import { useEffect } from "preact/hooks";
import { signal } from "@preact/signals";
import { sentence } from "../format";
import { Told } from "../messages/told";
import { hasDrone, screen } from "../store";
import { pressBell } from "../tasks/tasks-client";
import type { Said, SimulationView } from "../wire/room-messages";
import { fetchAsSession } from "../wire/session";
import { tab } from "../wire/socket";
import { t, translated } from "../messages/language";

type DeedName = "put back" | "charge" | "walk" | "fault" | "mend";

const LASTS = [10, 30, 60];
/** How often it is looked whether a fault is over [ms]. */
const LOOK = 2000;

const view = signal<SimulationView | null>(null);
const said = signal<Said>("");
const failed = signal(false);
const busy = signal(false);

const drone = new URLSearchParams(location.search).get("drone") ?? "";

async function asked(init?: RequestInit): Promise<SimulationView> {
  const answer = await fetchAsSession("/simulation", init);
  const tree = (await answer.json()) as SimulationView & { error?: string };
  if (!answer.ok) throw new Error(tree.error);
  return (view.value = tree);
}

const look = (): void => void asked().catch(() => undefined);

/** Do one thing at a time, and tell what came of it. */
async function act(work: () => Promise<{ done: boolean; words: Said }>): Promise<void> {
  if (busy.value) return;
  busy.value = true;
  try {
    const { done, words } = await work();
    [said.value, failed.value] = [words, !done];
  } catch (error) {
    [said.value, failed.value] = [(error as Error).message, true];
  }
  busy.value = false;
}

const ring = (): Promise<void> =>
  act(async () => {
    const { rung, words } = await pressBell();
    return { done: rung, words };
  });

const simulate = (deed: DeedName, more: object = {}): Promise<void> =>
  act(() =>
    asked({ method: "POST", body: JSON.stringify({ tab: tab(), deed, drone, ...more }) }),
  );

/** The simulated room in somebody's hands: ring, put back, charge, walk, break. */
export function Strip() {
  useEffect(() => {
    look();
    const timer = setInterval(() => view.peek()?.failing && look(), LOOK);
    return () => clearInterval(timer);
  }, []);
  return (
    <section class="card sim" aria-label={t("Simulated room")}>
      <details open={screen.value === "tasks"}>
        <summary>{t("Simulated room")}</summary>
        <div class="deeds">
          <Deed run={ring} words={t("Ring the doorbell")} />
          {hasDrone.value && (
            <>
              <Deed run={() => simulate("put back")} words={t("Put it on its pad")} />
              <Deed run={() => simulate("charge")} words={t("Charge it")} />
              <Deed run={() => simulate("walk")} words={t("Let somebody walk")} />
              <Faults />
            </>
          )}
        </div>
      </details>
      <p role="status">
        {busy.value ? "…" : said.value && <Outcome />}
      </p>
    </section>
  );
}

const Outcome = () => (
  <>
    {failed.value && "△ "}
    <Told words={sentence(translated(said.value))} />
  </>
);

const Deed = ({ run, words }: { run: () => Promise<void>; words: string }) => (
  <button type="button" aria-disabled={busy.value} onClick={() => void run()}>
    {words}
  </button>
);

/** A fault of the catalogue, with an end. */
function Faults() {
  const now = view.value;
  if (!now?.faults.length) return null;
  return (
    <form
      onSubmit={(event) => {
        event.preventDefault();
        const given = new FormData(event.currentTarget);
        void simulate("fault", { fault: given.get("fault"), seconds: Number(given.get("s")) });
      }}
    >
      <select name="fault" aria-label={t("What fails")}>
        {now.faults.map(({ row, words }) => (
          <option key={row} value={row}>
            {sentence(translated(words)).replace(/\.$/, "")}
          </option>
        ))}
      </select>
      <select name="s" aria-label={t("For how long")}>
        {LASTS.map((n) => (
          <option key={n} value={n}>
            {t("for {n} s", { n })}
          </option>
        ))}
      </select>
      <button type="submit" aria-disabled={busy.value}>
        {t("Make it fail")}
      </button>
      {now.failing > 0 && <Deed run={() => simulate("mend")} words={t("End the faults")} />}
    </form>
  );
}
