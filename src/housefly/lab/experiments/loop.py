"""One flight of one drone from the first tick to the last, and rows of them: the compiled heart of
the experiments.
"""

from __future__ import annotations

from math import floor, inf
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from housefly.lab.experiments.airframe import ORDER, ORDERS, Orders, airframe_of, carried_on, gusted
from housefly.lab.experiments.belief import (
    Belief,
    Estimated,
    Knowledge,
    blank,
    estimated,
    forecast,
    informed,
    knowledge_of,
    told,
    up_to_date,
)
from housefly.lab.experiments.chain import (
    LAND,
    LEVEL,
    Course,
    accepted,
    asked_of,
    course_begun,
    gains_of_case,
    judged,
    pushed_by,
    remembering,
    standing,
    tracked,
)
from housefly.lab.experiments.measure import PERIOD, SCORE, Score, cleared, looked_at, summed_up
from housefly.lab.experiments.random import State, sown, uniform
from housefly.lab.experiments.route import Route
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
from housefly.pilot.behavior.ride import Target
from housefly.pilot.control.model import Body
from housefly.pilot.control.steering import Asked, Gains
from housefly.pilot.estimation.horizon import NO_TIME, SPAN, Spans
from housefly.pilot.estimation.intake import OLDEST

LONGEST_TICK = 0.1
"""The references move on by no more than this in a tick [s], as in the live pilot."""


class Desk(NamedTuple):
    """Rings and records that a flight writes to; used again by the next."""

    spans: Spans
    orders: Orders
    frames: Frames
    random: State
    score: Score


class Record(NamedTuple):
    """Where a flight is written down tick by tick; of length 0 when it is not."""

    ticks: NDArray[Any]
    seen: NDArray[Any]


def desk(cases: NDArray[Any]) -> Desk:
    """Return the rings for flights of these cases."""
    spans = (
        int(
            (OLDEST + 0.1 + float(cases["model_delay"].max(initial=0.0)))
            * float(cases["rate_hz"].max(initial=1.0))
        )
        + 8
    )
    return Desk(
        np.zeros(1 << (spans - 1).bit_length(), SPAN),
        np.zeros(ORDERS, ORDER),
        np.zeros(FRAMES, FRAME),
        np.zeros(1, np.uint64),
        np.zeros(1, SCORE),
    )


@compiled
def fly_rows(
    cases: Any, start: int, stop: int, route: Route, desk: Desk, record: Record, outcomes: Any
) -> None:
    """Fly the cases from ``start`` to ``stop`` one after the other and write their outcomes."""
    for row in range(start, stop):
        fly(cases[row], route, desk, record, outcomes[row])


@compiled
def fly(case: Any, route: Route, desk: Desk, record: Record, outcome: Any) -> None:
    """Fly one case and write its outcome; every tick goes to the record when that has room."""
    know, gains, air = knowledge_of(case), gains_of_case(case), airframe_of(case)
    camera = _prepared(case, desk)
    score, stream, gust = desk.score[0], stream_begun(camera), (0.0, 0.0)
    body = Body(
        route.cells[0, 0], route.cells[0, 1], route.height, route.yaw, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    )
    belief, course = blank(know, desk.spans), course_begun()
    before, ended_at = -inf, route.duration
    every = max(1, floor(case.rate_hz * PERIOD + 0.5))
    for tick in range(ticks_of(route, case) + 1):
        now = tick / case.rate_hz
        dt = min(now - before, LONGEST_TICK)
        before = now
        belief, stream = _heard(belief, stream, desk, know, record, tick, now)
        here = estimated(belief, desk.spans, know, now)
        state = course.state
        course, target, asked = _thought(
            belief, course, route, case, gains, desk.spans, know, here, now, dt
        )
        age = now - max(belief.last_capture, 0.0)
        order = desk.orders[tick & (desk.orders.size - 1)]
        flying = belief.begun and (case.mode == 0 or course.state > 0)
        course = remembering(course, judged(asked, flying, age, case, order))
        ux, uy = pushed_by(order, here.yaw)
        belief = told(belief, desk.spans, know, ux, uy, order.flying > 0)
        if tick < record.ticks.size:
            _write(
                record.ticks[tick], now, body, here, age, course, target, asked, order, route.height
            )
        if now >= route.settle - NO_TIME:
            _counted(score, course, state, asked, case.tilt_max)
            is_there = tick % every > 0 or looked_at(
                score, route, body, here, target, case.epsilon_position, now
            )
            if course.safety == LAND or not is_there:
                ended_at = now
                break
        gust = gusted(gust, air, desk.random)
        body, stream = carried_on(
            body, stream, tick, now, air, gust, desk.orders, camera, desk.frames, desk.random
        )
    summed_up(score, route, ended_at, outcome)


@compiled
def ticks_of(route: Route, case: Any) -> int:
    """Return how many ticks a whole flight has after its first."""
    return int(floor(route.duration * case.rate_hz + 0.5))  # noqa: RUF046  (the case is untyped)


@compiled
def _prepared(case: Any, desk: Desk) -> Camera:
    """Clear the desk and return the tracking system; its frames begin anywhere in their interval."""
    sown(desk.random, case.seed)
    cleared(desk.score[0])
    for row in range(desk.spans.size):
        desk.spans[row].pieces = 0
    phase = uniform(desk.random)
    return Camera(
        case.mocap_rate_hz,
        phase,
        case.mocap_latency,
        case.mocap_jitter,
        case.mocap_noise,
        case.mocap_dropout,
    )


@compiled
def _heard(
    belief: Belief,
    stream: Stream,
    desk: Desk,
    know: Knowledge,
    record: Record,
    tick: int,
    now: float,
) -> tuple[Belief, Stream]:
    """Return belief and stream after everything that has arrived by now [s]."""
    while is_due(stream, desk.frames, now):
        frame = desk.frames[stream.delivered & (desk.frames.size - 1)]
        belief = informed(belief, desk.spans, know, frame, now)
        if tick < record.ticks.size:
            traced_sighting(record.ticks[tick], frame)
            noted(record.seen, stream.delivered, tick, frame)
        stream = delivered(stream)
    return up_to_date(belief, desk.spans, know, now), stream


@compiled
def _thought(
    belief: Belief,
    course: Course,
    route: Route,
    case: Any,
    gains: Gains,
    spans: Spans,
    know: Knowledge,
    here: Estimated,
    now: float,
    dt: float,
) -> tuple[Course, Target, Asked]:
    """Return the course, the reference and what control asks; nothing is asked before anything was
    seen.
    """
    if not belief.begun:
        return course, standing(route, 0), Asked(0.0, 0.0, 0.0, 0.0, 0.0)
    course, target = tracked(course, route, case, here, now, dt)
    course = accepted(course, route, case, here, target, now, dt)
    where = forecast(belief, spans, know, here, now)
    return course, target, asked_of(course, target, where, route.height, gains, case.mode)


@compiled
def _counted(score: Any, course: Course, state: int, asked: Asked, tilt_max: float) -> None:
    score.ticks += 1.0
    score.switches += 1.0 if course.state != state else 0.0
    score.saturated += 1.0 if asked.wish > tilt_max else 0.0
    score.levelled += 1.0 if course.safety == LEVEL else 0.0


@compiled
def _write(
    row: Any,
    now: float,
    body: Body,
    here: Estimated,
    age: float,
    course: Course,
    target: Target,
    asked: Asked,
    order: Any,
    height: float,
) -> None:
    traced_truth(row, now, body)
    traced_thoughts(row, here, age, target, height, course.nose.reference, asked)
    traced_command(row, order, course.state, course.safety)
