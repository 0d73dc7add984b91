// What the page of a new site needs to speak German.
import type { Speech } from "../../messages/speech";
import { DE_TEXTS } from "./de";
import { DE_TOLD } from "./de-told";

export const DE: Speech = { texts: DE_TEXTS, templates: DE_TOLD };
