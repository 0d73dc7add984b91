// What the page needs to speak Japanese.
import type { Speech } from "./speech";
import { JA_TEXTS } from "./ja";
import { JA_TOLD } from "./ja-told";

const ideas = ["玄関に誰がいますか", "誰かいますか", "大丈夫ですか", "今日何がありましたか"];

export const JA: Speech = { texts: JA_TEXTS, ideas, templates: JA_TOLD };
