"""What the drone touched: one record per touch, looked for in every control period."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

from housefly.geometry import Vec3, distance
from housefly.numeric import running_sum
from housefly.twin.drone_body import DroneBody
from housefly.twin.people.motion import PersonMotion
from housefly.twin.simulated_body import CONTROL_PERIOD, BodyState
from housefly.twin.solids import SolidKind, SolidOwner
from housefly.twin.touch import TouchPoint

_MERGE_WITHIN = 0.5
"""A hull that bounces touches the same thing again within this time [s]: still one touch."""
_MOSTLY_UP = 0.7
"""Upward part of a touch that carries the drone: a slope of less than 45 degrees."""


@dataclass(frozen=True, slots=True)
class Contact:
    """One touch of something other than the floor, from the first moment to the last.

    Attributes:
        kind, name: what or who was touched; "wall", "ceiling", a thing of the room, a movable, a
            person, another drone.
        began_at, ended_at: world time of its first and last moment [s]; the last one is now while
            the touch lasts.
        speed: of the drone relative to what it touches, just before the first moment [m/s].
        closing_speed: part of it that led into the other, at the first moment [m/s].
        own_speed: part of that by the drone's own motion; negative where it moved away [m/s].
        height: of the lowest point of the touch at the first moment, above the floor [m].
        motors_turned: whether the motors turned at any moment of it.
        from_above: whether the drone stood on the other at any moment of it.
    """

    kind: SolidKind
    name: str
    began_at: float
    ended_at: float
    speed: float
    closing_speed: float
    own_speed: float
    height: float
    motors_turned: bool
    from_above: bool


class ContactLog:
    """Merges the touches of control periods into contacts.

    Args:
        motion: of the people.
        drones: the others, by name.
    """

    def __init__(self, motion: PersonMotion, drones: Mapping[str, DroneBody]) -> None:
        self._motion, self._drones = motion, drones
        self._open: dict[SolidOwner, int] = {}
        self._contacts: list[Contact] = []

    @property
    def contacts(self) -> tuple[Contact, ...]:
        """All contacts so far, in order of their beginning."""
        return tuple(self._contacts)

    def add(
        self, points: Iterable[TouchPoint], at: float, before: BodyState, motors_turn: bool
    ) -> None:
        """Record what the drone touched in a control period.

        Args:
            points: where it touched what.
            at: end of the period [s].
            before: the drone at the beginning of the period.
            motors_turn: whether its motors turned.
        """
        for point in points:
            number = self._open.get(point.owner)
            if number is None or at - self._contacts[number].ended_at > _MERGE_WITHIN:
                self._open[point.owner] = len(self._contacts)
                self._contacts.append(self._begun(point, at, before, motors_turn))
                continue
            contact = self._contacts[number]
            height, closing = contact.height, contact.closing_speed
            if at == contact.began_at:
                height = min(height, point.position[2])
                closing = max(closing, self._closing(point, at, before))
            self._contacts[number] = replace(
                contact,
                ended_at=at,
                height=height,
                closing_speed=closing,
                motors_turned=contact.motors_turned or motors_turn,
                from_above=contact.from_above or point.outward[2] > _MOSTLY_UP,
            )

    def _begun(self, point: TouchPoint, at: float, before: BodyState, motors_turn: bool) -> Contact:
        return Contact(
            kind=point.owner.kind,
            name=point.owner.name,
            began_at=at,
            ended_at=at,
            speed=distance(before.velocity, self._velocity(point.owner, at)),
            closing_speed=self._closing(point, at, before),
            own_speed=_into(point, before.velocity),
            height=point.position[2],
            motors_turned=motors_turn,
            from_above=point.outward[2] > _MOSTLY_UP,
        )

    def _closing(self, point: TouchPoint, at: float, before: BodyState) -> float:
        other = self._velocity(point.owner, at)
        return max(0.0, _into(point, before.velocity) - _into(point, other))

    def _velocity(self, owner: SolidOwner, at: float) -> Vec3:
        """Return the velocity of what is touched, just before [m/s]; things stand still."""
        if owner.kind is SolidKind.DRONE:
            return self._drones[owner.name].before.velocity
        if owner.kind is not SolidKind.PERSON:
            return 0.0, 0.0, 0.0
        return self._motion.velocity(owner.name, at - CONTROL_PERIOD)


def _into(point: TouchPoint, velocity: Vec3) -> float:
    """Return the part of a velocity that leads into what is touched [m/s]."""
    return -running_sum(normal * part for normal, part in zip(point.outward, velocity, strict=True))
