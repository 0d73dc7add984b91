"""The drones that the simulated room has: each with its own site, its pad, and its body."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.config.drone import DroneConfig
from housefly.config.site import Site
from housefly.geometry import Vec2
from housefly.room.model import Room
from housefly.twin.quadrotor.body import BODY


@dataclass(frozen=True, slots=True)
class DroneStand:
    """One drone of a site, and where it stands at first.

    Attributes:
        name: as the site has it.
        site: as its own chain sees it.
        pad: where it starts [m].
        yaw: where it faces there [rad].
        body: name of its body in the model.
    """

    name: str
    site: Site
    pad: Vec2
    yaw: float
    body: str

    @property
    def config(self) -> DroneConfig:
        """Everything that is its own."""
        return self.site.drone


def drone_stands(site: Site, room: Room, first: str = "") -> tuple[DroneStand, ...]:
    """Return the drones that a site flies, in its order; one that does not fly where none does.

    Args:
        site: whose drones.
        room: gives the pad of one that has none of its own.
        first: which of them comes before the others, if any does; pictures are taken from it.
    """
    names = site.drone_names or (site.all_drones[0].name,)
    names = tuple(sorted(names, key=lambda name: name != first))
    return tuple(_stand(site.for_drone(name), room, number) for number, name in enumerate(names))


def _stand(site: Site, room: Room, number: int) -> DroneStand:
    name = site.drone.name
    # A room that is one drone's has that one's pad as home.
    x, y, yaw = site.drone.pad or dict(room.other_pads).get(name, (*room.home, room.home_yaw))
    return DroneStand(name, site, (x, y), yaw, BODY if number == 0 else f"{BODY} {name}")
