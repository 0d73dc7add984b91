"""What the safety gate works out of one flight so far: what no single step shows."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, dist, exp, hypot, inf, isfinite, nan, sin, sqrt

from housefly.config.limits import LimitsConfig
from housefly.geometry import GRAVITY, Vec2, wrap_angle
from housefly.messages.flight import Phase
from housefly.messages.sensing import DroneStatus
from housefly.messages.steering import Setpoint
from housefly.numeric import running_sum
from housefly.pilot.safety.energy import NO_ENERGY, EnergyBudget, EnergyMonitor
from housefly.pilot.safety.inputs import GateInputs
from housefly.pilot.safety.lean_consistency import LeanConsistency
from housefly.pilot.safety.timers import Stopwatch, Window

TILT_TIME_CONSTANT = 0.2
"""Time constant with which what we ask for is smoothed, about that of the drone's answer [s]."""
VELOCITY_SPAN = 0.2
"""Velocities are compared over this span [s]."""
SETTLING_TIME = 0.5
"""After old poses or late steps the estimated velocity is put right for so long [s]."""
RECOVERY_TIME = 1.0
"""After old poses or late steps the drone's own velocity is put right for so long [s]."""
HOLD_SPAN = 10.0
"""How far back holding, and leaning otherwise than told, are added up [s]."""
TAKE_OFF_TIME_CONSTANT = 0.15
"""Time constant with which the velocity of a take-off is smoothed [s]: filters may be noisy."""
VELOCITY_ERROR_TIME_CONSTANT = 4.0
"""Time constant of the mean square of the velocity error [s]."""
VELOCITY_ERROR_CAP = 0.3
"""A larger error counts as this: one hard stop is not seconds of gusts [m/s]."""
TILT_ERROR_MAX = 0.2
"""The attitude may differ from what we ask for by this [rad]."""
LATE_SPAN = 1.0
"""How far back late steps are counted [s]."""
LATE_STEP = 0.05
"""A step later than this is a late one [s]."""
FOLLOWED_STEP = 0.1
"""The height of a trajectory is another one only when it jumps by more than this in a step [m]:
as long as it moves smoothly the drone is to be at it.
"""
STEP_MAX = 0.1
"""A step counts for no more than this [s]."""


def control_error(now: GateInputs) -> float:
    """Return how far the drone is from where it should be, in the plane [m]; 0 where unknown."""
    if now.reference is None or now.position is None:
        return 0.0
    return dist(now.position[:2], now.reference.position[:2])


def velocity_error(now: GateInputs) -> float:
    """Return how much the velocity differs from the wanted one [m/s]; 0 where unknown."""
    if now.reference is None or now.velocity is None or now.flown is None:
        return 0.0
    return dist(now.velocity[:2], now.reference.velocity[:2])


@dataclass(frozen=True, slots=True)
class FlightObservations:
    """What a flight has shown so far.

    Attributes:
        cruising_for: how long the drone has flown and not been told to land [s].
        climbing_for: how long the drone has flown at its present wanted height [s].
        standing_height: tracked height of a drone that stands [m].
        start: where it took off [m]; None before it was seen standing.
        take_off_velocity: smoothed velocity in the plane while it takes off [m/s]; None else.
        take_off_turn: how far it has turned since it stood, while it takes off [rad]; 0 else.
        tilt_asked: smoothed tilt that we ask for [rad]; nan while the drone flies itself.
        tilt_error: angle between that attitude and the one that the drone reports [rad]; nan where
            either is unknown.
        tilt_wrong_for: how long that was above ``TILT_ERROR_MAX`` in the last ``HOLD_SPAN`` [s].
        velocity_change: within ``VELOCITY_SPAN``, in the plane [m/s].
        unexplained_change: the same, less what the reported lean did [m/s]; infinite where that is
            unknown.
        velocity_error: rms off the wanted velocity, over ``VELOCITY_ERROR_TIME_CONSTANT`` [m/s].
        held_for: how long it was held in the last ``HOLD_SPAN`` [s].
        late_steps: how many steps of the last ``LATE_SPAN`` were late.
        landing_for: how long a landing has been wanted [s].
        leans_mirrored: in this flight tracking has shown the opposite of what the lean does; only
            looked for where the drone does not tell its speed.
        energy: what charge and clock still allow.
    """

    cruising_for: float = 0.0
    climbing_for: float = 0.0
    standing_height: float = 0.0
    start: Vec2 | None = None
    take_off_velocity: Vec2 | None = None
    take_off_turn: float = 0.0
    tilt_asked: float = nan
    tilt_error: float = nan
    tilt_wrong_for: float = 0.0
    velocity_change: float = 0.0
    unexplained_change: float = inf
    velocity_error: float = 0.0
    held_for: float = 0.0
    late_steps: int = 0
    landing_for: float = 0.0
    leans_mirrored: bool = False
    energy: EnergyBudget = NO_ENERGY


