import { useEffect } from "preact/hooks";
import { listen } from "../live/room-client";
import { MapView } from "../map/map";
import { Readiness } from "../panels/preflight";
import { VideoView } from "../panels/video";
import { hasDrone } from "../store";
import { Dock } from "./dock";
import { lazyPart } from "../lazy-part";
import { Foot } from "./foot";
import { isPhone } from "./phone";
import { Quick } from "./quick";
import { Side } from "./side";

const OnPhone = lazyPart(async () => (await import("../later")).OnPhone);

/** The house now: the room fills the stage; beneath it what to ask and to order. */
export function LiveScene() {
  useEffect(listen, []);
  return (
    <main class="scene">
      <MapView />
      {hasDrone.value && (
        <>
          <VideoView />
          <Readiness />
        </>
      )}
      <Foot />
      <Side />
      {isPhone.value && <OnPhone />}
      <Dock />
      <Quick />
    </main>
  );
}
