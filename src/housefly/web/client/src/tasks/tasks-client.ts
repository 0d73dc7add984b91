// Questions and orders to the tasks, over HTTP.
import type {
  ClipsAnswer,
  FiringsAnswer,
  ModeAnswer,
  RehearsalAnswer,
  RulesAnswer,
  SentenceAnswer,
  ServicesAnswer,
  TaskAnswer,
  TasksAnswer,
} from "../wire/task-messages";
import type { BellView, ThingsAnswer } from "../wire/room-messages";
import { fetchAsSession, proof } from "../wire/session";
import { language } from "../messages/language";

const API = "/api/v1";

const fetched = <T extends TaskAnswer | ThingsAnswer>(path: string, init?: RequestInit) =>
  fetchedFrom<T>(API + path, init);

async function fetchedFrom<T extends TaskAnswer | ThingsAnswer | BellView>(
  path: string,
  init?: RequestInit,
): Promise<T> {
  const answer = await fetchAsSession(path, init).catch(() => {
    throw new Error("no contact with the server");
  });
  const tree = (await answer.json().catch(() => ({}))) as T & { error?: string; reason?: string };
  if (!answer.ok) throw new Error(tree.error ?? tree.reason ?? answer.statusText);
  return tree;
}

const post = <T extends TaskAnswer>(path: string, body: object = {}): Promise<T> =>
  fetched<T>(path, { method: "POST", body: JSON.stringify(body) });

export type Value = string | number | boolean;
export type Parameters = Record<string, Value>;

export const reply = (task: number, question: string, choice: string): Promise<TasksAnswer> =>
  post(`/tasks/${task}/reply`, { question, choice });

export const change = (
  task: number,
  what: "cancel" | "pause" | "continue",
): Promise<TasksAnswer> => post(`/tasks/${task}/${what}`);

export const request = (
  service: string,
  parameters: Parameters,
  confirm: "auto" | "ask" = "auto",
): Promise<TasksAnswer> => post("/tasks", { service, parameters, confirm });

export const rehearse = (service: string, parameters: Parameters): Promise<RehearsalAnswer> =>
  post("/tasks/rehearse", { service, parameters });

/** Say something; what would fly waits for a yes, which shows the rehearsal. */
export const say = (text: string): Promise<SentenceAnswer> =>
  post("/sentence", { text, language: language.value, confirm: "ask" });

export const setMode = (mode: string): Promise<ModeAnswer> => post("/mode", { mode });

export const pressBell = (): Promise<BellView> => fetchedFrom("/bell", { method: "POST" });

export const services = (): Promise<ServicesAnswer> => fetched("/services");
export const rules = (): Promise<RulesAnswer> => fetched("/rules");
/** What the rules would have done, also those that are off. */
export const dryRun = (since: number): Promise<FiringsAnswer> =>
  fetched(`/rules/dry-run?since=${since.toFixed(0)}&off=true`);
export const changeRule = (rule: string, change: object): Promise<RulesAnswer> =>
  post(`/rules/${rule}/change`, change);
/** Tasks that were asked for before another one; 0 begins with the newest. */
export const history = (before: number, limit: number): Promise<TasksAnswer> =>
  fetched(`/tasks/history?limit=${limit}&before=${before}`);

export const keepClip = (clip: string, keep: boolean): Promise<ClipsAnswer> =>
  post(`/clips/${encodeURIComponent(clip)}/keep`, { keep });
/** Keep the picture that came at a time [s, server's clock] as a photo; 0 is the newest. */
export const takePhoto = (at: number): Promise<ClipsAnswer> => post("/photo", { at });
export const deleteClip = (clip: string): Promise<ClipsAnswer> =>
  post(`/clips/${encodeURIComponent(clip)}/delete`);
export const clips = (wanted: Record<string, string>): Promise<ClipsAnswer> =>
  fetched(`/clips?${new URLSearchParams(wanted)}`);

/** The address of a clip; elements cannot send a header, so the proof stands in it. */
export const clipAddress = (id: string, more = ""): string =>
  `${API}/clips/${encodeURIComponent(id)}?proof=${proof()}${more}`;
/** The same of what stands in a list: that is no watching. */
export const stillAddress = (id: string): string => clipAddress(id, "&still=1");

/** The address of several clips in one file. */
export function clipsAddress(ids: readonly string[]): string {
  const wanted = new URLSearchParams(ids.map((id) => ["clip", id]));
  return `${API}/clips.zip?${wanted}&proof=${proof()}`;
}
