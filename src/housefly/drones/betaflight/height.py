"""The height loop: from a climb rate that is wanted to throttle; pure.

A Betaflight holds no height by tracking. Thrust is taken as the square of what the motors are told;
what the hover throttle really is, the observer learns as a push that nobody asked for, and it is
known from the moment of the take-off on. Without poses the model goes on: the drone sinks as it is
asked to, as well as its hover throttle was learned.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import cos, sqrt

from housefly.config.airframe import Airframe
from housefly.drones.betaflight.observer import PUSH_MAX, UNSEEN, AxisState, advanced, corrected
from housefly.geometry import GRAVITY

MOTOR_LAG = 0.04
"""From throttle to thrust, and from one pair of commands to the next [s]."""
ASKED_MAX = 5.0
"""Largest acceleration up or down that is asked for [m/s^2]."""
_UPRIGHT_MIN = 0.7
_LAG_MAX = 1.0


@dataclass(frozen=True, slots=True)
class HeightModel:
    """What of the airframe the loop needs.

    Attributes:
        pole: of the climb rate [1/s].
        drag: linear [1/s].
        lag: from throttle to thrust, with the command's delay [s].
        hover: share of full thrust that carries it.
        idle: share of full throttle at which its motors turn that are told nothing.
    """

    pole: float
    drag: float
    lag: float
    hover: float
    idle: float

    def throttle(self, thrust: float) -> float:
        """Return throttle, 0 to 1 between idle and full, for thrust over weight."""
        share = sqrt(min(max(thrust * self.hover, 0.0), 1.0))
        return min(max((share - self.idle) / (1.0 - self.idle), 0.0), 1.0)

    def thrust(self, throttle: float) -> float:
        """Return thrust over weight that a throttle makes."""
        return (self.idle + (1.0 - self.idle) * throttle) ** 2 / self.hover


def height_model(airframe: Airframe, idle: float) -> HeightModel:
    """Return the model of an airframe.

    Args:
        airframe: gives weight and full thrust.
        idle: of its motors, as the controller is set.
    """
    body, response = airframe.body, airframe.response
    full = body.thrust_max or 4.0 * body.mass * GRAVITY
    return HeightModel(
        pole=response.climb_lag,
        drag=response.drag,
        lag=response.command_delay + MOTOR_LAG,
        hover=min(body.mass * GRAVITY / full, 1.0),
        idle=idle,
    )


@dataclass(frozen=True, slots=True)
class HeightLoop:
    """The loop and what it knows.

    Attributes:
        model: of the airframe.
        state: of the height.
        asked: acceleration that was asked for last [m/s^2].
        made: of that, what the motors make by now [m/s^2].
        stands: whether the ground carries it.
    """

    model: HeightModel
    state: AxisState = UNSEEN
    asked: float = 0.0
    made: float = 0.0
    stands: bool = True

    def at(self, now: float) -> HeightLoop:
        """Return it carried on to now [s]."""
        dt = min(max(now - self.state.at, 0.0), _LAG_MAX)
        share = dt / (dt + self.model.lag)
        made = self.made + share * (self.asked - self.made)
        if self.stands:
            return replace(self, state=self.state._replace(at=now), made=made)
        state = advanced(self.state, now, 0.5 * (made + self.made), self.model.drag)
        return replace(self, state=state, made=made)

    def seen(self, height: float, captured_at: float) -> HeightLoop:
        """Return it once tracking has said how high it was [m], at a time [s]."""
        state = self.state
        if self.stands:
            still = state._replace(place=height, speed=0.0, corrected_at=captured_at)
            return replace(self, state=still)
        return replace(self, state=corrected(state, height, captured_at))

    def standing(self, thrust: float = 0.0) -> HeightLoop:
        """Return it for a drone that the ground carries, whatever its motors make.

        Args:
            thrust: over weight.
        """
        asked = GRAVITY * (thrust - 1.0)
        made = self.made if self.stands else asked
        state = self.state._replace(speed=0.0)
        return replace(self, state=state, asked=asked, made=made, stands=True)

    def lifted(self, rise: float, seen_ago: float, spool: float) -> HeightLoop:
        """Return it once it has left the ground: what its motors made then carries its weight.

        Args:
            rise: until it was seen [m]: what grows evenly has risen by a sixth of spool t^3.
            seen_ago: how long ago that was [s].
            spool: how quickly the thrust over weight grew [1/s].
        """
        jerk = GRAVITY * spool
        passed = (6.0 * max(rise, 0.0) / jerk) ** (1.0 / 3.0) + seen_ago
        push = -(self.made - jerk * passed)
        push = min(max(push, -PUSH_MAX), PUSH_MAX)
        risen = jerk * passed**3 / 6.0 - rise
        speed = 0.5 * jerk * passed**2
        state = self.state._replace(place=self.state.place + risen, speed=speed, push=push)
        return replace(self, state=state, stands=False)

    def climbing(self, climb: float) -> HeightLoop:
        """Return it once a climb rate is wanted [m/s]."""
        state, model = self.state, self.model
        asked = model.pole * (climb - state.speed) + model.drag * state.speed - state.push
        return replace(self, asked=min(max(asked, -ASKED_MAX), ASKED_MAX), stands=False)

    def accelerating(self, acceleration: float) -> HeightLoop:
        """Return it once an acceleration is wanted [m/s^2], whatever its speed."""
        return replace(self, asked=acceleration - self.state.push, stands=False)

    def throttle(self, phi: float = 0.0, theta: float = 0.0) -> float:
        """Return the throttle for what is asked, of a drone that leans [rad]."""
        upright = max(cos(phi) * cos(theta), _UPRIGHT_MIN)
        return self.model.throttle((1.0 + self.asked / GRAVITY) / upright)
