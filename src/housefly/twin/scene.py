"""The model that physics, rays and pictures share."""

from __future__ import annotations

from housefly.config import Site
from housefly.room.mjcf import room_to_mjcf
from housefly.room.model import Room
from housefly.twin.body import drone_body
from housefly.twin.people.bodies import people_bodies
from housefly.twin.people.script import PersonScript


def scene_mjcf(site: Site, room: Room, people: tuple[PersonScript, ...] = ()) -> str:
    """Return the MuJoCo model text of the room with the drone on its pad and people who are away; needs no MuJoCo."""
    return room_to_mjcf(room, bodies=drone_body(site.drone, room.home, room.home_yaw) + people_bodies(people))
