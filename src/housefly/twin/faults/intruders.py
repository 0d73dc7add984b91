"""People and things that a fault puts in the way."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import atan2, cos, hypot, pi, sin
from typing import Protocol

from housefly.geometry import Vec2, distance, wrap_angle
from housefly.twin.contracts import GroundTruth
from housefly.twin.faults.fault import Fault
from housefly.twin.faults.vocabulary import FaultComponent
from housefly.twin.movable import Movable
from housefly.twin.people.script import PersonScript

_SLOWEST = 0.1
"""Below this speed "ahead" is where the drone's nose points [m/s]."""
_APPROACH, _CROSSING_AHEAD, _CROSSING_FROM = 3.0, 1.5, 2.0
"""How far away somebody starts to walk up, crosses ahead, and starts beside [m]."""


_ON_PAD = "pad"
_PAD_FREE = 1.0
"""Nobody comes to the pad while the drone is nearer to it than this [m]."""


@dataclass(frozen=True, slots=True)
class IntruderStart:
    """How the drone was when a fault began: its place, the pad [m], the way ahead [rad]."""

    drone: Vec2
    pad: Vec2
    ahead: float


_Walk = Callable[[Fault, IntruderStart, float], Vec2]
"""Fault, start, time since [s]: where the intruder is."""


def _along(start: Vec2, direction: float, length: float) -> Vec2:
    return start[0] + length * cos(direction), start[1] + length * sin(direction)


def _crossing(fault: Fault, start: IntruderStart, since: float) -> Vec2:
    ahead = _along(start.drone, start.ahead, _CROSSING_AHEAD)
    left = start.ahead + pi / 2
    return _along(ahead, left, _CROSSING_FROM - fault.size * since)


_CHAIR, _STOOL = Movable("chair-in-the-way", 0.25, 1.5), Movable("stool-on-the-pad", 0.2, 0.6)
_PERSON = PersonScript(name="person-in-the-way", height=1.7, steps=())
_CHILD = PersonScript(name="child-on-the-pad", height=0.9, steps=())
_PEOPLE, _OBSTACLES = FaultComponent.PEOPLE, FaultComponent.OBSTACLES

_INTRUDERS: dict[tuple[FaultComponent, str], tuple[str, _Walk]] = {
    (_OBSTACLES, ""): (
        _CHAIR.name,
        lambda fault, start, since: _along(start.drone, start.ahead, fault.size),
    ),
    (_OBSTACLES, _ON_PAD): (_STOOL.name, lambda fault, start, since: start.pad),
    (_PEOPLE, ""): (
        _PERSON.name,
        lambda fault, start, since: _along(start.drone, start.ahead, fault.size),
    ),
    (_PEOPLE, "walking"): (
        _PERSON.name,
        lambda fault, start, since: _along(
            start.drone, start.ahead, _APPROACH - fault.size * since
        ),
    ),
    (_PEOPLE, "crossing"): (_PERSON.name, _crossing),
    (_PEOPLE, _ON_PAD): (_CHILD.name, lambda fault, start, since: start.pad),
}
MOVABLE_INTRUDERS: tuple[Movable, ...] = (_CHAIR, _STOOL)
"""What a world must have for faults of ``obstacles``; away until then."""
PEOPLE_INTRUDERS: tuple[PersonScript, ...] = (_PERSON, _CHILD)
"""Whom a world must have for faults of ``people``; away until then."""


def puts_in_the_way(fault: Fault) -> bool:
    """Return whether a fault puts somebody or something in the way."""
    return (fault.component, fault.aspect) in _INTRUDERS


class IntruderWorld(Protocol):
    """What moves people and things."""

    def truth(self) -> GroundTruth:
        """Return the true state now."""
        ...

    def put(self, name: str, place: Vec2 | None, yaw: float = 0.0) -> None:
        """Stand a movable thing on the floor; None removes it."""
        ...

    def put_person(self, name: str, place: Vec2 | None, yaw: float = 0.0) -> None:
        """Stand somebody on the floor; None removes them."""
        ...


class IntruderFaults:
    """Puts and moves what is in the way, and takes it away again."""

    def __init__(self) -> None:
        self._began: dict[Fault, IntruderStart] = {}
        self._pad: Vec2 | None = None
        self._present: frozenset[tuple[FaultComponent, str]] = frozenset()

    def note_pad(self, world: IntruderWorld) -> None:
        """Remember where the drone first stood, which is its pad."""
        if self._pad is None:
            self._pad = world.truth().pose.position[:2]

    def update(self, active: tuple[Fault, ...], world: IntruderWorld, now: float) -> None:
        """Put everybody where they are now [s]."""
        present = set()
        for fault in filter(puts_in_the_way, active):
            name, walk = _INTRUDERS[fault.component, fault.aspect]
            if fault.aspect == _ON_PAD and self._waits(fault, world):
                continue
            start = self._began.get(fault) or self._begun(fault, world.truth())
            _put(world, fault.component, name, walk(fault, start, now - fault.start), start.ahead)
            present.add((fault.component, name))
        for component, name in self._present - present:
            _put(world, component, name, None, 0.0)
        self._present = frozenset(present)

    def _waits(self, fault: Fault, world: IntruderWorld) -> bool:
        """Return whether the drone still stands or hovers where somebody wants to be."""
        place = world.truth().pose.position[:2]
        return fault not in self._began and distance(place, self._pad or place) < _PAD_FREE

    def _begun(self, fault: Fault, truth: GroundTruth) -> IntruderStart:
        place = truth.pose.position[:2]
        pad = place if self._pad is None else self._pad
        start = self._began[fault] = IntruderStart(place, pad, _ahead(truth))
        return start


def _put(
    world: IntruderWorld, component: FaultComponent, name: str, place: Vec2 | None, ahead: float
) -> None:
    """Put somebody or something somewhere; people face the drone."""
    if component is FaultComponent.PEOPLE:
        world.put_person(name, place, wrap_angle(ahead + pi))
    else:
        world.put(name, place, ahead)


def _ahead(truth: GroundTruth) -> float:
    vx, vy, _ = truth.velocity
    return atan2(vy, vx) if hypot(vx, vy) > _SLOWEST else truth.pose.yaw
