"""One flight of one drone from the first tick to the last, and rows of them.

Each tick calls the compiled step of the live pilot; only mission and world are the experiment's.
"""

from __future__ import annotations

from math import floor, inf
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from housefly.lab.experiments.guidance import guided, parameters_of_case, task_created
from housefly.lab.experiments.measure import PERIOD, SCORE, Score, cleared, looked_at, summed_up
from housefly.lab.experiments.random import RandomState, sown, uniform
from housefly.lab.experiments.route import Route
from housefly.lab.experiments.sampled_drone import (
    ORDER,
    ORDER_RING_SIZE,
    Orders,
    carried_on,
    gusted,
    sampled_drone,
)
from housefly.lab.experiments.trace import (
    noted,
    traced_command,
    traced_sighting,
    traced_thoughts,
    traced_truth,
)
from housefly.lab.experiments.tracking_noise import (
    FRAME,
    FRAMES,
    Camera,
    Frames,
    Stream,
    delivered,
    is_due,
    stream_begun,
)
from housefly.numeric import compiled
from housefly.pilot.control.forms import FormedCommand
from housefly.pilot.control.model import DroneState
from housefly.pilot.estimation.delay_estimate import DELAY_CHANGE_MAX
from housefly.pilot.estimation.delay_filter import COMMAND_SPAN, TIME_TOLERANCE, CommandHistory
from housefly.pilot.estimation.estimator import (
    estimator_advanced,
    estimator_created,
    estimator_updated,
    pose_estimate,
)
from housefly.pilot.estimation.estimator_state import (
    EstimatorParameters,
    EstimatorState,
    PoseEstimate,
)
from housefly.pilot.estimation.validation import SIGHTING_AGE_MAX
from housefly.pilot.safety.limits import GatedCommand, SafetyModeCode, pose_age_mode
from housefly.pilot.step import (
    INITIAL_STEP,
    NO_OVERRIDE,
    StepOutput,
    StepState,
    step_commanded,
)

_TICK_MAX = 0.1
"""The references move on by no more than this in a tick [s], as in the live pilot."""


class FlightBuffers(NamedTuple):
    """Rings and records that a flight writes to; used again by the next."""

    history: CommandHistory
    orders: Orders
    frames: Frames
    random: RandomState
    score: Score


class Record(NamedTuple):
    """Where a flight is written down tick by tick; of length 0 when it is not."""

    ticks: NDArray[Any]
    seen: NDArray[Any]


def flight_buffers(cases: NDArray[Any]) -> FlightBuffers:
    """Return the rings for flights of these cases."""
    seconds = SIGHTING_AGE_MAX + 0.1 + float(cases["model_delay"].max(initial=0.0))
    if np.any(cases["delay_deviation"] > 0.0):
        seconds += DELAY_CHANGE_MAX
    spans = int(seconds * float(cases["rate_hz"].max(initial=1.0))) + 8
    return FlightBuffers(
        np.zeros(1 << (spans - 1).bit_length(), COMMAND_SPAN),
        np.zeros(ORDER_RING_SIZE, ORDER),
        np.zeros(FRAMES, FRAME),
        np.zeros(1, np.uint64),
        np.zeros(1, SCORE),
    )


@compiled
def fly_rows(
    cases: Any,
    start: int,
    stop: int,
    route: Route,
    flight_buffers: FlightBuffers,
    record: Record,
    outcomes: Any,
) -> None:
    """Fly the cases from ``start`` to ``stop`` one after the other and write their outcomes."""
    for row in range(start, stop):
        _fly_case(cases[row], route, flight_buffers, record, outcomes[row])


