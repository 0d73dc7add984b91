// What the page needs to speak German.
import type { Speech } from "./speech";
import { DE_TEXTS } from "./de";
import { DE_TOLD } from "./de-told";

const ideas = [
  "Wer ist an der Tür?",
  "Ist jemand da?",
  "Ist alles in Ordnung?",
  "Was ist heute passiert?",
];

export const DE: Speech = { texts: DE_TEXTS, ideas, templates: DE_TOLD };
