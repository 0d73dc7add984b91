"""The supervisor of the simulated Crazyflie: whether its motors may turn.

States and conditions as in the firmware (docs/functional-areas/supervisor). A drone of a kind that
must be armed is; one that arms itself has done so at once. Setpoints that stop let it level out
after half a second and cut its motors after two: then, and after an emergency stop, it is locked
until somebody switches it off and on.
"""

from __future__ import annotations

from enum import Enum
from math import cos

from housefly.twin.simulated_body import CONTROL_PERIOD, SensorReading
from housefly.wires.crazyflie.supervisor import SupervisorInfo

LEVEL_AFTER, CUT_AFTER = 0.5, 2.0
"""Age of the setpoint after which it levels out, and cuts its motors [s]."""
FLYING_FOR = 2.0
"""It counts as flying for so long after its motors last turned [s]."""
PREFLIGHT_TIME, LANDED_TIME = 30.0, 3.0
"""Armed, it disarms unless it flies within this; and so long after a landing [s]."""
_WATCHDOG_TIME = 1.0
_TILT_COSINE, _TILT_TIME = 0.5, 1.0
_UPSIDE_COSINE, _UPSIDE_TIME = -0.2, 0.1
"""Lean beyond which it has tumbled, after how long [s]."""


class SupervisorState(Enum):
    """What the supervisor has found."""

    NOT_CHECKED = "checks not passed"
    CHECKED = "checks passed"
    READY = "ready to fly"
    FLYING = "flying"
    LEVEL_OUT = "levels out"
    LANDED = "landed"
    CRASHED = "crashed"
    LOCKED = "locked"


_S = SupervisorState
_CAN_FLY = frozenset({_S.READY, _S.FLYING, _S.LEVEL_OUT, _S.LANDED})
_IN_FLIGHT = frozenset({_S.FLYING, _S.LEVEL_OUT})


class Supervisor:
    """Follows the drone, one control period at a time.

    Args:
        arms_itself: whether nobody has to arm it.

    Attributes:
        state: what it has found.
        is_armed: whether it was armed.
    """

    def __init__(self, arms_itself: bool) -> None:
        self._arms_itself = arms_itself
        self.state, self.is_armed = _S.NOT_CHECKED, False
        self._now = self._since = 0.0
        self._turned_at: float | None = None
        self._fed_at: float | None = None
        self._tilted_for = 0.0
        self._is_stopped = self._is_tumbled = self._is_crashed = False

    @property
    def can_fly(self) -> bool:
        """Whether its motors may turn."""
        return self.state in _CAN_FLY

    @property
    def is_flying(self) -> bool:
        """Whether it flies, by its own word."""
        return self.state in _IN_FLIGHT

    @property
    def info(self) -> SupervisorInfo:
        """What it says, but for the high-level commander."""
        bits = (
            (self.state is _S.CHECKED, SupervisorInfo.CAN_BE_ARMED),
            (self.is_armed, SupervisorInfo.IS_ARMED),
            (self._arms_itself, SupervisorInfo.ARMS_ITSELF),
            (self.can_fly, SupervisorInfo.CAN_FLY),
            (self.is_flying, SupervisorInfo.IS_FLYING),
            (self._is_tumbled, SupervisorInfo.IS_TUMBLED),
            (self.state is _S.LOCKED, SupervisorInfo.IS_LOCKED),
            (self._is_crashed, SupervisorInfo.IS_CRASHED),
        )
        return SupervisorInfo(sum(bit for is_set, bit in bits if is_set))

    def arm(self, on: bool) -> bool:
        """Arm or disarm it; return whether that was possible."""
        if on and not self.is_armed and self.state is not _S.CHECKED:
            return False
        self.is_armed = on
        return True

    def recover(self) -> bool:
        """Forget a crash; return whether that was possible."""
        if self._is_crashed and self._is_tumbled:
            return False
        self._is_crashed = False
        return True

    def stop(self) -> None:
        """Cut the motors until somebody switches it off and on."""
        self._is_stopped = True

    def feed_watchdog(self) -> None:
        """Start a watchdog that stops it, or keep that waiting for another second."""
        self._fed_at = self._now

    def restart(self) -> None:
        """Be switched off and on."""
        self.__init__(self._arms_itself)  # type: ignore[misc]

    def begin_flying(self) -> None:
        """Fly from now on: for a flight that begins in the air."""
        self.is_armed, self._turned_at = True, self._now
        self._enter(_S.FLYING)

    def update(self, measured: SensorReading, turns: bool, setpoint_age: float) -> None:
        """Look at the drone once a control period.

        Args:
            measured: the sensors' newest reading.
            turns: whether a motor turned faster than at idle.
            setpoint_age: [s].
        """
        self._now += CONTROL_PERIOD
        if turns:
            self._turned_at = self._now
        self._is_tumbled = self._has_tumbled(measured)
        following = self._following(setpoint_age)
        if following is not self.state:
            self._enter(following)

    def _enter(self, state: SupervisorState) -> None:
        self.state, self._since = state, self._now
        if state is _S.CRASHED:
            self._is_crashed = True
        if not self.can_fly:
            self.is_armed = state is _S.CHECKED and self._arms_itself

    def _following(self, setpoint_age: float) -> SupervisorState:
        state, thrusts = self.state, self._thrusts()
        if state is _S.LOCKED or self._is_stopped or self._is_starved():
            return _S.LOCKED
        for_long = self._now - self._since
        match state:
            case _S.NOT_CHECKED:
                return state if self._is_tumbled else _S.CHECKED
            case _S.CHECKED if self._is_tumbled:
                return _S.NOT_CHECKED
            case _S.CHECKED:
                return _S.READY if self.is_armed else state
            case _S.READY if self._is_tumbled or not self.is_armed or for_long > PREFLIGHT_TIME:
                return _S.NOT_CHECKED
            case _S.READY:
                return _S.FLYING if thrusts else state
            case _S.FLYING | _S.LEVEL_OUT:
                return self._in_flight(setpoint_age, thrusts)
            case _S.LANDED if for_long > LANDED_TIME or not self.is_armed:
                return _S.NOT_CHECKED
            case _S.LANDED:
                return _S.FLYING if thrusts else state
            case _:
                return state if self._is_crashed else _S.NOT_CHECKED

    def _in_flight(self, setpoint_age: float, thrusts: bool) -> SupervisorState:
        if setpoint_age > CUT_AFTER:
            return _S.LOCKED
        if self._is_tumbled:
            return _S.CRASHED if self.state is _S.FLYING else _S.LOCKED
        if not self.is_armed:
            return _S.NOT_CHECKED
        if setpoint_age > LEVEL_AFTER:
            return _S.LEVEL_OUT
        return _S.FLYING if thrusts else _S.LANDED

    def _thrusts(self) -> bool:
        return self._turned_at is not None and self._now - self._turned_at < FLYING_FOR

    def _is_starved(self) -> bool:
        return self._fed_at is not None and self._now - self._fed_at > _WATCHDOG_TIME

    def _has_tumbled(self, measured: SensorReading) -> bool:
        upright = cos(measured.phi) * cos(measured.theta)
        self._tilted_for = self._tilted_for + CONTROL_PERIOD if upright < _TILT_COSINE else 0.0
        is_upside = upright < _UPSIDE_COSINE
        return self._tilted_for > (_UPSIDE_TIME if is_upside else _TILT_TIME)
