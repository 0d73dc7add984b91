"""Where the drone's hull touches something."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.geometry import Vec3
from housefly.twin.physics import Physics
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


def touch_points(physics: Physics, owners: tuple[SolidOwner | None, ...]) -> list[TouchPoint]:
    """Return where the drone touches something other than the floor.

    Args:
        physics: after a control period.
        owners: of the model's geoms.
    """
    count = physics.data.ncon
    if not count:
        return []
    contact, points = physics.data.contact, []
    for number, (first, second) in enumerate(contact.geom[:count].tolist()):
        owner = owners[first] or owners[second]
        if owner is None:
            continue
        # MuJoCo's normal points from the first geom to the second.
        sign = 1.0 if owners[first] is not None else -1.0
        x, y, z = (sign * contact.frame[number, :3]).tolist()
        px, py, pz = contact.pos[number].tolist()
        points.append(TouchPoint(owner, (px, py, pz), (x, y, z)))
    return points
