"""The estimator as one compiled composition: pose gate, height and yaw, and one horizontal filter.

The live pilot and the batch call the same functions. Which horizontal filter runs is a parameter;
two of the four exist only to be compared with.
"""

from __future__ import annotations

from math import inf, nan
from typing import Any

from housefly.geometry import Vec2
from housefly.numeric import compiled
from housefly.pilot.estimation.bandwidth import bandwidth
from housefly.pilot.estimation.climb_axis import ClimbAxis
from housefly.pilot.estimation.climb_filter import (
    climb_and_covariance_at,
    climb_at,
    climb_carried,
    climb_initialized,
    climb_tick_known,
    climb_updated,
)
from housefly.pilot.estimation.constant_velocity import ConstantVelocity
from housefly.pilot.estimation.delay_estimate import (
    DelayEstimate,
    delay_known,
    delay_learned,
    sensitivity_at,
)
from housefly.pilot.estimation.delay_filter import (
    AxesAt,
    CommandHistory,
    axes_and_covariance_at,
    axes_at,
    command_recorded,
    delay_filter_advanced,
    delay_filter_created,
    delay_filter_initialized,
    delay_filter_updated,
    history_trimmed,
)
from housefly.pilot.estimation.estimator_state import (
    ControlState,
    EstimatorKind,
    EstimatorParameters,
    EstimatorState,
    HeldSample,
    PoseEstimate,
    PoseGate,
)
from housefly.pilot.estimation.height_yaw import (
    POSITION_GATE_FLOOR,
    height_yaw_at,
    height_yaw_initialized,
    height_yaw_updated,
    within_gate,
)
from housefly.pilot.estimation.lagged_axis import (
    AxisModel,
    initial_covariance,
)
from housefly.pilot.estimation.paper_filter import (
    PaperFilterState,
    paper_filter_advanced,
    paper_filter_commanded,
    paper_filter_gated,
    paper_filter_initialized,
    paper_filter_updated,
)
from housefly.pilot.estimation.stream_health import StreamHealth, health_updated
from housefly.pilot.estimation.validation import SIGHTING_AGE_MAX, stamp_fault

HOVER_BRAKING = 1.5
"""How quickly the drone's own hover stops it, on top of drag [1/s]."""
DISTURBANCE_WANDER = 0.2
"""How fast the disturbance may change [m/s^2 per sqrt(s)]."""


@compiled
def axis_model(
    lag: float,
    gain: float,
    drag: float,
    acceleration_noise: float,
    wander: float = DISTURBANCE_WANDER,
    pull: float = 0.0,
) -> AxisModel:
    """Return the prediction of a drone.

    Args:
        lag: lambda [1/s].
        gain: c / lambda.
        drag: of the air, over mass [1/s].
        acceleration_noise: [m/s^2].
        wander: how fast the disturbance may change [m/s^2 per sqrt(s)].
        pull: what takes the place of drag in a drone that is not steered by tilt [1/s]; 0 in one
            that is.
    """
    return AxisModel(
        lag=lag,
        gain=gain,
        drag=pull if pull > 0.0 else drag,
        hover_drag=drag + HOVER_BRAKING,
        noise=acceleration_noise,
        wander=wander,
    )


