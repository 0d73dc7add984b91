// Which clips there are, and which is open.
import { signal } from "@preact/signals";
import { layer } from "../back";
import { screen } from "../store";
import { clips as askClips, deleteClip, keepClip } from "./tasks-client";
import type { ClipInfo } from "../wire/task-messages";

const ADDRESS = /^#clip\/([0-9A-Za-z-]{1,60})$/;

export const found = signal<ClipInfo[]>([]);
export const trouble = signal("");
/** Why the open clip was not changed, or "". */
export const clipTrouble = signal("");
/** The clip that is open, by id; the address keeps it over a reload. */
export const opened = signal(ADDRESS.exec(location.hash)?.[1] ?? "");
/** What is known of it; undefined while that is asked for, null when nothing is. */
export const openedInfo = signal<ClipInfo | null | undefined>(undefined);

const PAGE = 50;
/** Whether there may be older ones than those that were found. */
export const more = signal(false);
let asked: Record<string, string> = {};

/** Look for clips; empty words mean any. */
export async function findClips(wanted: Record<string, string>): Promise<void> {
  const words = Object.entries(wanted).map(([name, value]) => [name, value.trim()]);
  asked = Object.fromEntries(words.filter(([, value]) => value !== ""));
  await turnTo(asked, []);
}

/** Find those that are older than the last one. */
export async function findOlder(): Promise<void> {
  const last = found.value.at(-1);
  if (last) await turnTo({ ...asked, before: last.id }, found.value);
}

async function turnTo(wanted: Record<string, string>, shown: ClipInfo[]): Promise<void> {
  const question = asked;
  try {
    const { clips } = await askClips({ ...wanted, limit: String(PAGE) });
    if (question !== asked) return; // something else was asked for meanwhile
    found.value = [...shown, ...clips];
    more.value = clips.length === PAGE;
    trouble.value = "";
  } catch (error) {
    found.value = shown;
    trouble.value = (error as Error).message;
  }
}

export function openClip(id: string): void {
  if (opened.value === id) return;
  opened.value = id;
  clipTrouble.value = "";
  if (!id) return;
  history.replaceState(history.state, "", `#clip/${id}`);
  void describe(id);
}

export function closeClip(): void {
  opened.value = "";
  history.replaceState(history.state, "", "#tasks");
}

/** Keep the open clip until somebody deletes it, or no longer, or delete it. */
export async function changeClip(what: "keep" | "let go" | "delete"): Promise<void> {
  const id = opened.value;
  try {
    const { clips } =
      what === "delete" ? await deleteClip(id) : await keepClip(id, what === "keep");
    clipTrouble.value = "";
    found.value =
      what === "delete"
        ? found.value.filter((one) => one.id !== id)
        : found.value.map((one) => (one.id === id ? (clips[0] ?? one) : one));
    if (what === "delete") closeClip();
    else openedInfo.value = clips[0] ?? openedInfo.value;
  } catch (error) {
    clipTrouble.value = (error as Error).message;
  }
}

/** Learn what is known of a clip; it plays without. */
async function describe(id: string): Promise<void> {
  const known = found.value.find((one) => one.id === id);
  openedInfo.value = known;
  if (known) return;
  const { clips } = await askClips({ limit: "1000" }).catch(() => ({ clips: [] as ClipInfo[] }));
  if (opened.value === id) openedInfo.value = clips.find((one) => one.id === id) ?? null;
}

layer(() => opened.value !== "" && screen.value === "tasks", closeClip);
if (opened.value) void describe(opened.value);

// A link to a clip, from the picture.
window.addEventListener("hashchange", () => openClip(ADDRESS.exec(location.hash)?.[1] ?? ""));
