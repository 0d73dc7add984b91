// What brings the present back while the past is looked at: nobody may miss it for that.
import { effect, untracked } from "@preact/signals";
import { goal, type Goal } from "../goal";
import { banner } from "../headline";
import { bellRings, atTheDoor } from "../scene/bell";
import { at } from "../live/store";
import { events, flying, verdict } from "../store";
import { closeFlight, replaying } from "./replay";
import { t, translated } from "../messages/language";

/** What is worth it now, in words, or "". */
function reason(was: Watched): string {
  if (flying.value) return t("the drone may be in the air");
  if (goal.value && goal.value !== was.goal) return t("a goal was chosen");
  if (banner.value && banner.value !== was.banner) return banner.value;
  const stop = verdict.value?.stop.progress ?? "none";
  if (stop !== "none" && stop !== was.stop) return t("STOP was pressed");
  if (bellRings.value && !was.bell) return atTheDoor.value;
  const line = events.value.filter((one) => one.number > was.line && one.severity !== "info").at(0);
  return translated(line?.text ?? "");
}

interface Watched {
  goal: Goal | null;
  banner: string;
  stop: string;
  bell: boolean;
  line: number;
}

function now(): Watched {
  return {
    goal: goal.peek(),
    banner: banner.peek(),
    stop: verdict.peek()?.stop.progress ?? "none",
    bell: bellRings.peek(),
    line: events.peek().at(-1)?.number ?? 0,
  };
}

let was: Watched | null = null;

effect(() => {
  if (!replaying.value && at.value === null) {
    was = null;
    return;
  }
  was ??= untracked(now);
  const words = reason(was);
  if (words) untracked(() => closeFlight(words));
});
