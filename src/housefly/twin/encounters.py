"""One drone and what is around it: contacts so far, clearance now."""

from __future__ import annotations

from collections.abc import Mapping

from housefly.config.site import Site
from housefly.room.model import Room
from housefly.twin.clearance import UNBOUNDED, Clearance, ClearanceMeter
from housefly.twin.contact_log import Contact, ContactLog
from housefly.twin.drone_body import DroneBody
from housefly.twin.people.motion import PersonMotion
from housefly.twin.picture_segments import PictureSegments
from housefly.twin.simulated_body import BodyState
from housefly.twin.solids import owners_of_geoms
from housefly.twin.touch import touch_points


class Encounters:
    """Looks at every control period.

    Args:
        site: names the furniture that tracking sees.
        room: names the things.
        drone: the drone among them.
        motion: of the people.
        others: the other drones, by name.
    """

    def __init__(
        self,
        site: Site,
        room: Room,
        drone: DroneBody,
        motion: PersonMotion,
        others: Mapping[str, DroneBody],
    ) -> None:
        tracked = frozenset(piece.body for piece in site.furniture)
        self._drone = drone
        names = {other.name: name for name, other in others.items()}
        self._owners = owners_of_geoms(drone.model, room, tracked, drone.floors, names)
        self._log = ContactLog(motion, others)
        self._meter = ClearanceMeter(drone, self._owners)
        self._segments = PictureSegments(drone, self._owners)
        self._measured: tuple[tuple[float, Clearance], Clearance] | None = None

    def in_picture(self) -> dict[str, float]:
        """Return the share of the front camera's picture that each thing and person takes."""
        return self._segments.shares()

    @property
    def contacts(self) -> tuple[Contact, ...]:
        """All contacts so far, in order of their beginning."""
        return self._log.contacts

    def look(self, at: float, before: BodyState, motors_turn: bool) -> None:
        """Record what the drone touched in a control period.

        Args:
            at: its end [s].
            before: the drone at the beginning of the period.
            motors_turn: whether its motors turned.
        """
        points = touch_points(self._drone, self._owners)
        if points:
            self._log.add(points, at, before, motors_turn)

    def clearance(self, at: float, within: Clearance = UNBOUNDED) -> Clearance:
        """Return the true distances from the hull, once per control period that ended then [s].

        Where nothing is nearer than ``within``, that is returned: looking no farther is cheaper.
        """
        if self._measured is None or self._measured[0] != (at, within):
            self._measured = (at, within), self._meter.measure(within)
        return self._measured[1]
