"""What a Betaflight is told for what it is to do: arming, take-off, flight, landing; pure.

It has no take-off, no landing and no height of its own: all of them are sticks of ours, again and
again. A stream is never ended by silence: what flies is sunk, stood down and disarmed. Where
tracking is silent it sinks level by what its hover throttle was learned to be, for as long as its
height needs, then its motors are turned down, and off.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum
from math import inf
from typing import NamedTuple

from housefly.drones.betaflight.height import HeightLoop, HeightModel
from housefly.drones.betaflight.place import PlaceLoop
from housefly.messages import Action, DroneStatus, Setpoint, Sighting
from housefly.messages.steering import Instruction
from housefly.wires.betaflight.sticks import RadioSticks

TAKE_OFF_HEIGHT, CLIMB_RATE = 1.0, 0.5
"""Of a take-off: how high above where it stood [m], and how fast [m/s]."""
ARRIVED = 0.95
"""A take-off is over above this share of its height."""
LANDING_RATE, TOUCHDOWN_RATE, TOUCHDOWN_HEIGHT = 0.4, 0.25, 0.35
"""Of a landing: how fast [m/s], and how fast below a height [m]."""
SINK_RATE = 0.3
"""Of a landing without tracking [m/s]."""
POSE_AGE_MAX = 0.3
"""An older pose is no ground to hold a height or a place [s]."""
_HEIGHT_GAIN = 1.5
_CLIMB_MIN = 0.15
_LIFT_OFF_HEIGHT = 0.02
_SPOOL_FROM, _SPOOL_RATE, _SPOOL_MAX = 0.3, 0.7, 1.4
"""Thrust over weight once it is armed, how quickly it rises [1/s], and where it is given up."""
_ARM_AGAIN, _ARM_PAUSE = 1.0, 0.4
"""An arm switch that arms nothing goes off after this, and on again after that [s]."""
_STOOD_FOR, _STOOD_STEP, _SINKS_AGAIN = 0.5, 0.01, 0.06
"""It stands once tracking has seen it no lower by a step [m] for so long [s]; if it falls so far
while its motors are turned down [m], it was not the ground.
"""
_TURN_DOWN_TIME = 0.4
_BLIND_SURPLUS, _BLIND_FALL, _BLIND_FALL_TIME = 0.3, -1.0, 1.2
"""Without tracking it sinks so far below where the ground must be [m], then falls like that [m/s^2]
for so long [s] before its motors are off.
"""


class Doing(Enum):
    """What it is about."""

    NOTHING = "nothing"
    ARMING = "arming"
    SPOOLING = "spooling up"
    RISING = "rising"
    FLYING = "flying"
    LANDING = "landing"
    TURNING_DOWN = "turning down"
    STOPPED = "stopped"


class FcState(NamedTuple):
    """What the controller tells, as far as it matters here.

    Attributes:
        armed: whether its motors turn.
        may_arm: whether nothing keeps it from arming but the switch itself.
        phi, theta: how it leans [rad].
    """

    armed: bool
    may_arm: bool
    phi: float = 0.0
    theta: float = 0.0


@dataclass(frozen=True, slots=True)
class Told:
    """What leaves for the controller.

    Attributes:
        sticks: of a person at a radio.
        arms: whether the arm switch is on.
    """

    sticks: RadioSticks
    arms: bool


_OFF = Told(RadioSticks(), arms=False)
_LANDS = frozenset({Doing.LANDING, Doing.TURNING_DOWN})
_STATUS = {
    Doing.NOTHING: DroneStatus.FLYING,
    Doing.ARMING: DroneStatus.TAKING_OFF,
    Doing.SPOOLING: DroneStatus.TAKING_OFF,
    Doing.RISING: DroneStatus.TAKING_OFF,
    Doing.FLYING: DroneStatus.FLYING,
    Doing.LANDING: DroneStatus.LANDING,
    Doing.TURNING_DOWN: DroneStatus.LANDING,
    Doing.STOPPED: DroneStatus.LANDING,
}


class StickManoeuvres:
    """Knows what the drone is about.

    Args:
        model: of its height.
        tilt_max: largest lean that holds a place [rad].
        standing_height: of its middle above the floor when it stands [m].

    Attributes:
        height: the loop of its height; keeps the hover throttle that was learned.
        doing: what it is about.
        gave_up: whether its last take-off did not lift it.
    """

    def __init__(self, model: HeightModel, tilt_max: float, standing_height: float) -> None:
        self.height = HeightLoop(model)
        self.doing, self.gave_up = Doing.NOTHING, False
        self._place = PlaceLoop(model.drag)
        self._tilt_max, self._ground = tilt_max, standing_height
        self._since = self._seen_at = -inf
        self._start_height = self._held_height = 0.0
        self._armed_since = self._disarmed_since = -inf
        self._seen_height = self._lowest = inf
        self._lowest_at = -inf
        self._fell_since: float | None = None
        self._is_cut = False
        self._action = Action.IDLE

    def status(self, state: FcState) -> DroneStatus:
        """Return what the drone is doing, by its own word and by what it was told."""
        if self._is_cut:
            return DroneStatus.EMERGENCY
        return _STATUS[self.doing] if state.armed else DroneStatus.LANDED

    def use(self, model: HeightModel) -> None:
        """Take over a model that is known better; what was learned is kept."""
        self.height = replace(self.height, model=model)

    def see(self, seen: Sighting) -> None:
        """Take in where tracking saw the drone."""
        if seen.captured_at <= self._seen_at:
            return
        self._seen_at, self._seen_height = seen.captured_at, seen.pose.position[2]
        self._place = self._place.seen(seen.pose, seen.captured_at)
        self.height = self.height.seen(seen.pose.position[2], seen.captured_at)

    def told(self, told: Instruction, state: FcState, now: float) -> Told:
        """Return what leaves now.

        Args:
            told: what the failsafe decided.
            state: what the controller tells.
            now: [s].
        """
        command, action = told.command, told.command.action
        self.height = self.height.at(now)
        self._place = self._place.at(now, state.phi, state.theta)
        if action is not self._action:
            self._action, self.gave_up = action, False
        if action is Action.CUT:
            self._is_cut = True
        elif action is Action.RESET:
            self._is_cut = False
        if self._is_cut:
            self._begin(Doing.NOTHING, now)
            return _OFF
        if not state.armed:
            return self._on_the_floor(action, state, now)
        if self.doing in (Doing.NOTHING, Doing.ARMING):
            # armed a moment ago by us, else found so
            self._begin(Doing.SPOOLING if self.doing is Doing.ARMING else Doing.FLYING, now)
        if self.doing is Doing.STOPPED:
            return _OFF
        if action is Action.LAND or told.lands_all or action in (Action.IDLE, Action.RESET):
            return self._land(state, now)
        if action is Action.TAKE_OFF:
            return self._rise(state, now)
        if action is Action.HOVER:
            return self._hover(state, now)
        return self._fly(command.setpoint, state, now)

    def _is_tracked(self, now: float) -> bool:
        return now - self._seen_at <= POSE_AGE_MAX

    def _begin(self, doing: Doing, now: float) -> None:
        if doing is self.doing:
            return
        self.doing, self._since = doing, now
        self._fell_since = None
        self._lowest, self._lowest_at = inf, now
        self._place = replace(self._place, held=None)
        self._held_height = self.height.state.place

    def _stop(self, now: float) -> Told:
        """Switch its motors off, and on no more before it has said that they are."""
        self._begin(Doing.STOPPED, now)
        return _OFF

    def _on_the_floor(self, action: Action, state: FcState, now: float) -> Told:
        self.height = self.height.standing()
        wants_up = action is Action.TAKE_OFF and state.may_arm and not self.gave_up
        if not wants_up or not self._is_tracked(now):
            self._begin(Doing.NOTHING, now)
            return _OFF
        if self.doing is not Doing.ARMING:
            self._begin(Doing.ARMING, now)
            self._start_height = self._seen_height
        is_on = (now - self._since) % (_ARM_AGAIN + _ARM_PAUSE) < _ARM_AGAIN
        return Told(RadioSticks(), arms=is_on)

    def _rise(self, state: FcState, now: float) -> Told:
        if self.doing is Doing.SPOOLING:
            return self._spool(state, now)
        if self.doing is not Doing.RISING or not self._is_tracked(now):
            return self._hover(state, now)
        height = self.height.state
        top = self._start_height + TAKE_OFF_HEIGHT
        if height.place > self._start_height + ARRIVED * TAKE_OFF_HEIGHT:
            self._begin(Doing.FLYING, now)
            return self._hover(state, now)
        climb = min(max(_HEIGHT_GAIN * (top - height.place), _CLIMB_MIN), CLIMB_RATE)
        return self._held(climb, state)

    def _spool(self, state: FcState, now: float) -> Told:
        """Turn its motors up until it leaves the ground."""
        thrust = _SPOOL_FROM + _SPOOL_RATE * (now - self._since)
        if thrust > _SPOOL_MAX or not self._is_tracked(now):
            self.gave_up = True
            return self._stop(now)
        rise = self._seen_height - self._start_height
        if rise > _LIFT_OFF_HEIGHT:
            self.height = self.height.lifted(rise, now - self._seen_at, _SPOOL_RATE)
            self._begin(Doing.RISING, now)
            self._place = self._place.holding()
            return self._rise(state, now)
        self.height = self.height.standing(thrust)
        return Told(RadioSticks(throttle=self.height.throttle()), arms=True)

    def _hover(self, state: FcState, now: float) -> Told:
        if self.doing is not Doing.FLYING or self._place.held is None:
            self._begin(Doing.FLYING, now)
            self._place = self._place.holding()
            self._held_height = self.height.state.place
        if not self._is_tracked(now):
            return self._level(Setpoint(), state)
        climb = _HEIGHT_GAIN * (self._held_height - self.height.state.place)
        return self._held(min(max(climb, -CLIMB_RATE), CLIMB_RATE), state)

    def _fly(self, asked: Setpoint, state: FcState, now: float) -> Told:
        self._begin(Doing.FLYING, now)
        self._place = replace(self._place, held=None)
        if not self._is_tracked(now) and self._must_be_down:
            return self._fall(state, now)
        self._fell_since = None
        return self._level(asked, state)

    def _land(self, state: FcState, now: float) -> Told:
        if self.doing is Doing.SPOOLING:
            return self._stop(now)
        if self.doing not in _LANDS:
            self._begin(Doing.LANDING, now)
        if not self._is_tracked(now):
            self._place = replace(self._place, held=None)
            return self._sink(state, now)
        self._fell_since = None
        if self.doing is Doing.TURNING_DOWN:
            return self._turn_down(state, now)
        height = self.height.state
        is_low = height.place < self._ground + TOUCHDOWN_HEIGHT
        if self._stands(is_low, now):
            self._begin(Doing.TURNING_DOWN, now)
            self._lowest = self._seen_height
            return self._turn_down(state, now)
        self._place = self._place.holding()
        return self._held(-TOUCHDOWN_RATE if is_low else -LANDING_RATE, state)

    def _stands(self, is_low: bool, now: float) -> bool:
        """Return whether it has not sunk for a while, though it was told to."""
        if self._seen_height < self._lowest - _STOOD_STEP:
            self._lowest, self._lowest_at = self._seen_height, now
        return now - self._lowest_at > (_STOOD_FOR if is_low else 2.0 * _STOOD_FOR)

    def _turn_down(self, state: FcState, now: float) -> Told:
        if self._seen_height < self._lowest - _SINKS_AGAIN:
            self._begin(Doing.LANDING, now)
            return self._held(-TOUCHDOWN_RATE, state)
        left = 1.0 - (now - self._since) / _TURN_DOWN_TIME
        if left <= 0.0:
            return self._stop(now)
        return Told(RadioSticks(throttle=left * self.height.throttle()), arms=True)

    @property
    def _must_be_down(self) -> bool:
        """Whether it has sunk without tracking for longer than its height needs."""
        return self.height.state.place < self._ground - _BLIND_SURPLUS

    def _sink(self, state: FcState, now: float) -> Told:
        """Sink level until the ground must be there."""
        if self._must_be_down or self._fell_since is not None:
            return self._fall(state, now)
        return self._level(Setpoint(vz=-SINK_RATE), state)

    def _fall(self, state: FcState, now: float) -> Told:
        """Turn the motors down where the ground must be, and then off."""
        if self._fell_since is None:
            self._fell_since = now
        if now - self._fell_since > _BLIND_FALL_TIME:
            return self._stop(now)
        self.height = self.height.accelerating(_BLIND_FALL)
        return Told(RadioSticks(throttle=self.height.throttle(state.phi, state.theta)), arms=True)

    def _level(self, asked: Setpoint, state: FcState) -> Told:
        self.height = self.height.climbing(asked.vz)
        throttle = self.height.throttle(state.phi, state.theta)
        return Told(RadioSticks(asked.phi, asked.theta, asked.yaw_rate, throttle), arms=True)

    def _held(self, climb: float, state: FcState) -> Told:
        """Climb in its place."""
        phi, theta = self._place.lean(self._tilt_max)
        return self._level(Setpoint(theta, phi, climb), state)
