import type { ComponentChild } from "preact";
import { Actions } from "./controls/actions";
import { Mission } from "./controls/mission";
import { StopBar } from "./controls/stop";
import { MapView } from "./map/map";
import { Announcer } from "./panels/announcer";
import { Battery } from "./panels/battery";
import { Control } from "./panels/control";
import { Checks, Readiness } from "./panels/preflight";
import { Help } from "./panels/help";
import { Log } from "./panels/log";
import { Readings } from "./panels/readings";
import { Top } from "./panels/top";
import { VideoView } from "./panels/video";
import { lazyScreen } from "./lazy-screen";
import { flying, screen, swapped, type Screen } from "./store";
import { Questions } from "./tasks/questions";

const SCREENS: Record<Screen, () => ComponentChild> = {
  fly: FlyScreen,
  room: lazyScreen(async () => (await import("./live/screen")).RoomScreen),
  tasks: lazyScreen(async () => (await import("./tasks/tasks-screen")).TasksScreen),
};

/** Three screens: to fly, of the room, of the tasks; STOP is on each, in the same place. */
export function App() {
  const Shown = SCREENS[screen.value];
  return (
    <div
      class="app"
      data-flying={flying.value}
      data-swapped={swapped.value && screen.value === "fly"}
    >
      <Top />
      <Shown key={screen.value} />
      {screen.value !== "tasks" && <Questions over={true} />}
      <StopBar />
      <Checks />
      <Help />
      <Control />
      <Announcer />
    </div>
  );
}

/** Map and picture, what the drone says, and what one may ask of it. */
function FlyScreen() {
  return (
    <main class="deck">
      <Readiness />
      <MapView />
      <VideoView />
      <section class="command" aria-label="Orders">
        <Mission />
        <Actions />
      </section>
      <section class="side" aria-label="Drone and links">
        <Battery />
        <Readings />
        <Log />
      </section>
    </main>
  );
}
