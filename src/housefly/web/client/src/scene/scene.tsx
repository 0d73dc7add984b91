import { useEffect } from "preact/hooks";
import { Orders } from "../controls/orders";
import { listen } from "../live/room-client";
import { MapView } from "../map/map";
import { Readiness } from "../panels/preflight";
import { VideoView } from "../panels/video";
import { hasDrone } from "../store";
import { Ask } from "./ask";
import { Foot } from "./foot";
import { NoDrone } from "./no-drone";
import { Side } from "./side";

/** The house now: map and picture, what to ask of it, and what to order. */
export function LiveScene() {
  useEffect(listen, []);
  return (
    <main class="scene">
      <Ask />
      <MapView />
      {hasDrone.value ? (
        <>
          <VideoView />
          <Orders />
          <Readiness />
        </>
      ) : (
        <NoDrone />
      )}
      <Side />
      <Foot />
    </main>
  );
}
