"""What the estimator is told, remembers and answers."""

from __future__ import annotations

from enum import IntEnum
from math import inf
from typing import NamedTuple

from housefly.geometry import Vec2
from housefly.pilot.estimation.climb_axis import ClimbModel
from housefly.pilot.estimation.climb_filter import ClimbState
from housefly.pilot.estimation.delay_estimate import DelayEstimate
from housefly.pilot.estimation.delay_filter import DelayFilterState
from housefly.pilot.estimation.height_yaw import HeightYawState
from housefly.pilot.estimation.lagged_axis import AxisModel
from housefly.pilot.estimation.paper_filter import PaperFilterState
from housefly.pilot.estimation.stream_health import StreamHealth

LIFT_UNKNOWN = ClimbModel(pole=1.4, sink_gain=1.0, noise=1.0, wander=0.0)
"""Height without a disturbance state."""


class EstimatorKind(IntEnum):
    """The horizontal filter: ours, the paper's, the paper's fed the held sample each tick, none."""

    DELAY_COMPENSATED = 0
    ON_ARRIVAL = 1
    HELD_SAMPLE = 2
    FINITE_DIFFERENCE = 3


class EstimatorParameters(NamedTuple):
    """What the estimator is told beforehand.

    Attributes:
        kind: an ``EstimatorKind``.
        model: prediction of the delay-compensated filter.
        delay: command delay [s].
        acceleration_noise: one-sigma unmodelled acceleration [m/s^2]; for the paper's filter a
            spectral density [m/s^1.5].
        position_noise: one sigma of a sighting [m].
        climb: prediction of the height; without wander height has no disturbance state.
        delay_deviation: one sigma by which the command delay may be another [s]; 0 knows it.
        mistrust: share by which delays and lag may be other than believed, by which the gains are
            scheduled; 0 leaves them alone.
    """

    kind: int
    model: AxisModel
    delay: float
    acceleration_noise: float
    position_noise: float
    climb: ClimbModel = LIFT_UNKNOWN
    delay_deviation: float = 0.0
    mistrust: float = 0.0


class Measurement(NamedTuple):
    """One sighting as numbers: time of capture [s], position [m], heading [rad]."""

    captured_at: float
    x: float
    y: float
    z: float
    yaw: float


class PoseGate(NamedTuple):
    """What decides whether the next sighting is accepted.

    Attributes:
        initialized: a sighting was accepted.
        rejecting: the last one was rejected.
        last_capture: of the last one accepted [s].
        innovation_variance: by which the delay-compensated filter judges [m^2].
    """

    initialized: bool
    rejecting: bool
    last_capture: float
    innovation_variance: float


class HeldSample(NamedTuple):
    """The newest sample and its finite difference [m, m/s]."""

    x: float
    y: float
    vx: float
    vy: float


class EstimatorState(NamedTuple):
    """Everything that the estimator remembers; of the horizontal filters only one is kept up."""

    gate: PoseGate
    height_yaw: HeightYawState
    delay_filter: DelayFilterState
    paper_filter: PaperFilterState
    sample: HeldSample
    climb: ClimbState
    delay: DelayEstimate
    health: StreamHealth


class PoseEstimate(NamedTuple):
    """Where the drone is now: position [m], velocity [m/s], heading [rad]."""

    x: float
    y: float
    z: float
    vx: float
    vy: float
    vz: float
    yaw: float


class ControlState(NamedTuple):
    """Where the drone is when a command given now begins to act.

    Attributes:
        position, velocity: in the plane [m, m/s].
        disturbance: steady push to be cancelled [m/s^2].
        height: [m].
        yaw: [rad].
        climb: climb rate [m/s]; counts only with a disturbance state of the height.
        lift: steady vertical push to be cancelled [m/s^2].
        delay_change: how much later than the site says a command acts [s].
        bandwidth: largest natural frequency that tracking and delays allow [rad/s].
    """

    position: Vec2
    velocity: Vec2
    disturbance: Vec2
    height: float
    yaw: float
    climb: float = 0.0
    lift: float = 0.0
    delay_change: float = 0.0
    bandwidth: float = inf
