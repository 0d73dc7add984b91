"""An evaluated script of one person: where they are when, and what they do when; pure."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import atan2, hypot
from typing import Any

import numpy as np

from housefly.geometry import Vec2
from housefly.twin.people.script import (
    Appear,
    Go,
    Handle,
    Lie,
    PersonScript,
    Put,
    Sit,
    Take,
    Vanish,
    Wait,
)
from housefly.twin.people.state import Act, PersonState, Posture, SceneEvent

_ACT_DURATION = 0.4
"""Duration of one act of a hand [s]."""
_NOWHERE: Vec2 = (0.0, 0.0)


@dataclass(frozen=True, slots=True)
class _Leg:
    """A stretch of time in which a person stays, or walks straight at constant speed.

    Attributes:
        begin, end: [s since the scene began].
        start, goal: where they are at its two ends [m].
        yaw: where they face [rad].
        support: height of what carries them [m].
        posture: how they are.
    """

    begin: float
    end: float
    start: Vec2
    goal: Vec2
    yaw: float
    support: float
    posture: Posture

    def at(self, name: str, time: float) -> PersonState:
        """Return the person at a time; at its ends outside the leg."""
        share = (
            min(max((time - self.begin) / (self.end - self.begin), 0.0), 1.0)
            if self.end > self.begin
            else 1.0
        )
        (x, y), (gx, gy) = self.start, self.goal
        return PersonState(
            name, (x + share * (gx - x), y + share * (gy - y)), self.yaw, self.support, self.posture
        )


class Timeline:
    """Evaluates one person's steps.

    Args:
        person: the script.
        rng: draws speed and waiting time of each step.
        variation: largest relative deviation of both.

    Attributes:
        legs: without gaps, from 0 to ``end``.
        events: by time.
        end: when the script ends [s].
    """

    def __init__(self, person: PersonScript, rng: np.random.Generator, variation: float) -> None:
        self.legs: list[_Leg] = []
        self.events: list[SceneEvent] = []
        self.end = 0.0
        self._name, self._rng, self._variation = person.name, rng, variation
        self._place, self._yaw = person.start or _NOWHERE, person.yaw
        self._posture = Posture.STANDING if person.start is not None else Posture.AWAY
        for step in person.steps:
            _STEP_HANDLERS[type(step)](self, step)
        self._stay(0.0)

    def _go(self, step: Go) -> None:
        """Walk."""
        (x, y), (gx, gy) = self._place, step.to
        self._yaw = atan2(gy - y, gx - x) if (x, y) != (gx, gy) else self._yaw
        duration = hypot(gx - x, gy - y) / (step.speed * self._factor())
        self._add(
            _Leg(self.end, self.end + duration, (x, y), step.to, self._yaw, 0.0, Posture.WALKING)
        )
        self._place = step.to

    def _wait(self, step: Wait) -> None:
        """Stand."""
        self._yaw = self._yaw if step.yaw is None else step.yaw
        self._stay(step.seconds * self._factor())

    def _rest(self, step: Sit | Lie) -> None:
        """Sit or lie, then stand again."""
        height, posture = (
            (step.seat, Posture.SITTING) if isinstance(step, Sit) else (step.height, Posture.LYING)
        )
        end = self.end + step.seconds * self._factor()
        self._add(_Leg(self.end, end, step.at, step.at, step.yaw, height, posture))

    def _take(self, step: Take) -> None:
        """Take a thing."""
        self._do(Act.TAKE, step.thing)

    def _put(self, step: Put) -> None:
        """Put a thing down."""
        self._stay(_ACT_DURATION)
        self.events.append(
            SceneEvent(self.end, Act.PUT, step.thing, self._name, step.into, step.at)
        )

    def _handle(self, step: Handle) -> None:
        """Open, close or press."""
        self._do(Act(step.do), step.what)

    def _appear(self, step: Appear) -> None:
        """Come."""
        self._place, self._yaw, self._posture = step.at, step.yaw, Posture.STANDING

    def _vanish(self, step: Vanish) -> None:
        """Go."""
        self._posture = Posture.AWAY

    def _do(self, act: Act, what: str) -> None:
        self._stay(_ACT_DURATION)
        self.events.append(SceneEvent(self.end, act, what, self._name))

    def _stay(self, seconds: float) -> None:
        self._add(
            _Leg(
                self.end,
                self.end + seconds,
                self._place,
                self._place,
                self._yaw,
                0.0,
                self._posture,
            )
        )

    def _add(self, leg: _Leg) -> None:
        self.legs.append(leg)
        self.end = leg.end

    def _factor(self) -> float:
        return 1.0 + self._variation * float(self._rng.uniform(-1.0, 1.0))


_STEP_HANDLERS: dict[type, Callable[[Timeline, Any], None]] = {
    Go: Timeline._go,
    Wait: Timeline._wait,
    Sit: Timeline._rest,
    Lie: Timeline._rest,
    Take: Timeline._take,
    Put: Timeline._put,
    Handle: Timeline._handle,
    Appear: Timeline._appear,
    Vanish: Timeline._vanish,
}
