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
  Line,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  type Object3D,
  RingGeometry,
  Shape,
  SphereGeometry,
  TorusGeometry,
  TubeGeometry,
  Vector3,
} from "three";
import { WALLS } from "../map/labels";
import { speedClass, type Curve } from "../map/curve-values";
import { runs } from "../map/grid";
import type { Point } from "../store";
import type { GridView, OutlineView, RoomView } from "../wire/messages";
import type { CameraCone } from "../wire/room-messages";

const THIN = 0.02;
const PAD = { inside: 0.3, outside: 0.36 };
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

/** Walls are glass on a base, so that one looks into the room from every side. */
const GLASS = { opacity: 0.13, base: 0.14 };

function extruded(outline: OutlineView, top: number, skin: MeshLambertMaterial): Mesh {
  const depth = Math.max(THIN, top);
  const geometry = new ExtrudeGeometry(shapeOf(outline.corners), { depth, bevelEnabled: false });
  return new Mesh(geometry, skin);
}

/** A solid from the floor to its top: so the planner keeps away from it. */
function solid(outline: OutlineView): Object3D {
  if (WALLS.test(outline.thing)) return wall(outline);
  const skin = new MeshLambertMaterial({ color: new Color(outline.colour) });
  const body = extruded(outline, outline.top, skin);
  body.castShadow = body.receiveShadow = true;
  const edges = new LineSegments(
    new EdgesGeometry(body.geometry),
    new LineBasicMaterial({ color: themed("--ink"), transparent: true, opacity: 0.12 }),
  );
  return new Group().add(body, edges);
}

function wall(outline: OutlineView): Object3D {
  const colour = themed("--wall");
  const { opacity, base } = GLASS;
  const glass = { color: colour, transparent: true, opacity, depthWrite: false };
  return new Group().add(
    extruded(outline, outline.top, new MeshLambertMaterial(glass)),
    extruded(outline, Math.min(base, outline.top), new MeshLambertMaterial({ color: colour })),
  );
}

/** The floor of the room itself, not of the box around it. */
function floor(grid: GridView): Object3D {
  const cell = grid.resolution;
  const [x0, y0] = grid.origin;
  const corners = runs(grid, ".#vi").flatMap(({ i, j, width }) => {
    const [left, low, right, high] = [x0 + i * cell, y0 + j * cell, 0, y0 + (j + 1) * cell];
    const end = right + left + width * cell;
    return [left, low, 0, end, low, 0, end, high, 0, left, low, 0, end, high, 0, left, high, 0];
  });
  const up = corners.map((_, k) => (k % 3 === 2 ? 1 : 0));
  const mesh = new Mesh(
    new BufferGeometry()
      .setAttribute("position", new Float32BufferAttribute(corners, 3))
      .setAttribute("normal", new Float32BufferAttribute(up, 3)),
    new MeshLambertMaterial({ color: themed("--floor-in-space"), side: DoubleSide }),
  );
  mesh.position.z = -THIN;
  mesh.receiveShadow = true;
  return mesh;
}

/** Where the drone starts and lands. */
function pad([x, y]: readonly number[]): Object3D {
  const ring = new Mesh(
    new RingGeometry(PAD.inside, PAD.outside, 48),
    new MeshBasicMaterial({ color: themed("--accent"), transparent: true, opacity: 0.7 }),
  );
  ring.position.set(x!, y!, THIN);
  return ring;
}

/** Floor, furniture, walls and pad. */
export function roomModel(view: RoomView): Object3D {
  const solids = view.outlines.filter((one) => !one.tracked).map(solid);
  return new Group().add(floor(view.grid), pad(view.home), ...solids);
}

/** Where the drone would fly: the way as a line, and a ring on the floor below its end. */
export function goalModel(point: Point, way: readonly Point[], height: number): Object3D {
  const colour = themed("--accent");
  const ring = new Mesh(
    new RingGeometry(PAD.inside - 0.08, PAD.inside, 48),
    new MeshBasicMaterial({ color: colour, side: DoubleSide }),
  );
  ring.position.set(point[0], point[1], THIN);
  const stem = [new Vector3(point[0], point[1], 0), new Vector3(point[0], point[1], height)];
  const line = (points: Vector3[]): Line =>
    new Line(new BufferGeometry().setFromPoints(points), new LineBasicMaterial({ color: colour }));
  const along = way.map(([x, y]) => new Vector3(x, y, height));
  return new Group().add(ring, line(stem), line(along));
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
  hull.castShadow = true;
  body.add(hull, nose);
  for (const [x, y] of [
    [ROTOR, ROTOR],
    [ROTOR, -ROTOR],
    [-ROTOR, ROTOR],
    [-ROTOR, -ROTOR],
  ] as const) {
    const ring = new Mesh(new TorusGeometry(0.1, 0.018, 8, 24), skin);
    ring.position.set(x, y, 0.02);
    ring.castShadow = true;
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
