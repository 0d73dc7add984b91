"""Where a drone's hull touches something."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.geometry import Vec3
from housefly.twin.drone_body import DroneBody
from housefly.twin.solids import SolidOwner


@dataclass(frozen=True, slots=True)
class TouchPoint:
    """A point where the hull touches something.

    Attributes:
        owner: what.
        position: world [m].
        outward: unit vector from the other towards the drone, world.
    """

    owner: SolidOwner
    position: Vec3
    outward: Vec3


def touch_points(drone: DroneBody, owners: tuple[SolidOwner | None, ...]) -> list[TouchPoint]:
    """Return where a drone touches something other than the floor.

    Args:
        drone: after a control period.
        owners: of the model's geoms, as this drone meets them.
    """
    count = drone.data.ncon
    if not count:
        return []
    contact, bodies, points = drone.data.contact, drone.model.geom_bodyid, []
    for number, (first, second) in enumerate(contact.geom[:count].tolist()):
        owner = owners[first] or owners[second]
        if owner is None or drone.number not in (bodies[first], bodies[second]):
            continue
        # MuJoCo's normal points from the first geom to the second.
        sign = 1.0 if owners[first] is not None else -1.0
        x, y, z = (sign * contact.frame[number, :3]).tolist()
        px, py, pz = contact.pos[number].tolist()
        points.append(TouchPoint(owner, (px, py, pz), (x, y, z)))
    return points
