import { computed, signal } from "@preact/signals";
import { at, events as roomEvents, hubNow, only, things } from "../live/store";
import { askEvents } from "../live/room-client";
import { happened } from "../live/words";
import { RecordedLog } from "../replay/recorded";
import { replaying } from "../replay/replay";
import { events } from "../store";
import { go } from "../timebar/past";
import { serverNow } from "../wire/clock";
import type { Severity } from "../wire/messages";
import { t, tongue, translated } from "../messages/language";
import { capital } from "../format";

const MARK: Record<Severity, string> = { info: "·", warning: "△", fault: "✕" };
const SHOWN = 100;
const FILTERS = ["all", "drone", "room", "warnings"] as const;

type Filter = (typeof FILTERS)[number];
const filter = signal<Filter>("all");

interface Line {
  key: string;
  /** On this machine's clock [ms]. */
  when: number;
  severity: Severity;
  words: string;
  of: "drone" | "room";
  /** The moment that a press shows [Unix time, s]. */
  shows: number | null;
}

/** An event is shown with what it brought about [s]. */
const AFTER = 0.5;

const lines = computed<Line[]>(() => {
  const now = serverNow();
  const own = events.value.slice(-SHOWN).map((one): Line => ({
    key: `d${one.number}`,
    when: Date.now() - 1000 * (now - one.at),
    severity: one.severity,
    words: capital(translated(one.text)),
    of: "drone",
    shows: null,
  }));
  const hub = hubNow.peek();
  const heard = roomEvents.value.slice(-SHOWN).map((one): Line => ({
    key: `r${one.at} ${one.kind} ${one.thing}`,
    when: Date.now() - 1000 * (hub - one.at),
    severity: "info",
    words: happened(one),
    of: "room",
    shows: one.at + AFTER,
  }));
  return [...own, ...heard].sort((a, b) => b.when - a.when);
});

const shown = computed(() =>
  lines.value
    .filter(({ of, severity }) =>
      filter.value === "all"
        ? true
        : filter.value === "warnings"
          ? severity !== "info"
          : of === filter.value,
    )
    .slice(0, SHOWN),
);

/** What happened to drone and room, newest first; every line arrives, whatever the line is like. */
export function Log() {
  if (replaying.value) return <RecordedLog />;
  return (
    <section class="card log" aria-label={t("Event log")}>
      <div class="row">
        <h2>{t("Log")}</h2>
        <select
          aria-label={t("Which lines")}
          value={filter.value}
          onChange={(event) => (filter.value = event.currentTarget.value as Filter)}
        >
          {FILTERS.map((one) => (
            <option key={one} value={one}>
              {t(`${one}^lines`)}
            </option>
          ))}
        </select>
        {filter.value === "room" && <OnlyOf />}
      </div>
      <ol tabIndex={0} data-scrolls onKeyDown={walk}>
        {shown.value.map((one) => (
          <li key={one.key} data-severity={one.severity}>
            <time>{new Date(one.when).toTimeString().slice(0, 8)}</time>
            <span class="mark" aria-label={t(one.severity)}>
              {MARK[one.severity]}
            </span>
            {one.shows === null ? (
              <span lang={tongue(one.words)}>{one.words}</span>
            ) : (
              <button
                type="button"
                tabIndex={-1}
                aria-current={at.value === one.shows}
                title={t("Show the room as it was then")}
                onClick={() => go(one.shows)}
              >
                {one.words}
              </button>
            )}
          </li>
        ))}
      </ol>
    </section>
  );
}

/** The arrow keys go from line to line: as Tab stops they would stand before STOP. */
function walk(event: KeyboardEvent): void {
  const way = { ArrowDown: 1, ArrowUp: -1 }[event.key as "ArrowUp"];
  const all = [...(event.currentTarget as Element).querySelectorAll("button")];
  const next = way && all[all.indexOf(document.activeElement as HTMLButtonElement) + way];
  if (!next) return;
  event.preventDefault();
  next.focus();
}

/** Whose events of the room are listed. */
function OnlyOf() {
  return (
    <select
      aria-label={t("Only of")}
      value={only.value}
      onChange={(event) => {
        only.value = event.currentTarget.value;
        void askEvents().catch(() => undefined);
      }}
    >
      <option value="">{t("everything")}</option>
      {[...things.value.values()].map((one) => (
        <option key={one.thing} value={one.thing}>
          {one.name}
        </option>
      ))}
    </select>
  );
}
