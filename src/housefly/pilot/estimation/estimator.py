"""The estimator as one compiled composition: pose gate, height and yaw, and one horizontal filter.

The live pilot and the batch call the same functions. Which horizontal filter runs is a parameter;
two of the four exist only to be compared with.
"""

from __future__ import annotations

from enum import IntEnum
from math import inf
from typing import Any, NamedTuple

from housefly.geometry import Vec2
from housefly.numeric import compiled
from housefly.pilot.estimation.constant_velocity import ConstantVelocity
from housefly.pilot.estimation.delay_filter import (
    CommandHistory,
    DelayFilterState,
    axes_and_covariance_at,
    axes_at,
    command_recorded,
    delay_filter_advanced,
    delay_filter_created,
    delay_filter_initialized,
    delay_filter_updated,
    history_trimmed,
)
from housefly.pilot.estimation.height_yaw import (
    POSITION_GATE_FLOOR,
    HeightYawState,
    height_yaw_at,
    height_yaw_initialized,
    height_yaw_updated,
    within_gate,
)
from housefly.pilot.estimation.lagged_axis import AxisModel, initial_covariance
from housefly.pilot.estimation.paper_filter import (
    PaperFilterState,
    paper_filter_advanced,
    paper_filter_commanded,
    paper_filter_gated,
    paper_filter_initialized,
    paper_filter_updated,
)
from housefly.pilot.estimation.validation import SIGHTING_AGE_MAX, stamp_fault

HOVER_BRAKING = 1.5
"""How quickly the drone's own hover stops it, on top of drag [1/s]."""
DISTURBANCE_WANDER = 0.2
"""How fast the disturbance may change [m/s^2 per sqrt(s)]."""


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
    """

    kind: int
    model: AxisModel
    delay: float
    acceleration_noise: float
    position_noise: float


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
    """

    position: Vec2
    velocity: Vec2
    disturbance: Vec2
    height: float
    yaw: float


@compiled
def axis_model(lag: float, gain: float, drag: float, acceleration_noise: float) -> AxisModel:
    """Return the prediction of a drone: lambda [1/s], c / lambda, drag [1/s], noise [m/s^2]."""
    return AxisModel(
        lag=lag,
        gain=gain,
        drag=drag,
        hover_drag=drag + HOVER_BRAKING,
        noise=acceleration_noise,
        wander=DISTURBANCE_WANDER,
    )


@compiled
def estimator_created(
    history: CommandHistory, params: EstimatorParameters, now: float
) -> EstimatorState:
    """Return the state at a time [s] before any sighting."""
    noise = params.position_noise
    covariance = initial_covariance(noise * noise, params.acceleration_noise)
    nowhere = ConstantVelocity(0.0, 0.0, 0.0, 0.0, 0.0)
    return EstimatorState(
        gate=PoseGate(False, False, -inf, noise * noise),
        height_yaw=height_yaw_initialized(0.0, 0.0, 0.0, noise),
        delay_filter=delay_filter_created(history, now, covariance),
        paper_filter=PaperFilterState(
            x=nowhere, y=nowhere, ux=0.0, uy=0.0, at=0.0, innovation_variance=noise * noise
        ),
        sample=HeldSample(0.0, 0.0, 0.0, 0.0),
    )


@compiled
def estimator_initialized(
    state: EstimatorState,
    history: CommandHistory,
    params: EstimatorParameters,
    seen: Any,
    now: float,
) -> EstimatorState:
    """Return the state of a drone at rest at its first ``Measurement``; the command stays."""
    at, noise = seen.captured_at, params.position_noise
    covariance = initial_covariance(noise * noise, params.acceleration_noise)
    return EstimatorState(
        gate=PoseGate(True, False, at, state.gate.innovation_variance),
        height_yaw=height_yaw_initialized(seen.z, seen.yaw, at, noise),
        delay_filter=delay_filter_initialized(
            state.delay_filter, history, params.model, params.delay, at, seen.x, seen.y, covariance
        ),
        paper_filter=paper_filter_initialized(
            state.paper_filter, seen.x, seen.y, now, noise * noise
        ),
        sample=HeldSample(seen.x, seen.y, 0.0, 0.0),
    )


