"""The drone and what is around it: contacts so far, clearance now."""

from __future__ import annotations

from housefly.config.site import Site
from housefly.room.model import Room
from housefly.twin.clearance import UNBOUNDED, Clearance, ClearanceMeter
from housefly.twin.contact_log import Contact, ContactLog
from housefly.twin.people.motion import PersonMotion
from housefly.twin.physics import Physics
from housefly.twin.picture_segments import PictureSegments
from housefly.twin.simulated_body import CONTROL_PERIOD, BodyState
from housefly.twin.solids import owners_of_geoms
from housefly.twin.touch import touch_points


class Encounters:
    """Looks at every control period.

    Args:
        site: names the furniture that tracking sees.
        room: names the things.
        physics: the drone among them.
        motion: of the people.
    """

    def __init__(self, site: Site, room: Room, physics: Physics, motion: PersonMotion) -> None:
        tracked = frozenset(piece.body for piece in site.furniture)
        self._physics = physics
        self._owners = owners_of_geoms(physics.model, room, tracked, physics.floors)
        self._log = ContactLog(motion)
        self._meter = ClearanceMeter(physics, self._owners)
        self._segments = PictureSegments(physics, self._owners)
        self._measured: tuple[tuple[int, Clearance], Clearance] | None = None

    def in_picture(self) -> dict[str, float]:
        """Return the share of the front camera's picture that each thing and person takes."""
        return self._segments.shares()

    @property
    def contacts(self) -> tuple[Contact, ...]:
        """All contacts so far, in order of their beginning."""
        return self._log.contacts

    def look(self, tick: int, before: BodyState, motors_turn: bool) -> None:
        """Record what the drone touched in a control period.

        Args:
            tick: number of control periods since the world began, this one included.
            before: the drone at the beginning of the period.
            motors_turn: whether its motors turned.
        """
        points = touch_points(self._physics, self._owners)
        if points:
            self._log.add(points, tick * CONTROL_PERIOD, before, motors_turn)

    def clearance(self, tick: int, within: Clearance = UNBOUNDED) -> Clearance:
        """Return the true distances from the hull, measured once per control period.

        Where nothing is nearer than ``within``, that is returned: looking no farther is cheaper.
        """
        if self._measured is None or self._measured[0] != (tick, within):
            self._measured = (tick, within), self._meter.measure(within)
        return self._measured[1]