@compiled
def _fly_case(
    case: Any, route: Route, flight_buffers: FlightBuffers, record: Record, outcome: Any
) -> None:
    """Fly one case and write its outcome; every tick goes to the record when that has room."""
    params, air = parameters_of_case(case), sampled_drone(case)
    camera = _prepared(case, flight_buffers)
    score, stream, gust = flight_buffers.score[0], stream_begun(camera), (0.0, 0.0)
    body = DroneState(
        route.start_x, route.start_y, route.height, route.yaw, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    )
    estimator = estimator_created(flight_buffers.history, params.estimator, 0.0)
    state, task = INITIAL_STEP, task_created(route)
    before, ended_at = -inf, route.duration
    every = max(1, floor(case.rate_hz * PERIOD + 0.5))
    for tick in range(ticks_of(route, case) + 1):
        now = tick / case.rate_hz
        dt = min(now - before, _TICK_MAX)
        before = now
        estimator, stream = _estimated(
            estimator, stream, flight_buffers, params.estimator, record, tick, now
        )
        here = pose_estimate(estimator, flight_buffers.history, params.estimator, now)
        active = estimator.gate.initialized
        task, progress, guidance = guided(task, state, route, params, here, active, now)
        age = now - max(estimator.gate.last_capture, 0.0)
        acceptor = state.acceptor.state
        state, estimator, output = step_commanded(
            StepState(
                progress=progress,
                yaw=state.yaw,
                acceptor=state.acceptor,
                gate=state.gate,
                scale=state.scale,
            ),
            estimator,
            flight_buffers.history,
            params,
            here,
            guidance,
            route.path,
            NO_OVERRIDE,
            pose_age_mode(age, case.pose_age_level, case.pose_age_land),
            True,
            now,
            dt,
        )
        order = flight_buffers.orders[tick & (flight_buffers.orders.size - 1)]
        _send(order, output.command, output.formed)
        if tick < record.ticks.size:
            _write(record.ticks[tick], now, body, here, age, state, output, order)
        if now >= route.settle - TIME_TOLERANCE:
            _counted(score, state, acceptor, output, case.tilt_max)
            eps3 = params.tolerances.position
            is_there = tick % every > 0 or looked_at(
                score, route, body, here, output.target, eps3, now
            )
            if state.gate == SafetyModeCode.LAND or not is_there:
                ended_at = now
                break
        gust = gusted(gust, air, flight_buffers.random)
        body, stream = carried_on(
            body,
            stream,
            tick,
            now,
            air,
            gust,
            flight_buffers.orders,
            camera,
            flight_buffers.frames,
            flight_buffers.random,
        )
    summed_up(score, route, ended_at, outcome)


@compiled
def ticks_of(route: Route, case: Any) -> int:
    """Return how many ticks a whole flight has after its first."""
    return int(floor(route.duration * case.rate_hz + 0.5))  # noqa: RUF046  (the case is untyped)


@compiled
def _prepared(case: Any, flight_buffers: FlightBuffers) -> Camera:
    """Clear the desk and return the tracking system; its first frame comes at random."""
    sown(flight_buffers.random, case.seed)
    cleared(flight_buffers.score[0])
    for row in range(flight_buffers.history.size):
        flight_buffers.history[row].pieces = 0
    phase = uniform(flight_buffers.random)
    return Camera(
        case.mocap_rate_hz,
        phase,
        case.mocap_latency,
        case.mocap_jitter,
        case.mocap_noise,
        case.mocap_dropout,
    )


@compiled
def _estimated(
    estimator: EstimatorState,
    stream: Stream,
    flight_buffers: FlightBuffers,
    params: EstimatorParameters,
    record: Record,
    tick: int,
    now: float,
) -> tuple[EstimatorState, Stream]:
    """Return estimator and stream after everything that has arrived by now [s]."""
    while is_due(stream, flight_buffers.frames, now):
        frame = flight_buffers.frames[stream.delivered & (flight_buffers.frames.size - 1)]
        _, estimator = estimator_updated(estimator, flight_buffers.history, params, frame, now)
        if tick < record.ticks.size:
            traced_sighting(record.ticks[tick], frame)
            noted(record.seen, stream.delivered, tick, frame)
        stream = delivered(stream)
    return estimator_advanced(estimator, flight_buffers.history, params, now), stream


@compiled
def _send(order: Any, command: GatedCommand, formed: FormedCommand) -> None:
    order.flying = 1 if command.flown else 0
    order.theta, order.phi = command.theta, command.phi
    order.vz, order.yaw_rate = command.vz, command.yaw_rate
    order.forward, order.left = formed.forward, formed.left
    order.x, order.y, order.z = formed.x, formed.y, formed.z


@compiled
def _counted(
    score: Any, state: StepState, acceptor: int, output: StepOutput, tilt_max: float
) -> None:
    score.ticks += 1.0
    score.switches += 1.0 if state.acceptor.state != acceptor else 0.0
    score.saturated += 1.0 if output.asked.wish > tilt_max else 0.0
    score.levelled += 1.0 if state.gate == SafetyModeCode.HOLD else 0.0


@compiled
def _write(
    row: Any,
    now: float,
    body: DroneState,
    here: PoseEstimate,
    age: float,
    state: StepState,
    output: StepOutput,
    order: Any,
) -> None:
    traced_truth(row, now, body)
    traced_thoughts(row, here, age, output.target, state.yaw.reference, output.asked)
    traced_command(row, order, state.acceptor.state, state.gate)