@compiled
def estimator_created(
    history: CommandHistory, params: EstimatorParameters, now: float
) -> EstimatorState:
    """Return the state at a time [s] before any sighting."""
    noise = params.position_noise
    covariance = initial_covariance(noise * noise, params.acceleration_noise, params.model.wander)
    nowhere = ConstantVelocity(0.0, 0.0, 0.0, 0.0, 0.0)
    return EstimatorState(
        gate=PoseGate(False, False, -inf, noise * noise),
        height_yaw=height_yaw_initialized(0.0, 0.0, 0.0, noise),
        delay_filter=delay_filter_created(history, now, covariance),
        paper_filter=PaperFilterState(
            x=nowhere, y=nowhere, ux=0.0, uy=0.0, at=0.0, innovation_variance=noise * noise
        ),
        sample=HeldSample(0.0, 0.0, 0.0, 0.0),
        climb=climb_initialized(0.0, now, noise * noise),
        delay=delay_known(params.delay, params.delay_deviation),
        health=StreamHealth(nan, nan, nan, nan),
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
    covariance = initial_covariance(noise * noise, params.acceleration_noise, params.model.wander)
    delay = delay_known(state.delay.delay, params.delay_deviation)
    return EstimatorState(
        gate=PoseGate(True, False, at, state.gate.innovation_variance),
        height_yaw=height_yaw_initialized(seen.z, seen.yaw, at, noise),
        delay_filter=delay_filter_initialized(
            state.delay_filter, history, params.model, delay.delay, at, seen.x, seen.y, covariance
        ),
        paper_filter=paper_filter_initialized(
            state.paper_filter, seen.x, seen.y, now, noise * noise
        ),
        sample=HeldSample(seen.x, seen.y, 0.0, 0.0),
        climb=climb_initialized(seen.z, at, noise * noise, state.climb.axis.d),
        delay=delay,
        health=state.health,
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
        return _delay_compensated_update(state, history, params, seen, now)
    return _on_arrival_update(state, params, seen, now)


@compiled
def estimator_advanced(
    state: EstimatorState, history: CommandHistory, params: EstimatorParameters, now: float
) -> EstimatorState:
    """Return the state carried forward to now [s]."""
    delay_filter, paper_filter, climb = state.delay_filter, state.paper_filter, state.climb
    initialized = state.gate.initialized
    if params.kind == EstimatorKind.DELAY_COMPENSATED:
        model, delay = params.model, state.delay.delay
        delay_filter = delay_filter_advanced(delay_filter, history, model, delay, now)
        if initialized:
            oldest = now - SIGHTING_AGE_MAX
            delay_filter = history_trimmed(delay_filter, history, model, delay, oldest)
            if params.climb.wander > 0.0:
                climb = climb_tick_known(climb, delay_filter, history, params.climb)
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
        climb=climb,
        delay=state.delay,
        health=state.health,
    )


@compiled
def pose_estimate(
    state: EstimatorState, history: CommandHistory, params: EstimatorParameters, now: float
) -> PoseEstimate:
    """Return where the drone is now [s], by a state advanced to now."""
    z, vz, yaw = height_yaw_at(state.height_yaw, now)
    if params.kind == EstimatorKind.DELAY_COMPENSATED:
        delay = state.delay.delay
        x, y = axes_at(state.delay_filter, history, params.model, delay, now)
        if params.climb.wander > 0.0:
            climb = climb_at(state.climb, state.delay_filter, history, params.climb, delay, now)
            z, vz = climb.z, climb.w
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
            state.delay_filter, history, params.model, state.delay.delay, now
        ).covariance.xx
    return state.paper_filter.x.xx


def disturbance_of(newest: int, history: CommandHistory) -> Vec2:
    """Return the steady push in the plane [m/s^2], by the number of the newest command span."""
    row = history[newest & (history.size - 1)]
    return float(row["x_d"]), float(row["y_d"])


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
        model, delay = params.model, state.delay.delay
        x, y = axes_at(state.delay_filter, history, model, delay, now + delay)
        z, climb, lift = here.z, 0.0, 0.0
        if params.climb.wander > 0.0:
            ahead = climb_carried(
                state.climb,
                state.delay_filter,
                history,
                params.climb,
                delay,
                ClimbAxis(here.z, here.vz, state.climb.axis.d),
                now,
                now + delay,
            )
            z, climb, lift = ahead.z, ahead.w, ahead.d
        limit = inf
        if params.mistrust > 0.0:
            health = state.health
            limit = bandwidth(delay, health.latency, health.interval, model.lag, params.mistrust)
        return ControlState(
            position=(x.x, y.x),
            velocity=(x.v, y.v),
            disturbance=(x.d, y.d),
            height=z,
            yaw=here.yaw,
            climb=climb,
            lift=lift,
            delay_change=delay - params.delay,
            bandwidth=limit,
        )
    return ControlState(
        position=(here.x, here.y),
        velocity=(here.vx, here.vy),
        disturbance=(0.0, 0.0),
        height=here.z,
        yaw=here.yaw,
        climb=0.0,
        lift=0.0,
        delay_change=0.0,
        bandwidth=inf,
    )


