"""People and things that a fault puts in the way."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import atan2, hypot, pi
from typing import Protocol

import numpy as np

from housefly.geometry import Vec2, distance, wrap_angle
from housefly.room.model import Room, Shape, Solid
from housefly.twin.contracts import GroundTruth
from housefly.twin.faults.fault import Fault
from housefly.twin.faults.free_floor import FreeFloor, along
from housefly.twin.faults.physical import TrueDrone
from housefly.twin.faults.vocabulary import FaultComponent
from housefly.twin.movable import Movable
from housefly.twin.people.script import PersonScript
from housefly.twin.people.state import Posture

_SLOWEST = 0.1
"""Below this speed "ahead" is where the drone's nose points [m/s]."""
_APPROACH, _CROSSING_AHEAD, _CROSSING_FROM = 3.0, 1.5, 2.0
"""How far away somebody starts to walk up, crosses ahead, and starts beside [m]."""
_NEAREST_START = 1.5
"""Nobody starts to walk nearer to the drone than this [m]."""
_UNAVOIDABLE = 0.8
"""No drone on its way can stop before what is put nearer than this: it is put beside it [m]."""
_WALK = 10.0
"""Nobody walks farther than this [m]."""

_ON_PAD, _FLAT_ON_PAD, _BESIDE_PAD = "pad", "flat", "pole"
_AT_PAD = frozenset({_ON_PAD, _FLAT_ON_PAD, _BESIDE_PAD})
_PAD_FREE = 1.5
"""Nobody comes to the pad while the drone is nearer to it than this [m]."""
_POLE_NEAREST, _POLE_FARTHEST = 0.15, 0.25
"""A pole stands so far beside the pad's middle: below the hull [m]."""
_BELOW, _LYING = "below", "lying"
_ROOM_BELOW = {_BELOW: 1.05, _LYING: 0.6}
"""Who comes below the drone comes once it is no lower than this [m] ..."""
_HOVERS = 0.15
"""... and no faster [m/s]."""
_BODY_LENGTH = 1.7
"""How long somebody lies [m]."""


@dataclass(frozen=True, slots=True)
class Encounter:
    """How the drone was when a fault began: its place, the pad [m], the way ahead [rad]."""

    drone: Vec2
    pad: Vec2
    ahead: float


@dataclass(frozen=True, slots=True)
class StraightWalk:
    """Somebody who walks straight on until something is in their way, or who stands.

    Attributes:
        start: [m].
        heading: [rad].
        speed: [m/s].
        length: they walk no farther [m].
        posture: how they are there.
    """

    start: Vec2
    heading: float
    speed: float = 0.0
    length: float = 0.0
    posture: Posture = Posture.STANDING

    def place(self, since: float) -> Vec2:
        """Return where they are so long after they set off [m]."""
        return along(self.start, self.heading, min(self.speed * since, self.length))


_Entrance = Callable[[Fault, Encounter, FreeFloor], StraightWalk]
"""How somebody comes into the way of the drone."""


def _stands(fault: Fault, met: Encounter, floor: FreeFloor) -> StraightWalk:
    """Stand ahead, or beside the drone where it could never stop in time."""
    wanted = met.ahead + (pi / 2 if fault.size < _UNAVOIDABLE else 0.0)
    near = min(fault.size, _UNAVOIDABLE)
    bearing = floor.open_bearing(met.drone, wanted, near, fault.size)
    return StraightWalk(along(met.drone, bearing, fault.size), bearing + pi)


def _walks_up(fault: Fault, met: Encounter, floor: FreeFloor) -> StraightWalk:
    """Walk straight at the place where the drone was, and on."""
    bearing = floor.open_bearing(met.drone, met.ahead, _UNAVOIDABLE, _APPROACH)
    near = along(met.drone, bearing, _NEAREST_START)
    away = _NEAREST_START + floor.free_length(near, bearing, _APPROACH - _NEAREST_START)
    return _walk(along(met.drone, bearing, away), bearing + pi, fault.size, floor)


