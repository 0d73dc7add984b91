// The room as solids for three.js: metres, z up, as everywhere else.
import {
  BufferGeometry,
  CatmullRomCurve3,
  Color,
  DoubleSide,
  EdgesGeometry,
  ExtrudeGeometry,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  type Object3D,
  Shape,
  ShapeGeometry,
  SphereGeometry,
  TorusGeometry,
  TubeGeometry,
  Vector3,
} from "three";
import { WALLS } from "../map/labels";
import { speedClass, type Curve } from "../map/curve-values";
import type { OutlineView, RoomView } from "../wire/messages";
import type { CameraCone } from "../wire/room-messages";

const THIN = 0.02;
const TUBE = { way: 0.05, hull: 0.29 };
/** Cones are drawn so long [m]: whole ones would fill the room. */
const CONE = 0.7;

/** A colour of the style sheet, as the page has it now. */
export function themed(name: string): Color {
  const text = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  return new Color(text || "#888888");
}

function shapeOf(corners: [number, number][]): Shape {
  const shape = new Shape();
  corners.forEach(([x, y], k) => (k ? shape.lineTo(x, y) : shape.moveTo(x, y)));
  shape.closePath();
  return shape;
}

/** A solid from the floor to its top: so the planner keeps away from it. */
function solid(outline: OutlineView): Object3D {
  const isWall = WALLS.test(outline.thing);
  const depth = Math.max(THIN, outline.top);
  const shape = new ExtrudeGeometry(shapeOf(outline.corners), { depth, bevelEnabled: false });
  const colour = isWall ? themed("--wall") : new Color(outline.colour);
  const body = new Mesh(
    shape,
    new MeshLambertMaterial({
      color: colour,
      transparent: isWall,
      opacity: isWall ? 0.16 : 1,
      depthWrite: !isWall,
    }),
  );
  const edges = new LineSegments(
    new EdgesGeometry(shape),
    new LineBasicMaterial({
      color: themed(isWall ? "--wall" : "--thing-edge"),
      transparent: true,
      opacity: isWall ? 0.35 : 1,
    }),
  );
  return new Group().add(body, edges);
}

/** Floor, furniture and walls. */
export function roomModel(view: RoomView): Object3D {
  const [x0, y0, x1, y1] = view.bounds;
  const floor = new Mesh(
    new ShapeGeometry(
      shapeOf([
        [x0, y0],
        [x1, y0],
        [x1, y1],
        [x0, y1],
      ]),
    ),
    new MeshBasicMaterial({ color: themed("--floor"), side: DoubleSide }),
  );
  floor.position.z = -THIN;
  const lines: number[] = [];
  for (let x = Math.ceil(x0); x <= x1; x++) lines.push(x, y0, 0, x, y1, 0);
  for (let y = Math.ceil(y0); y <= y1; y++) lines.push(x0, y, 0, x1, y, 0);
  const grid = new LineSegments(
    new BufferGeometry().setAttribute("position", new Float32BufferAttribute(lines, 3)),
    new LineBasicMaterial({ color: themed("--line") }),
  );
  grid.position.z = -THIN / 2;
  return new Group().add(floor, grid, ...view.outlines.filter((one) => !one.tracked).map(solid));
}

/** What each tracking camera sees first: its place and the beginning of its cone. */
export function cameraCones(lenses: CameraCone[]): Object3D {
  const lines: number[] = [];
  const faces: number[] = [];
  for (const lens of lenses) {
    const from = new Vector3(...lens.position);
    const ends = lens.corners.map((corner) =>
      new Vector3(...corner).sub(from).multiplyScalar(Math.min(CONE, lens.reach)).add(from),
    );
    ends.forEach((end, k) => {
      const next = ends[(k + 1) % ends.length]!;
      lines.push(...from, ...end, ...end, ...next);
      faces.push(...from, ...end, ...next);
    });
  }
  const drawn = (numbers: number[]): BufferGeometry =>
    new BufferGeometry().setAttribute("position", new Float32BufferAttribute(numbers, 3));
  const colour = themed("--accent");
  return new Group().add(
    new LineSegments(
      drawn(lines),
      new LineBasicMaterial({ color: colour, transparent: true, opacity: 0.4 }),
    ),
    new Mesh(
      drawn(faces),
      new MeshBasicMaterial({
        color: colour,
        transparent: true,
        opacity: 0.08,
        side: DoubleSide,
        depthWrite: false,
      }),
    ),
  );
}

/** The planned curve, coloured by speed, in the tube that the hull sweeps. */
export function flightTube(way: Curve): Object3D {
  const points = way.points.map(([x, y], k) => new Vector3(x, y, way.heights[k]!));
  const line = new CatmullRomCurve3(points, false, "centripetal");
  const rings = Math.max(8, 3 * points.length);
  const around = 8;
  const tube = new TubeGeometry(line, rings, TUBE.way, around);
  const top = Math.max(...way.speeds, 0.1);
  const shades = Array.from({ length: 5 }, (_, k) => themed(`--speed-${k}`));
  const colours: number[] = [];
  for (let ring = 0; ring <= rings; ring++) {
    const row = Math.min(way.speeds.length - 1, Math.round((ring / rings) * (points.length - 1)));
    const shade = shades[speedClass(way.speeds[row]!, top)]!;
    for (let k = 0; k <= around; k++) colours.push(shade.r, shade.g, shade.b);
  }
  tube.setAttribute("color", new Float32BufferAttribute(colours, 3));
  return new Group().add(
    new Mesh(tube, new MeshBasicMaterial({ vertexColors: true })),
    new Mesh(
      new TubeGeometry(line, rings, TUBE.hull, 12),
      new MeshLambertMaterial({
        color: themed("--accent"),
        transparent: true,
        opacity: 0.2,
        side: DoubleSide,
        depthWrite: false,
      }),
    ),
  );
}

const ROTOR = 0.18;

/** The drone, with its nose: a hull and four rotors. */
export function droneModel(): { body: Object3D; paint(colour: Color, solid: boolean): void } {
  const skin = new MeshLambertMaterial({ transparent: true });
  const body = new Group();
  const hull = new Mesh(new SphereGeometry(0.11, 16, 8), skin);
  hull.scale.set(1.4, 0.8, 0.5);
  const white = new MeshLambertMaterial({ color: "#fff" });
  const nose = new Mesh(new SphereGeometry(0.05, 12, 8), white);
  nose.position.x = 0.15;
  body.add(hull, nose);
  for (const [x, y] of [
    [ROTOR, ROTOR],
    [ROTOR, -ROTOR],
    [-ROTOR, ROTOR],
    [-ROTOR, -ROTOR],
  ] as const) {
    const ring = new Mesh(new TorusGeometry(0.1, 0.018, 8, 24), skin);
    ring.position.set(x, y, 0.02);
    body.add(ring);
  }
  return {
    body,
    paint(colour, isSolid) {
      skin.color = colour;
      skin.opacity = isSolid ? 1 : 0.45;
      skin.wireframe = !isSolid;
    },
  };
}
