// The list of the drones, where a room has several: which there are, which one this page shows.
// A script of its own: the page of a room with one drone does not load it.
import type { DronesView, DroneView } from "../wire/room-messages";
import { fetchAsSession } from "../wire/session";

const PERIOD = 1000;
const ANSWER_TIME = 2000;

// Their names, in the air, on the ground, stopped, land all, stop one, no answer.
const WORDS = {
  en: ["Drones", "in the air", "on the ground", "stopped", "Land all", "Stop {name}", "no answer"],
  ja: ["ドローン", "飛行中", "地上", "停止中", "すべて着陸", "{name}を停止", "応答なし"],
  de: [
    ...["Drohnen", "in der Luft", "am Boden", "gestoppt"],
    ...["Alle landen", "{name} stoppen", "keine Antwort"],
  ],
};

type Language = keyof typeof WORDS;
function word(number: number): string {
  const spoken = document.documentElement.lang;
  return WORDS[spoken in WORDS ? (spoken as Language) : "en"][number] ?? "";
}
const shown = new URLSearchParams(location.search).get("drone");

const list = document.createElement("nav");
list.className = "drones";
document.body.prepend(list);

function made<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  text: string,
  act?: () => void,
): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  element.textContent = text;
  if (act) element.onclick = act;
  return element;
}

const tell = (path: string): Promise<unknown> =>
  fetchAsSession(path, { method: "POST", keepalive: true }).catch(() => undefined);

function state(drone: DroneView): string {
  const battery = drone.battery === null ? "" : ` · ${Math.round(100 * drone.battery)} %`;
  const standing = word(drone.stopped ? 3 : drone.may_be_airborne ? 1 : 2);
  return `${standing}${battery}${drone.control && ` · ${drone.control}`}`;
}

/** One drone: a way to its page, what it does, and a STOP for it alone. */
function row(drone: DroneView, isShown: boolean): HTMLElement {
  const link = made("a", drone.name);
  link.href = `/?drone=${drone.name}`;
  if (isShown) link.setAttribute("aria-current", "page");
  const stop = made("button", "STOP", () => void tell(`/stop?drone=${drone.name}`));
  stop.setAttribute("aria-label", word(5).replace("{name}", drone.name));
  const item = document.createElement("li");
  item.append(link, made("span", state(drone)), stop);
  return item;
}

async function refresh(): Promise<void> {
  const answer = await fetchAsSession("/drones", { signal: AbortSignal.timeout(ANSWER_TIME) });
  const { drones } = (await answer.json()) as DronesView;
  list.setAttribute("aria-label", word(0));
  const rows = document.createElement("ul");
  rows.append(...drones.map((drone, place) => row(drone, shown ? drone.name === shown : !place)));
  const land = made("button", word(4), () => void tell("/land"));
  list.replaceChildren(rows, land);
}

/** Browsers without WebCodecs ask for pictures by an address that names no drone. */
function namePictures(): void {
  if (!shown) return;
  for (const picture of document.querySelectorAll<HTMLImageElement>('img[src^="/video.mjpeg"]'))
    if (!picture.src.includes("&drone=")) picture.src += `&drone=${shown}`;
}

async function keepFresh(): Promise<void> {
  namePictures();
  // What has the focus stays where it is, so that nobody presses what has just moved.
  if (!list.contains(document.activeElement))
    await refresh().catch(() => list.replaceChildren(made("p", word(6))));
  setTimeout(() => void keepFresh(), PERIOD);
}

void keepFresh();
