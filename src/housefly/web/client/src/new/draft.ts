// The draft as the page holds it: changed at once, kept by the server a moment later.
import { batch, computed, signal } from "@preact/signals";
import type {
  DraftView,
  HeardView,
  OpenedView,
  Said,
  SiteDraft,
  WrittenView,
} from "../wire/draft-messages";
import { fetchAsSession } from "../wire/session";
import { t } from "./messages/texts";

export interface Trouble {
  words: Said;
  /** What is wrong: "furniture.0.length"; "" is nothing that one could point to. */
  key: string;
}

/** Letters that are typed within this time are one change, kept and undone as one [ms]. */
const PAUSE = 400;
const AGAIN = 2000;
const CHECK_PERIOD = 800;
/** Browsers take up to 64 KiB along when a page goes [characters]. */
const KEPT_ALIVE = 50_000;

export const view = signal<DraftView | null>(null);
export const draft = signal<SiteDraft | null>(null);
export const trouble = signal<Trouble | null>(null);
export const said = signal<Said>("");
export const busy = signal("");
export const kept = signal(true);

export const known = computed(() => draft.value!);

let queue: Promise<unknown> = Promise.resolve();
let timer = 0;
let checking = 0;
/** How often the draft was changed here; up to which change it is being sent, and was kept. */
let edits = 0;
let sending = 0;
let sentEdits = 0;
let field = "";
let sentField = "";

/** Change the draft; changes of one field, named by `of`, are one change. */
export function change(next: Partial<SiteDraft>, of = ""): void {
  if (of !== field && !kept.value) void keep();
  field = of;
  edits += 1;
  batch(() => {
    draft.value = { ...known.value, ...next };
    kept.value = false;
    said.value = "";
  });
  clearTimeout(timer);
  if (of) timer = window.setTimeout(() => void keep(), PAUSE);
  else void keep();
}

/** Show a change while the pointer still moves; `change` keeps it. */
export function preview(next: Partial<SiteDraft>): void {
  draft.value = { ...known.value, ...next };
}

/** Send what is not kept yet; true when all of it is. */
export async function keep(): Promise<boolean> {
  clearTimeout(timer);
  const [sent, upTo, of] = [draft.value, edits, field];
  queue = queue.then(async () => {
    if (kept.value || upTo <= sentEdits || !view.value) return;
    const merges = of !== "" && of === sentField;
    sending = upTo;
    const answer = await post<DraftView>("/draft", { draft: sent, merges });
    if (!answer) return;
    accept(answer, draft.value === sent);
    [sentEdits, sentField] = [upTo, of];
    kept.value = edits === upTo;
  });
  await queue;
  return kept.value;
}

/** Ask for a change that the server makes. */
export async function act(path: string, body: object, words = ""): Promise<boolean> {
  if (!(await keep())) return false;
  sentField = field = "";
  let well = false;
  busy.value = words;
  queue = queue.then(async () => {
    const answer = await post<DraftView>(path, body);
    if (answer) accept(answer, true);
    well = answer !== null;
  });
  await queue;
  busy.value = "";
  return well;
}

/** Ask something that leaves the draft alone; null when it was refused. */
export async function ask<Answer extends HeardView | WrittenView | OpenedView>(
  path: string,
  words: string,
): Promise<Answer | null> {
  if (!(await keep())) return null;
  busy.value = words;
  const answer = await post<Answer>(path, {});
  busy.value = "";
  return answer;
}

/** Bring a file to the server; true when it is there. */
export async function upload(file: File): Promise<boolean> {
  busy.value = t("Bringing {file} …", { file: file.name });
  const answer = await answered(() =>
    fetchAsSession(`/files/${encodeURIComponent(file.name)}`, { method: "PUT", body: file }),
  );
  busy.value = "";
  return answer !== null;
}

/** Take what the server has, unless something is drawn meanwhile. */
export async function load(): Promise<void> {
  const before = draft.value;
  const answer = await answered<DraftView>(() => fetchAsSession("/draft"));
  if (answer && (kept.value || !before)) accept(answer, draft.value === before);
}

function post<Answer>(path: string, body: object): Promise<Answer | null> {
  const text = JSON.stringify({ ...body, based_on: view.value!.version });
  const keepalive = text.length < KEPT_ALIVE; // goes on while the page is left
  return answered<Answer>(() => fetchAsSession(path, { method: "POST", body: text, keepalive }));
}

/** Send what is not kept yet before the page goes; ask when that cannot be. */
export function leave(event: BeforeUnloadEvent): void {
  if (kept.value) return;
  void keep();
  const waits = sending > sentEdits && edits > sending;
  if (trouble.value || waits) event.preventDefault();
}

async function answered<Answer>(fetched: () => Promise<Response>): Promise<Answer | null> {
  try {
    const answer = await fetched();
    const tree = (await answer.json()) as Answer & { error?: Said; key?: string };
    if (answer.ok) {
      trouble.value = null;
      return tree;
    }
    complain(tree.error ?? answer.statusText, tree.key ?? "");
    if (answer.status === 409) await reload();
  } catch {
    complain("no contact with `housefly new`: does it still run? What you do now is not kept", "");
    clearTimeout(timer);
    timer = window.setTimeout(() => void keep(), AGAIN);
  }
  return null;
}

/** Take the draft as somebody else left it; what went wrong stays on the screen. */
async function reload(): Promise<void> {
  const answer = await fetchAsSession("/draft");
  if (!answer.ok) return;
  accept((await answer.json()) as DraftView, true);
  kept.value = true;
}

/** Ask again while the server still checks the draft, unless another one is on its way. */
function settle(): void {
  clearTimeout(checking);
  if (!view.value!.settled)
    checking = window.setTimeout(() => (kept.value ? void load() : settle()), CHECK_PERIOD);
}

function accept(fresh: DraftView, drafted: boolean): void {
  batch(() => {
    view.value = fresh;
    if (fresh.words) said.value = fresh.words;
    if (drafted) draft.value = fresh.draft;
  });
  settle();
}

function complain(words: Said, key: string): void {
  trouble.value = { words, key };
}
