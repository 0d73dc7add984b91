// The connection to the server: reconnects, resolves requests, and writes messages to the store.
import { batch } from "@preact/signals";
import * as store from "../store";
import { sentence } from "../format";
import { tellRefusal } from "../said";
import { translated } from "../messages/speech";
import { told } from "../tasks/board";
import { extended, trailOf } from "../trail";
import { assume, learn, localNow } from "./clock";
import type {
  AcceptedReply,
  ClientMessage,
  EventView,
  InviteReply,
  PlanReply,
  RefusedReply,
  ServerMessage,
} from "./messages";
import { openSocket } from "./open-socket";
import { fetchAsSession, proof } from "./session";

type Request = Exclude<ClientMessage, { type: "hello" | "ping" }>;
type Unnumbered<T> = T extends Request ? Omit<T, "id"> : never;
type Answer = AcceptedReply | RefusedReply | PlanReply | InviteReply;

const OPENED_ELSEWHERE = 4001;
const PING_PERIOD = 1000;
const STOP_PATIENCE = 300;
const STOP_ANSWER_TIME = 2_000; // a server that is being started again answers nobody
const NOTICE_KEPT = 20_000;
const EVENTS_KEPT = 300;
const NAME_KEY = "housefly name";
const TAB_KEY = "housefly tab";

let socket: WebSocket | null = null;
let pause = 250;
let lastId = 0;
const waiting = new Map<number, (answer: Answer) => void>();

/** This tab's id; the server recognizes the viewer by it after a reconnect. */
export function tab(): string {
  const known = sessionStorage.getItem(TAB_KEY);
  if (known) return known;
  const fresh = Array.from(crypto.getRandomValues(new Uint8Array(12)), (byte) =>
    byte.toString(16).padStart(2, "0"),
  ).join("");
  sessionStorage.setItem(TAB_KEY, fresh);
  return fresh;
}

export function myName(): string {
  return localStorage.getItem(NAME_KEY) ?? "";
}

/** Change the name that others see. */
export function rename(name: string): void {
  localStorage.setItem(NAME_KEY, name);
  transmit({ type: "hello", tab: tab(), name });
}

function transmit(message: ClientMessage): boolean {
  if (socket?.readyState !== WebSocket.OPEN) return false;
  socket.send(JSON.stringify(message));
  return true;
}

/** Send a request; resolves with the server's answer, or with a refusal when disconnected. */
export function ask(request: Unnumbered<Request>): Promise<Answer> {
  const id = ++lastId;
  return new Promise((resolve) => {
    if (transmit({ ...request, id } as ClientMessage)) waiting.set(id, resolve);
    else resolve({ type: "refused", id, reason: "no contact with the server" });
  });
}

/** STOP: over the open socket, and by a plain request when nobody confirms it in time. */
export async function stop(): Promise<string> {
  const confirmed = ask({ type: "stop" });
  const late = new Promise<null>((resolve) => setTimeout(() => resolve(null), STOP_PATIENCE));
  if ((await Promise.race([confirmed, late]))?.type === "accepted") return "";
  try {
    const answer = await fetchAsSession("/stop", {
      method: "POST",
      keepalive: true,
      signal: AbortSignal.timeout(STOP_ANSWER_TIME),
    });
    return answer.ok ? "" : "STOP was not accepted";
  } catch {
    return "STOP did not arrive: no contact with the server";
  }
}

/** Connect and stay connected. */
export function connect(): void {
  const line = openSocket("/socket");
  socket = line;
  let wasOpen = false;
  line.onopen = () => {
    wasOpen = true;
    pause = 250;
    transmit({ type: "hello", tab: tab(), name: myName() });
    ping();
  };
  line.onmessage = (event: MessageEvent<string>) =>
    receive(JSON.parse(event.data) as ServerMessage);
  line.onclose = (event) => {
    forgetRequests();
    if (event.code === OPENED_ELSEWHERE) {
      store.contact.value = "elsewhere";
      return;
    }
    store.contact.value = "lost";
    if (!wasOpen) void checkSession();
    setTimeout(connect, pause);
    pause = Math.min(2000, pause * 1.6);
  };
}

async function checkSession(): Promise<void> {
  try {
    if (!proof() || (await fetch("/", { method: "HEAD" })).status === 403)
      store.contact.value = "shut out";
  } catch {
    // The server is away; the next attempt to connect will show it.
  }
}

function forgetRequests(): void {
  for (const [id, resolve] of waiting)
    resolve({ type: "refused", id, reason: "the line to the server broke" });
  waiting.clear();
}

function ping(): void {
  if (transmit({ type: "ping", sent: localNow() })) setTimeout(ping, PING_PERIOD);
}

function receive(message: ServerMessage): void {
  batch(() => {
    switch (message.type) {
      case "welcome":
        assume(message.now);
        store.me.value = message.you;
        store.role.value = message.role;
        store.simulated.value = message.simulated;
        store.events.value = message.events;
        store.trail.value = trailOf(message.trail);
        store.contact.value = "open";
        break;
      case "state":
        store.state.value = message;
        if (message.position)
          store.trail.value = extended(store.trail.value, [
            message.position[0],
            message.position[1],
          ]);
        break;
      case "room":
        store.room.value = message.room;
        break;
      case "preflight":
        store.preflight.value = message.preflight;
        break;
      case "path":
        store.path.value = message;
        break;
      case "link":
        store.link.value = message;
        break;
      case "events":
        tellRefusals(message.events);
        store.events.value = [...store.events.value, ...message.events].slice(-EVENTS_KEPT);
        break;
      case "order_refused":
        store.orderRefused.value = message;
        tellRefusal(message);
        break;
      case "verdict":
        // Each flight has a trail of its own.
        if (message.may_be_airborne && !store.flying.value) store.trail.value = [];
        store.verdict.value = message;
        if (message.stop.progress !== "none") store.stopPress.value = { state: "", words: "" };
        break;
      case "viewers":
        store.viewers.value = message;
        break;
      case "tasks":
        told.value = message;
        break;
      case "invitation_used":
        store.usedInvitations.value = new Set([...store.usedInvitations.value, message.name]);
        break;
      case "pong":
        learn(message.sent, message.now);
        break;
      default:
        answer(message);
    }
  });
}

/** Say where the person looks what the pilot refused; the log has it, too. */
function tellRefusals(events: EventView[]): void {
  const refused = events.filter((event) => event.code === "order_refused").at(-1);
  if (!refused || !store.iFly.value) return;
  const words = sentence(translated(refused.text));
  store.notice.value = words;
  setTimeout(() => store.notice.value === words && (store.notice.value = ""), NOTICE_KEPT);
}

function answer(message: Answer): void {
  const resolve = waiting.get(message.id);
  waiting.delete(message.id);
  if (resolve) resolve(message);
  else if (message.type === "refused") store.notice.value = translated(message.reason);
}
