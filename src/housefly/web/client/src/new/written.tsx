import { signal } from "@preact/signals";
import type { OpenedView } from "../wire/draft-messages";
import { fetchAsSession } from "../wire/session";
import { ask, view } from "./draft";
import { Button } from "./fields";
import type { Key } from "./messages/en";
import { t } from "./messages/texts";
import type { Files } from "./save-step";

const LOOK = 700;

function commands(folder: string, hardware: boolean): [Key, string][] {
  const site = /^[\w./-]+$/.test(folder) ? folder : `'${folder.replaceAll("'", "'\\''")}'`;
  const simulated = hardware ? site.replace(/'?$/, "/simulated.toml$&") : site;
  const first: [Key, string][] = [
    ["Is this machine fit for it?", `housefly doctor --site ${site}`],
    ["The whole thing, simulated", `housefly demo --site ${simulated}`],
  ];
  if (!hardware) return first;
  return [
    ...first,
    [
      "Before the first flight, the drone in your hands",
      `housefly preflight --frames --site ${site}`,
    ],
    ["The real room", `housefly run --site ${site}`],
  ];
}

/** What was written, the room at once, and what is typed in a terminal. */
export function Written({ files }: { files: Files }) {
  const { folder, draft } = view.value!;
  return (
    <>
      <OpenNow />
      <div role="status">
        <p>{t("Written to {folder}. In a terminal:", { folder })}</p>
        {commands(folder, draft.hardware).map(([words, line]) => (
          <div key={line} class="next-line">
            <small class="quiet">{t(words)}</small>
            <pre>{line}</pre>
          </div>
        ))}
      </div>
      {files.map(({ path, text }) => (
        <details key={path}>
          <summary>{path.split("/").at(-1)}</summary>
          <pre>{text}</pre>
        </details>
      ))}
    </>
  );
}

const room = signal<OpenedView | null>(null);

async function look(): Promise<void> {
  try {
    room.value = (await (await fetchAsSession("/room")).json()) as OpenedView;
  } catch {
    // `housefly new` ended, and the room with it: the next question to it says so.
  }
  if (room.value?.state !== "ended") setTimeout(() => void look(), LOOK);
}

async function open(): Promise<void> {
  const begun = room.value !== null && room.value.state !== "ended";
  const answer = await ask<OpenedView>("/room", t("Opening the room …"));
  if (!answer) return;
  room.value = answer;
  if (!begun) void look();
}

/** The simulated room, started from here: it ends with `housefly new`. */
function OpenNow() {
  const now = room.value;
  if (now?.state === "ready")
    return (
      <p>
        <a class="button strong" href={now.address} target="_blank" rel="noopener">
          {t("Go to your room")}
        </a>
      </p>
    );
  const starts = now?.state === "starting";
  return (
    <>
      <Button strong ready={!starts} press={open}>
        {t("Open it now")}
      </Button>
      <p class="quiet" role="status">
        {starts && `${t("The simulated room starts; the first time takes minutes.")} `}
        {now?.state === "ended" && `△ ${t("The room has ended.")} `}
        {now?.line}
      </p>
    </>
  );
}
