// People as plain figures: nobody has measured how tall they are, or where their arms are.
import {
  CapsuleGeometry,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  type Object3D,
  RingGeometry,
  DoubleSide,
} from "three";
import { themed } from "./room-model";
import type { Posture, ShownPerson } from "./shown-people";

const RADIUS = 0.22;
/** How high a figure is [m]; one that lies is as high as it is wide. */
export const TALL: Record<Posture, number> = { upright: 1.7, sitting: 1.2, lying: 2 * RADIUS };
const LONG = 1.7;
/** The strongest figure is still seen through: a sensor says so, and it may be wrong. */
const STRONGEST = 0.6;
/** Who is paler than this was seen long ago: only wires. */
const OLD = 0.7;
const RING = { inside: 0.22, outside: 0.26, above: 0.01 };

/** A capsule for each person, and on the floor the circle that the plan shows. */
export function peopleModel(people: ShownPerson[]): Object3D {
  return new Group().add(...people.map(figure));
}

function figure(one: ShownPerson): Object3D {
  const isLying = one.posture === "lying";
  const isOld = one.strength < OLD;
  const tall = TALL[one.posture];
  const body = new Mesh(
    new CapsuleGeometry(RADIUS, (isLying ? LONG : tall) - 2 * RADIUS, 6, isOld ? 8 : 16),
    new MeshLambertMaterial({
      color: themed(isOld ? "--edge" : "--ink"),
      transparent: true,
      opacity: STRONGEST * one.strength,
      wireframe: isOld,
      depthWrite: false,
      // Who lies on a bed would be inside of it: furniture is drawn full from the floor.
      depthTest: !isLying,
    }),
  );
  body.position.z = tall / 2;
  // A capsule of three.js stands along y.
  if (!isLying) body.rotation.x = Math.PI / 2;
  const group = new Group().add(body, ring(one.strength));
  group.position.set(one.place[0], one.place[1], 0);
  group.rotation.z = isLying ? one.yaw - Math.PI / 2 : 0;
  return group;
}

function ring(strength: number): Object3D {
  const mesh = new Mesh(
    new RingGeometry(RING.inside, RING.outside, 32),
    new MeshBasicMaterial({
      color: themed("--ink"),
      transparent: true,
      opacity: strength,
      side: DoubleSide,
    }),
  );
  mesh.position.z = RING.above;
  return mesh;
}
