import { effect, signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import {
  AmbientLight,
  BufferGeometry,
  DirectionalLight,
  Line,
  LineDashedMaterial,
  type Object3D,
  PerspectiveCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { coverage } from "../live/store";
import { learnCoverage } from "../live/room-client";
import { milliseconds } from "../format";
import { replaying } from "../replay/replay";
import { poseAge, room } from "../store";
import { peopleModel } from "./people-model";
import { PeopleNames, placeNames } from "./people-names";
import { cameraCones, droneModel, flightTube, roomModel, themed } from "./room-model";
import { shownDrone } from "./shown";
import { shownCurve } from "./shown-curve";
import { shownFigures, type ShownPerson } from "./shown-people";
import { t } from "../messages/language";

const KIND = { live: "--accent", old: "--edge", recorded: "--warn" } as const;

/** Why nothing can be drawn in space, in words, or "". */
const problem = signal("");

/** The room in space, with the cone of each tracking camera and the tube of the flight. */
export function SpaceView() {
  const box = useRef<HTMLDivElement>(null);
  useEffect(() => {
    void learnCoverage();
    problem.value = "";
    try {
      return drawn(box.current!);
    } catch {
      problem.value = t(
        "This browser cannot draw in space (WebGL is off or missing). The plan shows the same.",
      );
      return undefined;
    }
  }, []);
  const drone = shownDrone.value;
  return (
    <>
      <div class="space-canvas" ref={box} role="img" aria-label={t("The room in space")} />
      {!problem.value && <PeopleNames />}
      {problem.value && (
        <p class="veil" role="status">
          {problem.value}
        </p>
      )}
      {!problem.value && (
        <p class="space-words">
          {replaying.value && <strong>{t("Recorded, not live.")} </strong>}
          {!drone && `${t("Nobody sees the drone.")} `}
          {drone?.kind === "old" && 
            `${t("The drone was seen {time} ago.", { time: milliseconds(poseAge.value) })} `}
          <span class="how">
            {t("Drag to turn, two fingers or the wheel to come nearer.")}{" "}
            {t("People are where they were last seen; pale is long ago.")}
          </span>
        </p>
      )}
    </>
  );
}

/** Draw into an element until the returned function is called; throws without WebGL. */
function drawn(box: HTMLElement): () => void {
  const renderer = new WebGLRenderer({ antialias: true, alpha: true });
  renderer.setPixelRatio(Math.min(2, devicePixelRatio));
  box.append(renderer.domElement);
  const scene = new Scene();
  const camera = new PerspectiveCamera(50, 1, 0.1, 100);
  camera.up.set(0, 0, 1);
  const sun = new DirectionalLight("#fff", 1.6);
  sun.position.set(3, -5, 9);
  scene.add(new AmbientLight("#fff", 1.6), sun);
  const controls = new OrbitControls(camera, renderer.domElement);
  controls.maxPolarAngle = 0.49 * Math.PI;
  let waits = false;
  /** A picture is drawn when something has changed, and never twice a frame. */
  const draw = (): void => {
    if (waits) return;
    waits = true;
    requestAnimationFrame(() => {
      waits = false;
      renderer.render(scene, camera);
      const names = box.parentElement?.querySelector<HTMLElement>(".space-names");
      if (names) placeNames(names, camera);
    });
  };
  controls.addEventListener("change", draw);
  const sizes = new ResizeObserver(([entry]) => {
    const { width, height } = entry!.contentRect;
    if (!width || !height) return;
    renderer.setSize(width, height);
    camera.aspect = width / height;
    aspect.value = Math.round(4 * camera.aspect) / 4;
    camera.updateProjectionMatrix();
    draw();
  });
  sizes.observe(box);
  const aspect = signal(0);
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const theme = signal(0);
  const repaint = (): void => void (theme.value += 1);
  dark.addEventListener("change", repaint);
  const parts = [
    shownPart(scene, draw, () => (void theme.value, room.value && roomModel(room.value))),
    shownPart(
      scene,
      draw,
      () => (void theme.value, coverage.value && cameraCones(coverage.value.lenses ?? [])),
    ),
    shownPart(
      scene,
      draw,
      () => (void theme.value, shownCurve.value && flightTube(shownCurve.value)),
    ),
    shownPart(
      scene,
      draw,
      () => (
        void theme.value, peopleModel(JSON.parse(shownFigures.value) as ShownPerson[])
      ),
    ),
    effect(() => {
      if (!room.value || aspect.value === 0) return;
      look(camera, controls, room.value.bounds, aspect.value);
      draw();
    }),
    drone(scene, draw),
  ];
  return () => {
    parts.forEach((end) => end());
    dark.removeEventListener("change", repaint);
    sizes.disconnect();
    controls.dispose();
    renderer.dispose();
    renderer.domElement.remove();
  };
}

/** Keep a part of the scene as what it is made of says. */
function shownPart(scene: Scene, draw: () => void, made: () => Object3D | null): () => void {
  let shown: Object3D | null = null;
  return effect(() => {
    if (shown) scene.remove(shown);
    shown?.traverse((one) => (one as { geometry?: BufferGeometry }).geometry?.dispose());
    shown = made();
    if (shown) scene.add(shown);
    draw();
  });
}

/** The drone where it is, and a dashed line from it down to the floor. */
function drone(scene: Scene, draw: () => void): () => void {
  const { body, paint } = droneModel();
  const plumb = new Line(
    new BufferGeometry(),
    new LineDashedMaterial({ dashSize: 0.08, gapSize: 0.06 }),
  );
  scene.add(body, plumb);
  return effect(() => {
    const now = shownDrone.value;
    body.visible = plumb.visible = now !== null;
    if (now) {
      const [x, y, z] = now.place;
      const colour = themed(KIND[now.kind]);
      paint(colour, now.kind === "live");
      body.position.set(x, y, z);
      body.rotation.z = now.yaw;
      plumb.geometry.setFromPoints([new Vector3(x, y, 0), new Vector3(x, y, z)]);
      plumb.material.color = colour;
      plumb.computeLineDistances();
    }
    draw();
  });
}

const WIDE = 2.2;

/** From above the near wall, at the middle of the room, as near as it fits. */
function look(
  camera: PerspectiveCamera,
  controls: OrbitControls,
  [x0, y0, x1, y1]: [number, number, number, number],
  aspect: number,
): void {
  const [x, y] = [(x0 + x1) / 2, (y0 + y1) / 2];
  const far = Math.max(x1 - x0, WIDE * (y1 - y0)) * Math.max(1.04, WIDE / Math.max(aspect, 0.1));
  camera.position.set(x, y - 0.33 * far, 0.42 * far);
  controls.target.set(x, y, 0.5);
  controls.update();
}
