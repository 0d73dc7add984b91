"""Where a landing that the safety gate asks for comes down, while the pilot can still steer it.

Over clear floor it sinks where it is. Over furniture or people it first moves straight to the
nearest clear floor, slowly: a setpoint that jumped would look as if the drone had lost its course.
Over what only the drone's own sensor shows it rises again, and moves likewise.
"""

from __future__ import annotations

from dataclasses import dataclass

from housefly.geometry import Vec2, distance
from housefly.messages.words import UNSAID, Words
from housefly.pilot.behavior.braking import BESIDE_SPEED, sink_height
from housefly.pilot.estimation.dead_reckoning import ReckonedPose

SETTLED = 0.15
"""So near to its spot it begins to sink [m] ..."""
SETTLING_TIME = 2.0
"""... and this long after its setpoint came there at the latest [s]."""
MOVES_MAX = 2
"""So often it moves aside for what only the drone's own sensor shows: that may be wrong."""


@dataclass(frozen=True, slots=True)
class SteeredLanding:
    """One such landing.

    Attributes:
        begun: where it was asked for [m].
        height: of the drone then [m].
        at: when [s].
        spot: where it comes down [m].
        moves: how often it has moved aside for what only the drone's own sensor shows.
    """

    begun: Vec2
    height: float
    at: float
    spot: Vec2
    moves: int = 0

    def setpoint(self, now: float) -> Vec2:
        """Return where to be at a time [s], on the way to the spot [m]."""
        far = distance(self.begun, self.spot)
        if far == 0.0:
            return self.spot
        share = min(1.0, (now - self.at) * BESIDE_SPEED / far)
        return (
            self.begun[0] + share * (self.spot[0] - self.begun[0]),
            self.begun[1] + share * (self.spot[1] - self.begun[1]),
        )

    def height_setpoint(self, now: float, here: Vec2, height: float, lowest: float) -> float:
        """Return the height to want for a drone at a place and a height [m].

        Args:
            now: time [s].
            here: where the drone is [m].
            height: of the drone [m].
            lowest: height ever wanted [m].
        """
        return sink_height(height, lowest) if self.sinks(now, here) else self.height

    def sinks(self, now: float, here: Vec2) -> bool:
        """Return whether a drone at a place [m] is to sink."""
        arrival = self.at + distance(self.begun, self.spot) / BESIDE_SPEED
        is_there = now >= arrival and distance(here, self.spot) < SETTLED
        return self.spot == self.begun or is_there or now >= arrival + SETTLING_TIME

    def moved(self, here: Vec2, now: float, spot: Vec2) -> SteeredLanding:
        """Return the landing that goes on at another spot [m], from where the drone is now."""
        return SteeredLanding(here, self.height, now, spot, self.moves + 1)


@dataclass(frozen=True, slots=True)
class BlindPlan:
    """What to do in place of a landing without tracking.

    Attributes:
        fault: why the floor below is not to be landed on, in words; UNSAID to land.
        target, velocity: where to be, and how fast to move there [m, m/s].
        height: [m].
        here: where the drone is by its own motion; None while there is nothing to fly.
        may_sink: nothing stands below.
    """

    fault: Words = UNSAID
    target: Vec2 = (0.0, 0.0)
    velocity: Vec2 = (0.0, 0.0)
    height: float = 0.0
    here: ReckonedPose | None = None
    may_sink: bool = False


LAND = BlindPlan()
