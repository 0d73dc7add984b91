"""What a Crazyflie is sent for what it is told: take-off, flight, standstill, landing; pure.

It takes off by places that rise, so that its own watchdog ends what we no longer say: it levels out
after half a second and cuts its motors after two. It lands by its high-level commander, which goes
on to the floor when we are gone; that setpoints stop is said once it has answered, because the
commander wants the motors off while it has nothing to fly. A stream is never ended by silence.
Where tracking is silent it can do neither: it sinks level for as long as its height needs, by the
pilot's setpoints or ours, and stops.
"""

from __future__ import annotations

from enum import Enum
from math import cos, dist, inf, sin

from housefly.drones.crazyflie.reports import OwnState
from housefly.geometry import Vec2, wrap_angle
from housefly.messages import (
    Action,
    AnySetpoint,
    DroneStatus,
    PositionSetpoint,
    Setpoint,
    Sighting,
    VelocitySetpoint,
)
from housefly.messages.steering import Instruction
from housefly.wires.crazyflie.crtp import Packet
from housefly.wires.crazyflie.high_level import Land, encode_high_level
from housefly.wires.crazyflie.localization import encode_emergency_stop
from housefly.wires.crazyflie.setpoints import (
    AltHold,
    FullState,
    GenericSetpoint,
    Place,
    Stop,
    WorldVelocity,
    ZDistance,
    encode_setpoint,
    notify_setpoints_stop,
)
from housefly.wires.crazyflie.supervisor import (
    SUPERVISOR_SINCE,
    SupervisorInfo,
    SupervisorOrder,
    encode_arming_by_platform,
    encode_order,
    encode_recovery_by_platform,
)

CLIMB_RATE, TAKE_OFF_HEIGHT = 0.5, 1.0
"""Of a take-off: how fast the place rises that it flies to [m/s], and how high [m]."""
ARRIVED = 0.95
"""A take-off is over above this share of its height."""
HEIGHT_GAIN = 2.0
"""How fast it climbs to a height that is asked for [1/s]; ``settings`` sees to it."""
LANDING_RATE, SINK_RATE = 0.3, 0.3
"""Of a landing by its own commander on average, and of one without tracking [m/s]."""
LANDING_TIME_MIN = 1.0
"""Shortest landing [s]."""
POSE_AGE_MAX = 0.3
"""An older pose is no ground to fly to a place [s]."""
DISAGREES = 0.2
"""A drone that believes to be so far from where tracking sees it does not take off [m]."""
_SURPLUS = 0.7
"""A descent without tracking goes on for so long where the floor should be [s]."""
_ASK_AGAIN = 0.1
"""Orders that must arrive are repeated after this [s]."""
_GIVEN_UP_AFTER, _LOW = 0.5, 0.15
"""A landing that its commander has given up after this [s], above this [m], is ordered again."""
_STILL_FLYING = 2.5
"""Motors that have stopped are still called flying for up to this [s] (supervisor.c: 2 s)."""
_TURN_LEAD = 0.25
"""A place is faced so far ahead of a turn [s]."""


class _Doing(Enum):
    NOTHING = "nothing"
    TAKING_OFF = "taking off"
    FLYING = "flying"
    LANDING = "landing"


