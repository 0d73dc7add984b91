"""The compiled estimator on a state that stays where it is: what the live pilot calls."""

from __future__ import annotations

from housefly.numeric import CompiledBox, compiled_with_arrays
from housefly.pilot.estimation.delay_filter import CommandHistory
from housefly.pilot.estimation.estimator import (
    estimate_at,
    estimator_initialized,
    estimator_updated,
)
from housefly.pilot.estimation.estimator_state import (
    EstimatorParameters,
    EstimatorState,
    Measurement,
    PoseEstimate,
    PoseGate,
)


@compiled_with_arrays
def sighting_taken(
    box: CompiledBox[EstimatorState],
    history: CommandHistory,
    params: CompiledBox[EstimatorParameters],
    seen: Measurement,
    now: float,
    vouched: bool,
) -> bool:
    """Advance the state by a sighting, and return whether it was accepted.

    Args:
        box: of the state.
        history: the commands given.
        params: of the estimator.
        seen: the sighting.
        now: [s].
        vouched: where the filter refuses it, it is begun anew there.
    """
    before = box[0]
    accepted, after = estimator_updated(before, history, params[0], seen, now)
    if vouched and not accepted:
        accepted, after = True, estimator_initialized(before, history, params[0], seen, now)
    box[0] = after
    return accepted


@compiled_with_arrays
def begun_at(
    box: CompiledBox[EstimatorState],
    history: CommandHistory,
    params: CompiledBox[EstimatorParameters],
    seen: Measurement,
    now: float,
) -> None:
    """Begin anew at a sighting."""
    box[0] = estimator_initialized(box[0], history, params[0], seen, now)


@compiled_with_arrays
def estimated(
    box: CompiledBox[EstimatorState],
    history: CommandHistory,
    params: CompiledBox[EstimatorParameters],
    now: float,
) -> tuple[PoseEstimate, float, bool, float]:
    """Carry the state forward to now [s], and return where the drone is.

    Besides that the variance [m^2], whether a sighting was ever accepted, and when the last one
    that was had been captured [s].
    """
    after, here, variance = estimate_at(box[0], history, params[0], now)
    box[0] = after
    return here, variance, after.gate.initialized, after.gate.last_capture


@compiled_with_arrays
def pose_gate(box: CompiledBox[EstimatorState]) -> PoseGate:
    """Return what decides about the next sighting."""
    return box[0].gate


@compiled_with_arrays
def newest_span(box: CompiledBox[EstimatorState]) -> int:
    """Return the number of the newest command span."""
    return box[0].delay_filter.newest


@compiled_with_arrays
def tracked_climb_rate(box: CompiledBox[EstimatorState]) -> float:
    """Return the climb rate by tracking [m/s]."""
    return box[0].height_yaw.z.v
