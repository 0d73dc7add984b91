import { computed } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { listen } from "../live/room-client";
import { VideoView } from "../panels/video";
import { flying, hasDrone } from "../store";
import { Readiness } from "../panels/preflight";
import { readiness } from "../preflight";
import { Sim } from "../sim/sim";
import { ago } from "../live/words";
import { board, silent, unixNow } from "./board";
import { AskBar } from "./ask-bar";
import { ClipSheet } from "./clip-sheet";
import { Memory } from "./memory";
import { Mode } from "./mode";
import { OpenTasks } from "./open-tasks";
import { Questions } from "./questions";
import { Subjects } from "./field";
import { Services } from "./services";
import { t } from "../messages/language";

/** Whether the drone may fly and nothing is to be known; the header says so already. */
const fine = computed(
  () =>
    !hasDrone.value ||
    (readiness.value.known.length === 0 && (readiness.value.ready || flying.value)),
);

/** What can be asked for, what waits and flies, and what came of it. */
export function TasksScreen() {
  useEffect(listen, []);
  return (
    <main class="tasks-deck">
      {!fine.value && <Readiness />}
      {silent.value && <Silence />}
      <div class="column">
        <AskBar />
        <Questions over={false} />
        <Sim />
        <OpenTasks />
        <Services />
      </div>
      <div class="column">
        {flying.value && <VideoView />}
        <Mode />
        <Memory />
      </div>
      <ClipSheet />
      <Subjects />
    </main>
  );
}

function Silence() {
  const age = board.value && ago(unixNow.value - board.value.at);
  const last = age && ` ${t("What is shown here is what was known {age}.", { age })}`;
  return (
    <p class="silence" role="alert">
      △ {t("The services are not running: nothing can be asked for now.")}
      {last}
    </p>
  );
}
