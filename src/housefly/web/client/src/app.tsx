import { Actions } from "./controls/actions";
import { Errand } from "./controls/errand";
import { StopBar } from "./controls/stop";
import { MapView } from "./map/map";
import { Announcer } from "./panels/announcer";
import { Battery } from "./panels/battery";
import { Control } from "./panels/control";
import { Help } from "./panels/help";
import { Log } from "./panels/log";
import { Readings } from "./panels/readings";
import { Top } from "./panels/top";
import { VideoView } from "./panels/video";
import { swapped } from "./store";

/** The one screen: map and picture, what the drone says, what one may ask of it, and STOP. */
export function App() {
  return (
    <div class="app" data-swapped={swapped.value}>
      <Top />
      <main class="deck">
        <MapView />
        <VideoView />
        <section class="command" aria-label="Orders">
          <Errand />
          <Actions />
        </section>
        <section class="side" aria-label="Drone and links">
          <Battery />
          <Readings />
          <Log />
        </section>
      </main>
      <StopBar />
      <Help />
      <Control />
      <Announcer />
    </div>
  );
}
