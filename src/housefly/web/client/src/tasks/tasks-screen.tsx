import { sentence } from "../format";
import { VideoView } from "../panels/video";
import { flying } from "../store";
import { Readiness } from "../panels/preflight";
import { ago } from "../live/words";
import { board, silent, unixNow } from "./board";
import { AskBar } from "./ask-bar";
import { ClipSheet } from "./clip-sheet";
import { Memory } from "./memory";
import { Mode } from "./mode";
import { OpenTasks } from "./open-tasks";
import { Questions } from "./questions";
import { Services } from "./services";

/** What can be asked for, what waits and flies, and what came of it. */
export function TasksScreen() {
  return (
    <main class="tasks-deck">
      <Readiness />
      {silent.value && <Silence />}
      <div class="column">
        <AskBar />
        <Questions over={false} />
        <OpenTasks />
        <Services />
      </div>
      <div class="column">
        {flying.value && <VideoView />}
        <Mode />
        <Memory />
      </div>
      <ClipSheet />
    </main>
  );
}

function Silence() {
  const age = board.value && ago(unixNow.value - board.value.at);
  const last = age && ` What is shown here is what was known ${age}.`;
  return (
    <p class="silence" role="alert">
      △ {sentence("the services are not running: nothing can be asked for now")}
      {last}
    </p>
  );
}