@compiled
def estimator_commanded(
    state: EstimatorState,
    history: CommandHistory,
    params: EstimatorParameters,
    ux: float,
    uy: float,
    flown: bool,
    uz: float = 0.0,
) -> EstimatorState:
    """Return the state under a commanded world acceleration [m/s^2] and climb rate [m/s], or the
    drone's own hover.

    The drone reaches c / lambda of the acceleration; both filters expect that.
    """
    if params.kind == EstimatorKind.DELAY_COMPENSATED:
        command_recorded(state.delay_filter, history, ux, uy, flown, uz)
        return state
    return EstimatorState(
        gate=state.gate,
        height_yaw=state.height_yaw,
        delay_filter=state.delay_filter,
        paper_filter=paper_filter_commanded(
            state.paper_filter, params.model.gain * ux, params.model.gain * uy, flown
        ),
        sample=state.sample,
        climb=state.climb,
        delay=state.delay,
        health=state.health,
    )


@compiled
def _delay_compensated_update(
    state: EstimatorState,
    history: CommandHistory,
    params: EstimatorParameters,
    seen: Any,
    now: float,
) -> tuple[bool, EstimatorState]:
    gate, at, noise = state.gate, seen.captured_at, params.position_noise
    model, variance = params.model, params.position_noise * params.position_noise
    plausible, rejected, accepted = height_yaw_updated(
        state.height_yaw, seen.z, seen.yaw, at, gate.rejecting, noise
    )
    there = axes_and_covariance_at(state.delay_filter, history, model, state.delay.delay, at)
    innovation = gate.innovation_variance if gate.rejecting else there.covariance.xx + variance
    dx, dy = seen.x - there.x.x, seen.y - there.y.x
    if not (within_gate(dx * dx + dy * dy, innovation, POSITION_GATE_FLOOR) and plausible):
        return False, EstimatorState(
            gate=PoseGate(True, True, gate.last_capture, innovation),
            height_yaw=rejected,
            delay_filter=state.delay_filter,
            paper_filter=state.paper_filter,
            sample=state.sample,
            climb=state.climb,
            delay=state.delay,
            health=state.health,
        )
    rise = seen.z - state.height_yaw.z.x - (at - state.height_yaw.at) * state.height_yaw.z.v
    height_nis = rise * rise / accepted.z_innovation
    climb = state.climb
    if params.climb.wander > 0.0:
        axis, p = climb_and_covariance_at(
            climb, state.delay_filter, history, params.climb, state.delay.delay, at
        )
        climb = climb_updated(climb, axis, p, seen.z, at, variance)
        height_nis = (seen.z - axis.z) * (seen.z - axis.z) / (p.zz + variance)
    nis = 0.5 * (dx * dx + dy * dy) / (there.covariance.xx + variance)
    delay = _delay_updated(state, history, params, there, dx, dy, at)
    return True, EstimatorState(
        gate=PoseGate(True, False, at, innovation),
        height_yaw=accepted,
        delay_filter=delay_filter_updated(
            state.delay_filter, history, model, delay.delay, at, there, seen.x, seen.y, variance
        ),
        paper_filter=state.paper_filter,
        sample=HeldSample(seen.x, seen.y, 0.0, 0.0),
        climb=climb,
        delay=delay,
        health=health_updated(state.health, at - gate.last_capture, now - at, nis, height_nis),
    )


@compiled
def _delay_updated(
    state: EstimatorState,
    history: CommandHistory,
    params: EstimatorParameters,
    there: AxesAt,
    dx: float,
    dy: float,
    at: float,
) -> DelayEstimate:
    """Return what is known of the command delay after a sighting off by (dx, dy) [m]."""
    if params.delay_deviation <= 0.0:
        return state.delay
    x, y = sensitivity_at(state.delay, state.delay_filter, history, params.model, there)
    return delay_learned(
        state.delay,
        x,
        y,
        there.covariance,
        dx,
        dy,
        params.position_noise * params.position_noise,
        state.health.nis,
        at - state.gate.last_capture,
        params.delay,
        params.delay_deviation,
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
            climb=state.climb,
            delay=state.delay,
            health=state.health,
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
        climb=state.climb,
        delay=state.delay,
        health=health_updated(state.health, seconds, now - at, nan, nan),
    )
