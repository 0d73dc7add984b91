import { computed, effect, signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import {
  AmbientLight,
  BufferGeometry,
  DirectionalLight,
  Line,
  LineDashedMaterial,
  type Object3D,
  PCFShadowMap,
  PerspectiveCamera,
  Plane,
  Raycaster,
  Scene,
  Vector2,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { choosePoint, goal } from "../goal";
import { at, coverage, showsCoverage } from "../live/store";
import { milliseconds } from "../format";
import { replaying } from "../replay/replay";
import { hasDrone, poseAge, room } from "../store";
import { peopleModel } from "./people-model";
import { PeopleNames, placeNames } from "./people-names";
import { cameraCones, droneModel, flightTube, goalModel, roomModel, themed } from "./room-model";
import { shownDrone, type ShownDrone } from "./shown";
import { shownCurve } from "./shown-curve";
import { shownFigures, type ShownPerson } from "./shown-people";
import { t } from "../messages/language";

const KIND = { live: "--accent", old: "--edge", recorded: "--warn" } as const;

/** Whether somebody has turned the room: then nobody needs to be told how. */
const turned = signal(false);
/** Why nothing can be drawn in space, in words, or "". */
const problem = signal("");

/** The room in space, with the cone of each tracking camera and the tube of the flight. */
export function SpaceView() {
  const box = useRef<HTMLDivElement>(null);
  useEffect(() => {
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
          {!turned.value && (
            <span class="how">
              {t("Drag to turn, two fingers or the wheel to come nearer.")}{" "}
              {t("People are where they were last seen; pale is long ago.")}
            </span>
          )}
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
  const camera = new PerspectiveCamera(30, 1, 0.5, 200);
  camera.up.set(0, 0, 1);
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  renderer.shadowMap.autoUpdate = false;
  const sun = sunlight();
  scene.add(new AmbientLight("#fff", 1.5), sun, sun.target);
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
  /** What casts a shadow has changed, too; a room that is only turned keeps its shadows. */
  const redraw = (): void => {
    renderer.shadowMap.needsUpdate = true;
    draw();
  };
  controls.addEventListener("change", draw);
  controls.addEventListener("start", () => (turned.value = true));
  const forgetTaps = chooseByTap(renderer.domElement, camera);
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
    shownPart(scene, redraw, () => (void theme.value, room.value && roomModel(room.value))),
    shownPart(
      scene,
      redraw,
      () => (
        void theme.value,
        showsCoverage.value && coverage.value && cameraCones(coverage.value.lenses ?? [])
      ),
    ),
    shownPart(
      scene,
      redraw,
      () => (void theme.value, shownCurve.value && flightTube(shownCurve.value)),
    ),
    shownPart(scene, redraw, () => (void theme.value, goalShown())),
    shownPart(
      scene,
      redraw,
      () => (
        void theme.value, peopleModel(JSON.parse(shownFigures.value) as ShownPerson[])
      ),
    ),
    effect(() => {
      if (!room.value || aspect.value === 0) return;
      light(sun, room.value.bounds);
      look(camera, controls, room.value.bounds, aspect.value);
      redraw();
    }),
    drone(scene, redraw),
  ];
  return () => {
    parts.forEach((end) => end());
    forgetTaps();
    dark.removeEventListener("change", repaint);
    sizes.disconnect();
    controls.dispose();
    renderer.dispose();
    renderer.domElement.remove();
  };
}

/** From behind the near wall on the left, as in the plan's drawings: shadows fall into the room. */
function sunlight(): DirectionalLight {
  const sun = new DirectionalLight("#fff6e8", 1.9);
  sun.castShadow = true;
  sun.shadow.mapSize.set(2048, 2048);
  sun.shadow.bias = -0.0006;
  sun.shadow.normalBias = 0.02;
  sun.shadow.radius = 5;
  return sun;
}

/** Light all of the room, and no more: the shadow's points are shared out over it. */
function light(sun: DirectionalLight, [x0, y0, x1, y1]: Bounds): void {
  const [x, y, reach] = [(x0 + x1) / 2, (y0 + y1) / 2, Math.hypot(x1 - x0, y1 - y0) / 2];
  sun.target.position.set(x, y, 0);
  sun.position.set(x - 0.35 * reach, y - 0.5 * reach, 1.3 * reach);
  Object.assign(sun.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach });
  sun.shadow.camera.far = 4 * reach;
  sun.shadow.camera.updateProjectionMatrix();
}

/** The goal that is being chosen, with its way. */
function goalShown(): Object3D | null {
  const aim = goal.value;
  if (!aim || replaying.value) return null;
  const way = aim.plan?.path?.waypoints ?? [];
  return goalModel(aim.point, way, room.value?.flight_height ?? 1);
}

/** A tap on the floor chooses a goal, as on the plan; a drag turns the room. */
function chooseByTap(canvas: HTMLElement, camera: PerspectiveCamera): () => void {
  let from: [number, number] | null = null;
  const floor = new Plane(new Vector3(0, 0, 1));
  const down = (event: PointerEvent): void => void (from = [event.clientX, event.clientY]);
  const up = (event: PointerEvent): void => {
    const moved = from && Math.hypot(event.clientX - from[0], event.clientY - from[1]);
    if (moved === null || moved > TAP || !hasDrone.peek() || at.peek() !== null) return;
    if (replaying.peek()) return;
    const { left, top, width, height } = canvas.getBoundingClientRect();
    const ray = new Raycaster();
    const [x, y] = [(event.clientX - left) / width, (event.clientY - top) / height];
    ray.setFromCamera(new Vector2(2 * x - 1, 1 - 2 * y), camera);
    const hit = ray.ray.intersectPlane(floor, new Vector3());
    if (hit) choosePoint([hit.x, hit.y]);
  };
  canvas.addEventListener("pointerdown", down);
  canvas.addEventListener("pointerup", up);
  return () => {
    canvas.removeEventListener("pointerdown", down);
    canvas.removeEventListener("pointerup", up);
  };
}

/** Keep a part of the scene as what it is made of says. */
function shownPart(
  scene: Scene,
  draw: () => void,
  made: () => Object3D | null | false,
): () => void {
  let shown: Object3D | null | false = null;
  return effect(() => {
    if (shown) scene.remove(shown);
    if (shown) shown.traverse((one) => (one as { geometry?: BufferGeometry }).geometry?.dispose());
    shown = made();
    if (shown) scene.add(shown);
    draw();
  });
}

const CENTIMETRES = 100;
const rounded = (value: number): number => Math.round(CENTIMETRES * value) / CENTIMETRES;

/** The drone's pose to a centimetre and half a degree: a drone that rests is not drawn anew. */
const drawnPose = computed(() => {
  const now = shownDrone.value;
  return JSON.stringify(now && { ...now, place: now.place.map(rounded), yaw: rounded(now.yaw) });
});

/** The drone where it is, and a dashed line from it down to the floor. */
function drone(scene: Scene, draw: () => void): () => void {
  const { body, paint } = droneModel();
  const plumb = new Line(
    new BufferGeometry(),
    new LineDashedMaterial({ dashSize: 0.08, gapSize: 0.06 }),
  );
  scene.add(body, plumb);
  return effect(() => {
    const now = JSON.parse(drawnPose.value) as ShownDrone | null;
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

type Bounds = [number, number, number, number];

const WIDE = 2.2;
/** A finger moves so far at most in a tap [px]. */
const TAP = 6;

/** From above the near wall, at the middle of the room, as near as it fits. */
function look(
  camera: PerspectiveCamera,
  controls: OrbitControls,
  [x0, y0, x1, y1]: Bounds,
  aspect: number,
): void {
  const [x, y] = [(x0 + x1) / 2, (y0 + y1) / 2];
  const far = Math.max(x1 - x0, WIDE * (y1 - y0)) * Math.max(1.04, WIDE / Math.max(aspect, 0.1));
  camera.position.set(x, y - 0.6 * far, 0.78 * far);
  controls.target.set(x, y, 0.5);
  controls.update();
}
