import { computed } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { choosePoint } from "../goal";
import { percent } from "../format";
import { PastBanner } from "../live/past-banner";
import { Layers, showsMargins, showsThings } from "../live/layers";
import {
  at,
  hindering,
  nameOf,
  showsCoverage,
  situations,
  things,
  trouble,
} from "../live/store";
import { placeless, ThingsLayer } from "../live/things";
import { isWorry, worthSaying } from "../live/words";
import { SwapButton } from "../panels/video";
import { RecordedBanner } from "../replay/recorded";
import { replaying } from "../replay/replay";
import { hasDrone, screen } from "../store";
import { EarlierButton, inSpace, RoomInSpace, SpaceButton } from "../view3d/space-button";
import { DroneLayer } from "./drone";
import { GoalLayer, PathLayer } from "./goal-layer";
import { listenToHands } from "./gestures";
import { HeightStrip } from "./height";
import { lazyPart } from "../lazy-part";
import type { Projection } from "./projection";
import { RoomLayer } from "./room";
import { moving, projection, size, zoom } from "./view";
import { ToTheDrone, WholeRoomButton, ZoomButtons } from "./zoom";
import { t, translated } from "../messages/language";

const SpeedLegend = lazyPart(async () => (await import("../later")).SpeedLegend);
const HeightProfile = lazyPart(async () => (await import("../later")).HeightProfile);
const CoverageLayer = lazyPart(async () => (await import("../later")).CoverageLayer);
const CoverageLegend = lazyPart(async () => (await import("../later")).CoverageLegend);
const Turning = lazyPart(async () => (await import("../later")).Turning);
const RecordedLayer = lazyPart(
  async () => (await import("../later")).RecordedLayer,
);

interface FrameProps {
  label: string;
  /** Where a tap goes: the point of the room. */
  onPoint?: (point: [number, number]) => void;
  children: (to: Projection) => ComponentChildren;
}

/** A floor plan to zoom and move; one at a time is on the screen. */
export function PlanFrame({ label, onPoint, children }: FrameProps) {
  const frame = useRef<HTMLDivElement>(null);
  useEffect(() => listenToHands(frame.current!, () => screen.peek() === "edit"), []);
  useEffect(() => {
    const observer = new ResizeObserver(([entry]) => {
      size.value = [entry!.contentRect.width, entry!.contentRect.height];
    });
    observer.observe(frame.current!);
    return () => observer.disconnect();
  }, []);
  const to = projection.value;
  const click = (event: MouseEvent): void => {
    const box = (event.currentTarget as SVGElement).getBoundingClientRect();
    onPoint?.(to!.back([event.clientX - box.left, event.clientY - box.top]));
  };
  return (
    <>
      <div class="plan-view" ref={frame} data-moving={moving.value} data-zoomed={zoom.value > 1}>
        {to ? (
          <svg
            width={to.width}
            height={to.height}
            tabindex={0}
            role="group"
            aria-label={label}
            data-scale={to.scale}
            data-angle={to.angle}
            data-origin={to.at([0, 0]).join(" ")}
            data-scrolls={onPoint ? undefined : ""}
            onClick={click}
          >
            {children(to)}
          </svg>
        ) : (
          <p class="veil">{t("Waiting for the room")}</p>
        )}
        <WholeRoomButton />
        <Turning />
        {to && <ToTheDrone to={to} />}
      </div>
      <ZoomButtons />
    </>
  );
}

const past = computed(() => at.value !== null || replaying.value);
/** Whether the room tells who and what is where. */
const heard = computed(() => things.value.size > 0 && !trouble.value);

/** The floor plan: who and what is where, and click where the drone should go. */
export function MapView() {
  const recorded = replaying.value;
  return (
    <section
      class="view map live"
      aria-label={t("Map of the room")}
      data-past={past.value}
      data-recorded={recorded}
      data-margins={showsMargins.value}
      data-coverage={showsCoverage.value}
    >
      {inSpace.value ? (
        <RoomInSpace />
      ) : (
        <PlanFrame
          label={
            hasDrone.value
              ? t("Floor plan with the drone. Arrow keys move the goal; a list of places follows.")
              : t("Floor plan of the room")
          }
          {...(past.value || !hasDrone.value
            ? {}
            : { onPoint: (point: [number, number]) => choosePoint(point) })}
        >
          {(to) => (
            <>
              <RoomLayer to={to} visitors={!heard.value && !past.value} />
              <CoverageLayer to={to} />
              {!past.value && <PathLayer to={to} />}
              {!past.value && <GoalLayer to={to} />}
              {showsThings.value && <ThingsLayer to={to} />}
              {recorded ? <RecordedLayer to={to} /> : !past.value && <DroneLayer to={to} />}
            </>
          )}
        </PlanFrame>
      )}
      {!past.value && hasDrone.value && !inSpace.value && <HeightStrip />}
      {!past.value && hasDrone.value && !inSpace.value && <HeightProfile />}
      <Notes />
      <Layers />
      <div class="turns">
        <EarlierButton />
        <SpaceButton />
      </div>
      {recorded ? <RecordedBanner /> : <PastBanner />}
      {hasDrone.value && <SwapButton to="map" />}
    </section>
  );
}

/** What the map cannot draw, in words. */
function Notes() {
  const lost = placeless();
  return (
    <ul class="legend" aria-label={t("Legend")}>
      <CoverageLegend />
      {trouble.value && (
        <li class="plain">
          <span role="status">
            △{" "}
            {t("People and things are not shown: {why}.", {
              why: translated(trouble.value),
            })}
          </span>
        </li>
      )}
      <SpeedLegend />
      {showsMargins.value && <li class="virtual">{t("kept free by order")}</li>}
      {showsMargins.value && <li class="inflated">{t("too close to fly")}</li>}
      {hasDrone.value && hindering.value > 0 && (
        <li class="plain">
          △{" "}
          {t("{n} obstacle that is not on the map|{n} obstacles that are not on the map", {
            n: hindering.value,
          })}
        </li>
      )}
      {worthSaying(situations.value)
        .filter((one) => isWorry(one.kind))
        .map((one) => (
          <li class="trouble" key={`${one.kind} ${one.thing}`}>
            △ {nameOf(one.thing)}: {translated(one.words)},{" "}
            {t("{p} sure", { p: percent(one.confidence) })}
            {one.evidence && `; ${one.evidence}`}
            {trouble.value && `, ${t("told before")}`}
          </li>
        ))}
      {lost.length > 0 && (
        <li class="plain">
          {t("Place unknown: {names}", {
            names: lost
              .map((one) =>
                t("{name} (in {holder})", { name: one.name, holder: nameOf(one.inside) }),
              )
              .join(", "),
          })}
        </li>
      )}
    </ul>
  );
}
