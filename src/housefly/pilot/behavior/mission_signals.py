"""What happened to the mission: signals from the drone's status, its place and the time."""

from __future__ import annotations

from dataclasses import dataclass
from math import dist, hypot, inf, isfinite

from housefly.config.limits import LimitsConfig
from housefly.geometry import distance
from housefly.messages.flight import OrderKind, Phase
from housefly.messages.sensing import DroneStatus
from housefly.pilot.behavior.mission import MissionState, TrackingTask, VehicleStatus
from housefly.pilot.behavior.mission_tables import Signal
from housefly.pilot.behavior.path_progress import TrajectorySetpoint

HOME_TOLERANCE = 0.08
"""The drone is above its pad when nearer than this [m] ..."""
HOME_TIMEOUT = 6.0
"""... or, when it does not get that near for this long [s], nearer than the tolerance of any goal.
"""
ARRIVAL_SPEED = 0.15
"""The drone has arrived only when slower than this [m/s]."""
ARRIVAL_TIME = 0.4
"""The conditions of arrival must hold for this long [s] ..."""
REST_DISTANCE, REST_SPEED = 0.05, 0.1
"""... or, at the end of a trajectory in space, which comes to rest by itself, the drone is as near
to it and as slow as this [m, m/s].
"""
FACING_TIMEOUT = 5.0
"""Looking counts from here when the drone never quite faces the subject [s]."""
OVERDUE_FACTOR, OVERDUE_EXTRA = 3.0, 30.0
"""A flight is overdue after this multiple of its expected time, plus so many seconds."""
WAITING_TIMEOUT = 20.0
"""A drone that waits for its way to become free turns home after this, and lands after another such
time [s].
"""

STATUS_SIGNALS = {
    DroneStatus.FLYING: Signal.AIRBORNE,
    DroneStatus.LANDING: Signal.SINKING,
    DroneStatus.LANDED: Signal.GROUNDED,
    DroneStatus.EMERGENCY: Signal.EMERGENCY,
}
"""The signal in each word of the drone; taking off and unknown say nothing new."""


@dataclass(frozen=True, slots=True)
class SignalTimers:
    """Since when things hold [s]; infinite while they do not.

    Attributes:
        near: near enough to the goal and slow.
        ended: the reference stands at the end of the path.
        facing: facing what is to be looked at.
    """

    near: float = inf
    ended: float = inf
    facing: float = inf

    def updated(self, now: float, near: bool, ended: bool, facing: bool) -> SignalTimers:
        """Return the timers after one more look."""
        return SignalTimers(
            near=min(self.near, now) if near else inf,
            ended=min(self.ended, now) if ended else inf,
            facing=min(self.facing, now) if facing else self.facing,
        )


def is_near(
    vehicle: VehicleStatus,
    target: TrajectorySetpoint,
    tolerance: float,
    state: MissionState,
    timers: SignalTimers,
    paper: bool,
) -> bool:
    """Return whether the drone is where the path ends.

    In mode paper nearer than eps3 is enough (q4); in mode default it must also be slow, and nearer
    still above its pad.
    """
    if vehicle.estimate is None or not target.finished:
        return False
    (x, y, _), (vx, vy, _) = vehicle.estimate.position, vehicle.estimate.velocity
    off = distance((x, y), (target.x, target.y))
    if paper:
        return off < tolerance
    is_exact = state.mission.kind is OrderKind.HOME and vehicle.now - timers.ended < HOME_TIMEOUT
    nearest = min(HOME_TOLERANCE, tolerance) if is_exact else tolerance
    return hypot(vx, vy) < ARRIVAL_SPEED and off < nearest


def is_at_rest(vehicle: VehicleStatus) -> bool:
    """Return whether the drone stands where a trajectory in space has ended."""
    if vehicle.reference is None or vehicle.estimate is None:
        return False
    target, estimate = vehicle.reference.target, vehicle.estimate
    off = dist(estimate.position, (target.x, target.y, target.z))
    slow = hypot(*estimate.velocity) < REST_SPEED
    return target.finished and slow and off < REST_DISTANCE


def signals(
    state: MissionState,
    task: TrackingTask,
    timers: SignalTimers,
    vehicle: VehicleStatus,
    limits: LimitsConfig,
    facing: bool,
) -> list[Signal]:
    """Return what happened, in the order in which it counts.

    Args:
        state: of the mission.
        task: what the drone tracks.
        timers: since when it is near and facing.
        vehicle: status and place of the drone.
        limits: timeouts.
        facing: whether the heading is the wanted one.
    """
    now, phase = vehicle.now, state.phase
    found = _told(state, vehicle, limits)
    if vehicle.landing_forced:
        found.append(Signal.FORCED_DOWN)
    if vehicle.return_wanted:
        found.append(Signal.RETURN_WANTED)
    is_settled = now - timers.near >= ARRIVAL_TIME
    is_settled = is_settled or (isfinite(timers.near) and is_at_rest(vehicle))
    has_settled = is_settled and not task.waiting
    if phase in (Phase.OUTBOUND, Phase.RETURNING) and has_settled:
        found.extend(_arrivals(state, facing))
    if task.waiting and now - task.since > WAITING_TIMEOUT:
        found.append(Signal.BLOCKED)
    has_looked = now - _looking_since(state, timers) >= state.mission.look_s
    if phase is Phase.LOOKING and has_looked:
        found.append(Signal.LOOKED)
    is_bound = not (phase is Phase.HOLDING and (state.stopped or vehicle.maneuvering))
    if is_bound and now - state.since > allowed_time(state, task, limits):
        found.append(Signal.OVERDUE)
    return found


def _told(state: MissionState, vehicle: VehicleStatus, limits: LimitsConfig) -> list[Signal]:
    """Return what the drone says; a silent one that last stood may have taken off since."""
    is_old = vehicle.telemetry_age > limits.telemetry_age
    if vehicle.status not in STATUS_SIGNALS or (is_old and vehicle.status is DroneStatus.LANDED):
        return []
    if state.was_cut and vehicle.status is DroneStatus.FLYING:
        return [Signal.FLIES_AFTER_CUT]
    return [STATUS_SIGNALS[vehicle.status]]


def allowed_time(state: MissionState, task: TrackingTask, limits: LimitsConfig) -> float:
    """Return how long the present phase may take [s].

    Under STOP the drone holds for as long as charge and clock allow, and a maneuver has its own
    end. The gate ends a landing that takes too long.
    """
    match state.phase:
        case Phase.IDLE:
            return inf
        case Phase.TAKING_OFF:
            return limits.take_off_timeout
        case Phase.OUTBOUND | Phase.RETURNING:
            return OVERDUE_FACTOR * task.duration + OVERDUE_EXTRA
        case Phase.LOOKING:
            return state.mission.look_s + 2.0 * FACING_TIMEOUT
        case Phase.HOLDING:
            return limits.hold_timeout
        case Phase.LANDING:
            return limits.landing_timeout


def _arrivals(state: MissionState, facing: bool) -> list[Signal]:
    if state.mission.kind is OrderKind.SERVICE:
        return [Signal.ARRIVED_TO_LOOK]
    if state.mission.kind is OrderKind.GO:
        return [Signal.ARRIVED_TO_STAY]
    return [Signal.ARRIVED_HOME] if facing else []


def _looking_since(state: MissionState, timers: SignalTimers) -> float:
    return min(max(timers.facing, state.since), state.since + FACING_TIMEOUT)
