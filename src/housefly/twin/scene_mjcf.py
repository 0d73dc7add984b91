"""The MuJoCo model that physics, rays and pictures share."""

from __future__ import annotations

from housefly.config.site import Site
from housefly.room.mjcf import room_to_mjcf
from housefly.room.model import Room
from housefly.twin.drone_stands import drone_stands
from housefly.twin.movable import Movable, movable_body
from housefly.twin.people.bodies import people_bodies
from housefly.twin.people.script import PersonScript
from housefly.twin.quadrotor.body import drone_body

CEILING = "solid ceiling"
"""Name of the geom that stops the drone below the ceiling; no ray and no camera sees it."""


def scene_mjcf(
    site: Site,
    room: Room,
    people: tuple[PersonScript, ...] = (),
    movables: tuple[Movable, ...] = (),
    first: str = "",
) -> str:
    """Return the MJCF of the room with its drones on their pads; needs no MuJoCo.

    People and movables are included, out of the room. The drone named first is ``BODY``; else that
    is the first of the site.
    """
    stands = drone_stands(site, room, first)
    return room_to_mjcf(
        room,
        bodies="".join(drone_body(one.config, one.pad, one.yaw, one.body) for one in stands)
        + _ceiling(room)
        + people_bodies(people)
        + "".join(movable_body(movable) for movable in movables),
    )


def _ceiling(room: Room) -> str:
    """Return a plane that looks down and can be touched; the room's own is only painted."""
    return (
        f'<geom name="{CEILING}" type="plane" pos="0 0 {room.height:.9g}" size="0 0 1"'
        ' quat="0 1 0 0" rgba="0 0 0 0"/>'
    )