@compiled
def estimator_updated(
    state: EstimatorState,
    history: CommandHistory,
    params: EstimatorParameters,
    seen: Any,
    now: float,
) -> tuple[bool, EstimatorState]:
    """Return whether a ``Measurement`` received now [s] is accepted, and the state after it."""
    if stamp_fault(seen.captured_at, now, state.gate.last_capture) != 0:
        return False, state
    if not state.gate.initialized:
        return True, estimator_initialized(state, history, params, seen, now)
    if params.kind == EstimatorKind.DELAY_COMPENSATED:
        return _delay_compensated_update(state, history, params, seen)
    return _on_arrival_update(state, params, seen, now)


@compiled
def estimator_advanced(
    state: EstimatorState, history: CommandHistory, params: EstimatorParameters, now: float
) -> EstimatorState:
    """Return the state carried forward to now [s]."""
    delay_filter, paper_filter, initialized = (
        state.delay_filter,
        state.paper_filter,
        state.gate.initialized,
    )
    if params.kind == EstimatorKind.DELAY_COMPENSATED:
        model, delay = params.model, params.delay
        delay_filter = delay_filter_advanced(delay_filter, history, model, delay, now)
        if initialized:
            oldest = now - SIGHTING_AGE_MAX
            delay_filter = history_trimmed(delay_filter, history, model, delay, oldest)
    else:
        paper_filter = paper_filter_advanced(paper_filter, params.acceleration_noise, now)
        if params.kind == EstimatorKind.HELD_SAMPLE and initialized:
            variance = params.position_noise * params.position_noise
            x, y = state.sample.x, state.sample.y
            paper_filter = paper_filter_updated(paper_filter, x, y, variance)
    return EstimatorState(
        gate=state.gate,
        height_yaw=state.height_yaw,
        delay_filter=delay_filter,
        paper_filter=paper_filter,
        sample=state.sample,
    )


@compiled
def pose_estimate(
    state: EstimatorState, history: CommandHistory, params: EstimatorParameters, now: float
) -> PoseEstimate:
    """Return where the drone is now [s], by a state advanced to now."""
    z, vz, yaw = height_yaw_at(state.height_yaw, now)
    if params.kind == EstimatorKind.DELAY_COMPENSATED:
        x, y = axes_at(state.delay_filter, history, params.model, params.delay, now)
        return PoseEstimate(x.x, y.x, z, x.v, y.v, vz, yaw)
    if params.kind == EstimatorKind.FINITE_DIFFERENCE:
        held = state.sample
        return PoseEstimate(held.x, held.y, z, held.vx, held.vy, vz, yaw)
    paper = state.paper_filter
    return PoseEstimate(paper.x.x, paper.y.x, z, paper.x.v, paper.y.v, vz, yaw)


@compiled
def position_variance(
    state: EstimatorState, history: CommandHistory, params: EstimatorParameters, now: float
) -> float:
    """Return the variance of x and y [m^2] now [s], by a state advanced to now."""
    if params.kind == EstimatorKind.DELAY_COMPENSATED:
        return axes_and_covariance_at(
            state.delay_filter, history, params.model, params.delay, now
        ).covariance.xx
    return state.paper_filter.x.xx


@compiled
def estimate_at(
    state: EstimatorState, history: CommandHistory, params: EstimatorParameters, now: float
) -> tuple[EstimatorState, PoseEstimate, float]:
    """Return the state carried forward to now [s], where the drone is, and the variance [m^2].

    One call: handing the state over costs more than all of this.
    """
    state = estimator_advanced(state, history, params, now)
    here = pose_estimate(state, history, params, now)
    return state, here, position_variance(state, history, params, now)


@compiled
def control_state(
    state: EstimatorState,
    history: CommandHistory,
    params: EstimatorParameters,
    here: PoseEstimate,
    now: float,
) -> ControlState:
    """Return the state for control: of our filter one command delay ahead, of the others now."""
    if params.kind == EstimatorKind.DELAY_COMPENSATED:
        model, delay = params.model, params.delay
        x, y = axes_at(state.delay_filter, history, model, delay, now + delay)
        return ControlState((x.x, y.x), (x.v, y.v), (x.d, y.d), here.z, here.yaw)
    return ControlState((here.x, here.y), (here.vx, here.vy), (0.0, 0.0), here.z, here.yaw)


