import { Actions } from "./controls/actions";
import { Mission } from "./controls/mission";
import { StopBar } from "./controls/stop";
import { RoomScreen } from "./live/screen";
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
import { flying, screen, swapped } from "./store";

/** Two screens, one to fly and one of the room; STOP is on both, in the same place. */
export function App() {
  return (
    <div
      class="app"
      data-flying={flying.value}
      data-swapped={swapped.value && screen.value === "fly"}
    >
      <Top />
      {screen.value === "room" ? <RoomScreen /> : <FlyScreen />}
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
