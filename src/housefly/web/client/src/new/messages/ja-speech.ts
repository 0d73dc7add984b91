// What the page of a new site needs to speak Japanese.
import type { Speech } from "../../messages/speech";
import { JA_TEXTS } from "./ja";
import { JA_TOLD } from "./ja-told";

export const JA: Speech = { texts: JA_TEXTS, templates: JA_TOLD };
