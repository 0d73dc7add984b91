// All keys in one table: the help panel shows it, keys.ts obeys it.
import { signal } from "@preact/signals";
import { cutMotors, home, land, service, stop } from "./commands";
import { nudge } from "./goal";
import type { Hold } from "./hold";
import { open, panel, screen, swapped, type Screen } from "./store";

export interface Key {
  /** `KeyboardEvent.key`; letters in lower case. */
  keys: string[];
  shift?: boolean;
  shown: string;
  does: string;
  press?: (key: string) => void;
  hold?: Hold;
}

const ARROWS: Record<string, [number, number]> = {
  arrowleft: [-1, 0],
  arrowright: [1, 0],
  arrowup: [0, 1],
  arrowdown: [0, -1],
};

export const SPACE = " ";

const LETTERS_KEY = "housefly letters";

/** Whether single letters do something: who speaks to the machine, or trembles, may not want it. */
export const letters = signal(localStorage.getItem(LETTERS_KEY) !== "off");

export function useLetters(on: boolean): void {
  letters.value = on;
  localStorage.setItem(LETTERS_KEY, on ? "on" : "off");
}

/** Whether a key is a single printed sign; STOP's Space is none. */
export const isLetter = (key: string): boolean => key.length === 1 && key !== SPACE;

const toggle = (name: Screen) => (): void => open(screen.value === name ? "live" : name);
const toggleHelp = (): void => void (panel.value = panel.value === "help" ? "" : "help");
const swapViews = (): void => void (swapped.value = !swapped.value);
const closePanel = (): void => void (panel.value = "");
const nudgeGoal = (key: string): void => nudge(...ARROWS[key]!);

export const KEYS: Key[] = [
  {
    keys: [SPACE],
    shown: "Space",
    does: "STOP: hover at once; in flight whatever has the focus",
    press: () => void stop(),
  },
  {
    keys: ["escape"],
    shift: true,
    shown: "Shift + Esc, held 1 s",
    does: "Cut motors: the drone falls",
    hold: cutMotors,
  },
  { keys: ["l"], shown: "L", does: "Land here", press: () => land() },
  { keys: ["h"], shown: "H", does: "Fly home and land", press: () => home() },
  {
    keys: Object.keys(ARROWS),
    shown: "Arrow keys",
    does: "Move the goal by one cell",
    press: nudgeGoal,
  },
  {
    keys: [],
    shown: "W A S D or arrows, R F",
    does: "While Move by hand is on: move the drone, up and down",
  },
  {
    keys: [],
    shown: "+ − 0",
    does: "Map with the focus: nearer, farther, whole room",
  },
  {
    keys: ["enter"],
    shown: "Enter, held",
    does: "Send the drone to look and come back",
    hold: service,
  },
  { keys: ["m"], shown: "M", does: "Swap map and picture", press: swapViews },
  { keys: ["r"], shown: "R", does: "Edit the room, and back", press: toggle("edit") },
  { keys: ["t"], shown: "T", does: "Go to the tasks, and back", press: toggle("tasks") },
  { keys: ["?"], shown: "?", does: "Show or hide this list", press: toggleHelp },
  { keys: ["escape"], shown: "Esc", does: "Close a panel", press: closePanel },
];