@compiled
def estimator_commanded(
    state: EstimatorState,
    history: CommandHistory,
    params: EstimatorParameters,
    ux: float,
    uy: float,
    flown: bool,
) -> EstimatorState:
    """Return the state under a commanded world acceleration [m/s^2], or the drone's own hover.

    The drone reaches c / lambda of it; both filters expect that.
    """
    if params.kind == EstimatorKind.DELAY_COMPENSATED:
        command_recorded(state.delay_filter, history, ux, uy, flown)
        return state
    return EstimatorState(
        gate=state.gate,
        height_yaw=state.height_yaw,
        delay_filter=state.delay_filter,
        paper_filter=paper_filter_commanded(
            state.paper_filter, params.model.gain * ux, params.model.gain * uy, flown
        ),
        sample=state.sample,
    )


@compiled
def _delay_compensated_update(
    state: EstimatorState, history: CommandHistory, params: EstimatorParameters, seen: Any
) -> tuple[bool, EstimatorState]:
    gate, at, noise = state.gate, seen.captured_at, params.position_noise
    model, delay, variance = params.model, params.delay, noise * noise
    plausible, rejected, accepted = height_yaw_updated(
        state.height_yaw, seen.z, seen.yaw, at, gate.rejecting, noise
    )
    there = axes_and_covariance_at(state.delay_filter, history, model, delay, at)
    innovation = gate.innovation_variance if gate.rejecting else there.covariance.xx + variance
    dx, dy = seen.x - there.x.x, seen.y - there.y.x
    if not (within_gate(dx * dx + dy * dy, innovation, POSITION_GATE_FLOOR) and plausible):
        return False, EstimatorState(
            gate=PoseGate(True, True, gate.last_capture, innovation),
            height_yaw=rejected,
            delay_filter=state.delay_filter,
            paper_filter=state.paper_filter,
            sample=state.sample,
        )
    return True, EstimatorState(
        gate=PoseGate(True, False, at, innovation),
        height_yaw=accepted,
        delay_filter=delay_filter_updated(
            state.delay_filter, history, model, delay, at, there, seen.x, seen.y, variance
        ),
        paper_filter=state.paper_filter,
        sample=HeldSample(seen.x, seen.y, 0.0, 0.0),
    )


@compiled
def _on_arrival_update(
    state: EstimatorState, params: EstimatorParameters, seen: Any, now: float
) -> tuple[bool, EstimatorState]:
    gate, at, noise = state.gate, seen.captured_at, params.position_noise
    variance, is_raw = noise * noise, params.kind == EstimatorKind.FINITE_DIFFERENCE
    plausible, rejected, accepted = height_yaw_updated(
        state.height_yaw, seen.z, seen.yaw, at, gate.rejecting, noise
    )
    paper = paper_filter_advanced(state.paper_filter, params.acceleration_noise, now)
    is_near, paper = paper_filter_gated(paper, seen.x, seen.y, gate.rejecting, variance)
    if not is_raw and not (is_near and plausible):
        return False, EstimatorState(
            gate=PoseGate(True, True, gate.last_capture, gate.innovation_variance),
            height_yaw=rejected,
            delay_filter=state.delay_filter,
            paper_filter=paper,
            sample=state.sample,
        )
    if params.kind == EstimatorKind.ON_ARRIVAL:
        paper = paper_filter_updated(paper, seen.x, seen.y, variance)
    seconds = at - gate.last_capture
    vx, vy = (seen.x - state.sample.x) / seconds, (seen.y - state.sample.y) / seconds
    return True, EstimatorState(
        gate=PoseGate(True, False, at, gate.innovation_variance),
        height_yaw=accepted,
        delay_filter=state.delay_filter,
        paper_filter=paper,
        sample=HeldSample(seen.x, seen.y, vx, vy),
    )