def _crosses(fault: Fault, met: Encounter, floor: FreeFloor) -> StraightWalk:
    """Cross the way ahead, from the side with more room."""
    ahead = along(met.drone, met.ahead, _CROSSING_AHEAD)
    sides = [met.ahead + pi / 2, met.ahead - pi / 2]
    away, side = max(
        (floor.free_length(ahead, side, _CROSSING_FROM), -n) for n, side in enumerate(sides)
    )
    bearing = sides[-side]
    return _walk(along(ahead, bearing, away), bearing + pi, fault.size, floor)


def _on_pad(fault: Fault, met: Encounter, floor: FreeFloor) -> StraightWalk:
    return StraightWalk(met.pad, met.ahead + pi)


def _beside_pad(fault: Fault, met: Encounter, floor: FreeFloor) -> StraightWalk:
    """Stand below the rim of the hull, where the middle of the sonar's beam does not look."""
    rng = np.random.default_rng(fault.seed)
    bearing = float(rng.integers(4)) * pi / 2
    away = float(rng.uniform(_POLE_NEAREST, _POLE_FARTHEST))
    return StraightWalk(along(met.pad, bearing, away), bearing)


def _below(fault: Fault, met: Encounter, floor: FreeFloor) -> StraightWalk:
    return StraightWalk(met.drone, met.ahead + pi)


def _lies_below(fault: Fault, met: Encounter, floor: FreeFloor) -> StraightWalk:
    """Lie where there is room for it, some part of the body below the drone."""
    rng = np.random.default_rng(fault.seed)
    wanted, half = float(rng.uniform(-pi, pi)), 0.5 * _BODY_LENGTH
    heading = floor.open_bearing(met.drone, wanted, 0.0, half)
    middle = along(met.drone, heading, float(rng.uniform(0.0, 0.5)) * half)
    return StraightWalk(middle, heading, posture=Posture.LYING)


def _walk(start: Vec2, heading: float, speed: float, floor: FreeFloor) -> StraightWalk:
    return StraightWalk(start, heading, speed, floor.free_length(start, heading, _WALK))


_CHAIR, _STOOL = Movable("chair-in-the-way", 0.25, 1.5), Movable("stool-on-the-pad", 0.2, 0.6)
_PERSON = PersonScript(name="person-in-the-way", height=1.7, steps=())
_CHILD = PersonScript(name="child-on-the-pad", height=0.9, steps=())
_FLAT = Movable(
    "box-on-the-pad",
    height=0.12,
    solids=(Solid("box", "thing", Shape.BOX, (0.0, 0.0, 0.06), (0.5, 0.4, 0.12)),),
)
_POLE = Movable("pole-beside-the-pad", 0.04, 0.6)
_BELOW_CHILD = PersonScript(name="child-below", height=0.9, steps=())
_LYING_PERSON = PersonScript(name="person-lying-below", height=_BODY_LENGTH, steps=())
_PEOPLE, _OBSTACLES = FaultComponent.PEOPLE, FaultComponent.OBSTACLES

_INTRUDERS: dict[tuple[FaultComponent, str], tuple[str, _Entrance]] = {
    (_OBSTACLES, ""): (_CHAIR.name, _stands),
    (_OBSTACLES, _ON_PAD): (_STOOL.name, _on_pad),
    (_PEOPLE, ""): (_PERSON.name, _stands),
    (_PEOPLE, "walking"): (_PERSON.name, _walks_up),
    (_PEOPLE, "crossing"): (_PERSON.name, _crosses),
    (_PEOPLE, _ON_PAD): (_CHILD.name, _on_pad),
    (_OBSTACLES, _FLAT_ON_PAD): (_FLAT.name, _on_pad),
    (_OBSTACLES, _BESIDE_PAD): (_POLE.name, _beside_pad),
    (_PEOPLE, _BELOW): (_BELOW_CHILD.name, _below),
    (_PEOPLE, _LYING): (_LYING_PERSON.name, _lies_below),
}
MOVABLE_INTRUDERS: tuple[Movable, ...] = (_CHAIR, _STOOL, _FLAT, _POLE)
"""What a world must have for faults of ``obstacles``; away until then."""
PEOPLE_INTRUDERS: tuple[PersonScript, ...] = (_PERSON, _CHILD, _BELOW_CHILD, _LYING_PERSON)
"""Whom a world must have for faults of ``people``; away until then."""