class Manoeuvres:
    """Knows what the drone is about.

    Args:
        by_state: whether the pilot's places are told as full states.

    Attributes:
        protocol: version of its CRTP; says where it is armed and stopped.
    """

    def __init__(self, *, by_state: bool = False) -> None:
        self.protocol = SUPERVISOR_SINCE
        self._by_state = by_state
        self._doing, self._since = _Doing.NOTHING, -inf
        self._start: Place | None = None
        self._held: Place | None = None
        self._height, self._height_at = 0.0, -inf
        self._vz = 0.0
        self._asked_at = self._stopped_at = -inf
        self._lands_itself = self._sinks = False
        self._landing_time = LANDING_TIME_MIN

    def status(self, state: OwnState) -> DroneStatus:
        """Return what the drone is doing, by its own word and by what it was told."""
        if state.is_grounded:
            return DroneStatus.EMERGENCY
        if not state.is_flying:
            return DroneStatus.LANDED
        return _STATUS[self._doing]

    def hear_landing(self) -> None:
        """Note that its high-level commander lands it."""
        self._lands_itself = self._doing is _Doing.LANDING

    def packets(
        self, told: Instruction, state: OwnState, seen: Sighting | None, now: float
    ) -> tuple[Packet, ...]:
        """Return what to send now.

        Args:
            told: what the failsafe decided.
            state: what the drone told last.
            seen: where tracking saw it last.
            now: [s].
        """
        action = told.command.action
        seen = seen if seen is not None and now - seen.captured_at <= POSE_AGE_MAX else None
        self._follow(seen, now)
        if action is Action.CUT:
            return self._cut(now)
        if action is Action.RESET:
            return self._recover(now)
        if not state.has_state:
            return ()
        if action is Action.LAND or (action is Action.IDLE and told.lands_all):
            return self._land(state, seen, now)
        if action is Action.TAKE_OFF:
            return self._take_off(state, seen, now)
        if action is Action.IDLE or not state.is_flying:
            self._begin(_Doing.NOTHING, now)
            return ()
        self._begin(_Doing.FLYING, now)
        if action is Action.HOVER:
            return self._hover(seen)
        self._held = None
        if seen is None and self._must_be_down:
            return self._give(Stop())
        return self._fly(told.command.asked, state, is_seen=seen is not None)

    def _follow(self, seen: Sighting | None, now: float) -> None:
        """Know how high it is: by tracking, and by what it was told where that is silent."""
        if seen is not None:
            self._height, self._height_at = seen.pose.position[2], now
            return
        self._height += self._vz * max(0.0, min(now - self._height_at, 0.1))
        self._height_at = now

    @property
    def _must_be_down(self) -> bool:
        """Whether it has sunk without tracking for longer than its height needs."""
        return self._height < -_SURPLUS * SINK_RATE

    def _begin(self, doing: _Doing, now: float) -> None:
        if doing is self._doing:
            return
        self._doing, self._since, self._asked_at = doing, now, -inf
        self._start = self._held = None
        self._lands_itself = self._sinks = False
        self._vz = 0.0

    def _take_off(self, state: OwnState, seen: Sighting | None, now: float) -> tuple[Packet, ...]:
        if self._doing is _Doing.FLYING and state.is_flying:
            return self._hover(seen)
        if SupervisorInfo.CAN_FLY not in state.info:
            return self._arm(state, now)
        if self._start is None:
            if seen is None or dist(seen.pose.position, state.place) > DISAGREES:
                return ()
            self._begin(_Doing.TAKING_OFF, now)
            self._start = Place(*seen.pose.position, seen.pose.yaw)
        if state.is_flying and state.place[2] > ARRIVED * TAKE_OFF_HEIGHT:
            self._begin(_Doing.FLYING, now)
            return self._hover(seen)
        if seen is None:
            return self._give(AltHold(0.0, 0.0, 0.0, 0.0))
        start = self._start
        z = min(start.z + CLIMB_RATE * (now - self._since), TAKE_OFF_HEIGHT)
        return self._give(Place(start.x, start.y, z, start.yaw))

    def _hover(self, seen: Sighting | None) -> tuple[Packet, ...]:
        if seen is None:
            self._held = None
            return self._give(AltHold(0.0, 0.0, 0.0, 0.0))
        if self._held is None:
            self._held = Place(*seen.pose.position, seen.pose.yaw)
        return self._give(self._held)

    def _fly(self, asked: AnySetpoint, state: OwnState, *, is_seen: bool) -> tuple[Packet, ...]:
        match asked:
            case Setpoint(theta, phi, vz, yaw_rate) if vz > 0.0 and is_seen:
                # in silence it would climb on, but goes no higher than a height
                height = state.place[2] + vz / HEIGHT_GAIN
                return self._give(ZDistance(phi, theta, yaw_rate, height))
            case Setpoint(theta, phi, vz, yaw_rate):
                return self._give(AltHold(phi, theta, yaw_rate, vz))
            case VelocitySetpoint(forward, left, vz, yaw_rate):
                vx, vy = _turned((forward, left), state.yaw)
                return self._give(WorldVelocity(vx, vy, vz, yaw_rate))
            case PositionSetpoint() if not is_seen:
                # without poses it would fly to where it wrongly believes that place to be
                return self._give(AltHold(0.0, 0.0, 0.0, 0.0))
            case PositionSetpoint(x, y, z, yaw_rate):
                yaw = wrap_angle(state.yaw + _TURN_LEAD * yaw_rate)
                if self._by_state:
                    return self._give(FullState((x, y, z), yaw=yaw, yaw_rate=yaw_rate))
                return self._give(Place(x, y, z, yaw))

    def _land(self, state: OwnState, seen: Sighting | None, now: float) -> tuple[Packet, ...]:
        self._begin(_Doing.LANDING, now)
        if not state.is_flying:
            return ()
        if self._lands_itself and not self._must_land_it(state, seen, now):
            return self._stop_setpoints(now)
        self._lands_itself = False
        if seen is None:
            return self._sink(now)
        self._sinks = False
        if now - self._asked_at < _ASK_AGAIN:
            return ()
        self._asked_at = now
        self._landing_time = max(seen.pose.position[2] / LANDING_RATE, LANDING_TIME_MIN)
        return (encode_high_level(Land(0.0, self._landing_time)),)

    def _must_land_it(self, state: OwnState, seen: Sighting | None, now: float) -> bool:
        """Return whether its commander cannot be left to land it: blind, or it has given up.

        A setpoint that came late stops it in the air. Down by its own reckoning it has stopped the
        motors, and is called flying for two seconds more.
        """
        if state.place[2] < _LOW or self._height < _LOW:
            return False
        if seen is None:
            return True
        waited, is_active = now - self._asked_at, SupervisorInfo.HIGH_LEVEL_ACTIVE in state.info
        is_over = self._landing_time < waited < self._landing_time + _STILL_FLYING
        return waited > _GIVEN_UP_AFTER and not is_active and not is_over

    def _stop_setpoints(self, now: float) -> tuple[Packet, ...]:
        """Say that setpoints stop, again and again: where it is lost, its watchdog cuts the motors.

        It must not come before the landing is answered: a commander with nothing to fly cuts them.
        """
        if now - self._stopped_at < _ASK_AGAIN:
            return ()
        self._stopped_at = now
        return (notify_setpoints_stop(),)

    def _sink(self, now: float) -> tuple[Packet, ...]:
        """Sink level until the floor must be there, then stop."""
        if not self._sinks:
            self._sinks, self._since = True, now
        if self._must_be_down:
            return self._give(Stop())
        return self._give(AltHold(0.0, 0.0, 0.0, -SINK_RATE))

    def _give(self, setpoint: GenericSetpoint) -> tuple[Packet, ...]:
        self._vz = setpoint.vz if isinstance(setpoint, AltHold | WorldVelocity) else 0.0
        return (encode_setpoint(setpoint),)

    def _arm(self, state: OwnState, now: float) -> tuple[Packet, ...]:
        if SupervisorInfo.CAN_BE_ARMED not in state.info or not self._asks(now):
            return ()
        if self.protocol < SUPERVISOR_SINCE:
            return (encode_arming_by_platform(True),)
        return (encode_order(SupervisorOrder.ARM),)

    def _cut(self, now: float) -> tuple[Packet, ...]:
        if not self._asks(now):
            return ()
        if self.protocol < SUPERVISOR_SINCE:
            return encode_emergency_stop(), encode_setpoint(Stop())
        return encode_order(SupervisorOrder.EMERGENCY_STOP), encode_setpoint(Stop())

    def _recover(self, now: float) -> tuple[Packet, ...]:
        if not self._asks(now):
            return ()
        if self.protocol < SUPERVISOR_SINCE:
            return (encode_recovery_by_platform(),)
        return (encode_order(SupervisorOrder.RECOVER),)

    def _asks(self, now: float) -> bool:
        """Return whether an order is due again that is repeated until it shows."""
        if now - self._asked_at < _ASK_AGAIN:
            return False
        self._asked_at = now
        return True


_STATUS = {
    _Doing.NOTHING: DroneStatus.FLYING,
    _Doing.TAKING_OFF: DroneStatus.TAKING_OFF,
    _Doing.FLYING: DroneStatus.FLYING,
    _Doing.LANDING: DroneStatus.LANDING,
}


def _turned(vector: Vec2, by: float) -> Vec2:
    c, s = cos(by), sin(by)
    return c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]