NOTHING_OBSERVED = FlightObservations()


class FlightObserver:
    """Remembers one flight; fed once a step.

    Args:
        limits: of the site.
        tells_speed: the drone tells its own speed, by which others judge tracking.
    """

    def __init__(self, limits: LimitsConfig, *, tells_speed: bool = True) -> None:
        self._limits, self._tells_speed = limits, tells_speed
        self._lean_consistency: LeanConsistency | None = None
        self._leans_mirrored = False
        self._energy = EnergyMonitor(limits)
        self._now = inf
        self._cruising, self._climbing, self._landing = Stopwatch(), Stopwatch(), Stopwatch()
        self._height = inf
        self._standing_height = inf
        self._start: Vec2 | None = None
        self._standing_yaw = nan
        self._take_off_velocity: Vec2 | None = None
        self._tilt_asked: Vec2 | None = None
        self._velocities: Window[Vec2] = Window(VELOCITY_SPAN)
        self._unexplained: Window[Vec2] = Window(VELOCITY_SPAN)
        self._lean_velocity: Vec2 = (0.0, 0.0)
        self._error_squared = 0.0
        self._steady = Stopwatch()
        self._held: Window[float] = Window(HOLD_SPAN)
        self._tilted: Window[float] = Window(HOLD_SPAN)
        self._late: Window[float] = Window(LATE_SPAN)

    def observe(
        self, inputs: GateInputs, held: bool, landing: bool, waits: bool = False
    ) -> FlightObservations:
        """Take one step in.

        Args:
            inputs: of the step.
            held: a rule made the drone hold in the step before.
            landing: the gate is landing the drone ...
            waits: ... once the floor below is clear.
        """
        now = inputs.now
        elapsed = max(now - self._now, 0.0)
        dt = min(elapsed, STEP_MAX)
        self._now = now
        self._learn_standing_height(inputs)
        self._smooth_tilt_asked(inputs, dt)
        tilt_error = self._tilt_error(inputs)
        is_tilted = inputs.cruising and tilt_error > TILT_ERROR_MAX
        steady = self._steady_for(inputs)
        is_landing = landing or inputs.phase is Phase.LANDING
        wants_down = inputs.airborne and is_landing and not waits
        return FlightObservations(
            cruising_for=self._cruising.update(inputs.cruising, now),
            climbing_for=self._climbing_for(inputs),
            standing_height=self._standing_height if isfinite(self._standing_height) else 0.0,
            start=self._start,
            take_off_velocity=self._smoothed_take_off_velocity(inputs, dt),
            take_off_turn=self._take_off_turn(inputs),
            tilt_asked=hypot(*self._tilt_asked) if self._tilt_asked else nan,
            tilt_error=tilt_error,
            tilt_wrong_for=_total_time(self._tilted, now, dt if is_tilted else 0.0),
            velocity_change=self._velocity_change(inputs, steady),
            unexplained_change=self._unexplained_change(inputs, dt),
            velocity_error=self._velocity_error(inputs, steady, dt),
            # Not cut off: a pilot whose every step is late would be held for ever.
            held_for=_total_time(
                self._held, now, min(elapsed, HOLD_SPAN) if held and inputs.airborne else 0.0
            ),
            late_steps=self._late_steps(inputs),
            landing_for=self._landing.update(wants_down, now),
            leans_mirrored=self._is_mirrored(inputs, steady, dt),
            energy=self._energy.observe(inputs),
        )

    def _learn_standing_height(self, inputs: GateInputs) -> None:
        """Learn where a drone stands; of its heights the lowest, it may be on something."""
        is_seen = inputs.position is not None and inputs.pose_age <= self._limits.pose_age_level
        if inputs.status is DroneStatus.LANDED and is_seen and inputs.position is not None:
            height = inputs.position[2]
            self._start, self._standing_yaw = inputs.position[:2], inputs.yaw
            self._standing_height = (
                min(self._standing_height, height) if isfinite(height) else self._standing_height
            )

    def _smoothed_take_off_velocity(self, inputs: GateInputs, dt: float) -> Vec2 | None:
        if inputs.status is not DroneStatus.TAKING_OFF or inputs.velocity is None:
            self._take_off_velocity = None
            return None
        (vx, vy), (x, y) = inputs.velocity[:2], self._take_off_velocity or (0.0, 0.0)
        share = 1.0 - exp(-dt / TAKE_OFF_TIME_CONSTANT)
        self._take_off_velocity = (x + share * (vx - x), y + share * (vy - y))
        return self._take_off_velocity

    def _take_off_turn(self, inputs: GateInputs) -> float:
        turn = inputs.yaw - self._standing_yaw
        is_known = inputs.status is DroneStatus.TAKING_OFF and isfinite(turn)
        return abs(wrap_angle(turn)) if is_known else 0.0

    def _climbing_for(self, inputs: GateInputs) -> float:
        is_same = inputs.flight_height == self._height or (
            inputs.height_follows and abs(inputs.flight_height - self._height) <= FOLLOWED_STEP
        )
        self._height = inputs.flight_height
        return self._climbing.update(inputs.cruising and is_same, inputs.now)

    def _smooth_tilt_asked(self, inputs: GateInputs, dt: float) -> None:
        if not isinstance(inputs.flown, Setpoint):
            self._tilt_asked = None
            return
        theta, phi = inputs.flown.theta, inputs.flown.phi
        before = self._tilt_asked or (0.0, 0.0)
        share = 1.0 - exp(-dt / TILT_TIME_CONSTANT)
        self._tilt_asked = (
            before[0] + share * (theta - before[0]),
            before[1] + share * (phi - before[1]),
        )

    def _tilt_error(self, inputs: GateInputs) -> float:
        telemetry = inputs.telemetry
        if self._tilt_asked is None or telemetry is None:
            return nan
        return hypot(self._tilt_asked[0] - telemetry.theta, self._tilt_asked[1] - telemetry.phi)

    def _steady_for(self, inputs: GateInputs) -> float:
        """Return for how long poses have been fresh and steps on time [s]."""
        is_late = inputs.late > LATE_STEP
        is_seen = inputs.pose_age <= self._limits.pose_age_level and not is_late
        return self._steady.update(is_seen, inputs.now)

    def _velocity_change(self, inputs: GateInputs, steady: float) -> float:
        """Return how much the velocity changed; what blindness made of it is no change."""
        is_steady = steady >= SETTLING_TIME
        if inputs.velocity is None or not inputs.cruising or not is_steady:
            self._velocities.clear()
            return 0.0
        vx, vy, _ = inputs.velocity
        self._velocities.add(inputs.now, (vx, vy))
        before_x, before_y = self._velocities.oldest(inputs.now)
        return hypot(vx - before_x, vy - before_y)

    def _unexplained_change(self, inputs: GateInputs, dt: float) -> float:
        """Return how much the velocity changed beyond what the lean did: a brake is no blow."""
        telemetry, (x, y) = inputs.telemetry, self._lean_velocity
        is_known = telemetry is not None and all(
            map(isfinite, (inputs.yaw, telemetry.theta, telemetry.phi))
        )
        if inputs.velocity is None or telemetry is None or not is_known:
            self._unexplained.clear()
            return inf
        c, s = cos(inputs.yaw), sin(inputs.yaw)
        ahead, left = GRAVITY * dt * sin(telemetry.theta), -GRAVITY * dt * sin(telemetry.phi)
        x, y = self._lean_velocity = x + c * ahead - s * left, y + s * ahead + c * left
        vx, vy, _ = inputs.velocity
        self._unexplained.add(inputs.now, (vx - x, vy - y))
        before_x, before_y = self._unexplained.oldest(inputs.now)
        return hypot(vx - x - before_x, vy - y - before_y)

    def _is_mirrored(self, inputs: GateInputs, steady: float, dt: float) -> bool:
        """Return whether tracking has shown the opposite of what the lean does in this flight."""
        told, velocity = inputs.telemetry, inputs.velocity
        if not inputs.airborne:
            self._leans_mirrored = False
        if (
            self._tells_speed
            or told is None
            or velocity is None
            or not inputs.airborne
            or not all(map(isfinite, (inputs.yaw, told.theta, told.phi)))
            or steady < SETTLING_TIME
        ):
            self._lean_consistency = None
            return self._leans_mirrored
        watch = self._lean_consistency = self._lean_consistency or LeanConsistency()
        now = watch.is_mirrored(dt, velocity[:2], inputs.yaw, told.theta, told.phi)
        self._leans_mirrored = self._leans_mirrored or now
        return self._leans_mirrored

    def _velocity_error(self, inputs: GateInputs, steady: float, dt: float) -> float:
        """Return the rms velocity error of this flight.

        It rests while the drone flies itself, and while it catches up with what was missed: a
        late pilot is no wind.
        """
        error = min(velocity_error(inputs), VELOCITY_ERROR_CAP)
        if not inputs.airborne:
            self._error_squared = 0.0
        elif (
            inputs.cruising
            and inputs.flown is not None
            and isfinite(error)
            and steady >= RECOVERY_TIME
        ):
            share = 1.0 - exp(-dt / VELOCITY_ERROR_TIME_CONSTANT)
            self._error_squared += share * (error * error - self._error_squared)
        return sqrt(self._error_squared)

    def _late_steps(self, inputs: GateInputs) -> int:
        if inputs.late > LATE_STEP:
            self._late.add(inputs.now, inputs.late)
        return len(self._late.values(inputs.now))


def _total_time(spans: Window[float], now: float, dt: float) -> float:
    """Take in a span of this length [s], and return the sum of those of late."""
    if dt:
        spans.add(now, dt)
    return running_sum(spans.values(now))