def puts_in_the_way(fault: Fault) -> bool:
    """Return whether a fault puts somebody or something in the way."""
    return (fault.component, fault.aspect) in _INTRUDERS


class IntruderWorld(Protocol):
    """What moves people and things."""

    @property
    def room(self) -> Room:
        """What stands where."""
        ...

    def put(self, name: str, place: Vec2 | None, yaw: float = 0.0) -> None:
        """Stand a movable thing on the floor; None removes it."""
        ...

    def put_person(
        self,
        name: str,
        place: Vec2 | None,
        yaw: float = 0.0,
        posture: Posture = Posture.STANDING,
    ) -> None:
        """Put somebody on the floor; None removes them."""
        ...


class IntruderFaults:
    """Puts and moves what is in the way, and takes it away again."""

    def __init__(self) -> None:
        self._began: dict[Fault, StraightWalk] = {}
        self._pad: Vec2 | None = None
        self._present: frozenset[tuple[FaultComponent, str]] = frozenset()

    def note_pad(self, drone: TrueDrone) -> None:
        """Remember where the drone first stood, which is its pad."""
        if self._pad is None:
            self._pad = drone.truth().pose.position[:2]

    def update(
        self, active: tuple[Fault, ...], world: IntruderWorld, drone: TrueDrone, now: float
    ) -> None:
        """Put everybody where they are now [s], in the way of a drone."""
        present = set()
        for fault in filter(puts_in_the_way, active):
            name, entrance = _INTRUDERS[fault.component, fault.aspect]
            if fault not in self._began and self._waits(fault, world, drone.truth()):
                continue
            walk = self._began.get(fault) or self._begun(fault, entrance, world, drone.truth())
            _put(world, fault.component, name, walk, walk.place(now - fault.start))
            present.add((fault.component, name))
        for component, name in self._present - present:
            _put(world, component, name, None, None)
        self._present = frozenset(present)

    def _waits(self, fault: Fault, world: IntruderWorld, truth: GroundTruth) -> bool:
        """Return whether the drone is where somebody wants to be, or not yet above it."""
        (x, y, z), (vx, vy, _) = truth.pose.position, truth.velocity
        if fault.aspect in _ROOM_BELOW:
            is_above = z > _ROOM_BELOW[fault.aspect] and hypot(vx, vy) < _HOVERS
            return not (is_above and FreeFloor(world.room).is_free((x, y)))
        return fault.aspect in _AT_PAD and distance((x, y), self._pad or (x, y)) < _PAD_FREE

    def _begun(
        self, fault: Fault, entrance: _Entrance, world: IntruderWorld, truth: GroundTruth
    ) -> StraightWalk:
        place = truth.pose.position[:2]
        met = Encounter(place, place if self._pad is None else self._pad, _ahead(truth))
        walk = self._began[fault] = entrance(fault, met, FreeFloor(world.room))
        return walk


def _put(
    world: IntruderWorld,
    component: FaultComponent,
    name: str,
    walk: StraightWalk | None,
    place: Vec2 | None,
) -> None:
    """Put somebody or something somewhere on its way; None removes it."""
    heading = walk.heading if walk else 0.0
    if component is FaultComponent.PEOPLE:
        posture = walk.posture if walk else Posture.STANDING
        world.put_person(name, place, wrap_angle(heading), posture)
    else:
        world.put(name, place, heading)


def _ahead(truth: GroundTruth) -> float:
    vx, vy, _ = truth.velocity
    return atan2(vy, vx) if hypot(vx, vy) > _SLOWEST else truth.pose.yaw
