"""What a pilot of the batch knows of its drone: the compiled estimators of the live pilot, and two
that are worse, to compare.
"""

from __future__ import annotations

from math import inf
from typing import Any, NamedTuple

from housefly.numeric import compiled
from housefly.pilot.control.steering import Where
from housefly.pilot.estimation.drift_axis import Drift
from housefly.pilot.estimation.filter import HOVER_BRAKE, WANDER
from housefly.pilot.estimation.height_yaw import (
    GATE_FLOOR,
    Upright,
    plausible,
    stood,
    upright_at,
    upright_seen,
)
from housefly.pilot.estimation.horizon import (
    Horizon,
    Spans,
    advanced,
    begun,
    commanded,
    looked,
    measured,
    opened,
    reached,
    settled,
)
from housefly.pilot.estimation.intake import OLDEST, stamp_fault
from housefly.pilot.estimation.lagged_axis import AxisModel, Spread, first_spread
from housefly.pilot.estimation.plain import (
    Plain,
    plain_advanced,
    plain_begun,
    plain_commanded,
    plain_judged,
    plain_measured,
)

DELAY_COMPENSATED, ON_ARRIVAL, HELD_SAMPLE, FINITE_DIFFERENCE = 0, 1, 2, 3


class Knowledge(NamedTuple):
    """What the estimators of one case are told beforehand.

    Attributes:
        kind: value of the column ``estimator``.
        model: of mode default's filter.
        delay: command delay believed [s].
        noise: unmodelled acceleration of the paper's filter [m/s^1.5].
        position_noise: one sigma of a sighting [m].
        first: covariance at the first sighting.
    """

    kind: int
    model: AxisModel
    delay: float
    noise: float
    position_noise: float
    first: Spread


class Belief(NamedTuple):
    """Memory of the estimators; of the horizontal ones only the case's own is kept up.

    Attributes:
        begun: something was seen.
        refusing: the last sighting was not believed.
        last_capture: of the last one believed [s].
        doubt: variance by which mode default's filter judges [m^2].
        upright: height and heading.
        horizon: mode default's filter.
        plain: the paper's.
        x, y, vx, vy: held sample and its finite difference [m, m/s].
    """

    begun: bool
    refusing: bool
    last_capture: float
    doubt: float
    upright: Upright
    horizon: Horizon
    plain: Plain
    x: float
    y: float
    vx: float
    vy: float


class Estimated(NamedTuple):
    """Where the drone is now: position [m], velocity [m/s], heading [rad]."""

    x: float
    y: float
    z: float
    vx: float
    vy: float
    vz: float
    yaw: float


@compiled
def knowledge_of(case: Any) -> Knowledge:
    """Return what one case tells its estimators."""
    noise = case.position_noise
    model = AxisModel(
        case.model_lag,
        case.model_gain,
        case.model_drag,
        case.model_drag + HOVER_BRAKE,
        case.acceleration_noise,
        WANDER,
    )
    first = first_spread(noise * noise, case.acceleration_noise)
    return Knowledge(case.estimator, model, case.model_delay, case.acceleration_noise, noise, first)


@compiled
def blank(know: Knowledge, spans: Spans) -> Belief:
    """Return the belief before anything was seen."""
    variance = know.position_noise * know.position_noise
    nothing = Drift(0.0, 0.0, 0.0, 0.0, 0.0)
    plain = Plain(nothing, nothing, 0.0, 0.0, 0.0, variance)
    upright = stood(0.0, 0.0, 0.0, know.position_noise)
    return Belief(
        False,
        False,
        -inf,
        variance,
        upright,
        opened(spans, 0.0, know.first),
        plain,
        0.0,
        0.0,
        0.0,
        0.0,
    )


@compiled
def informed(b: Belief, spans: Spans, know: Knowledge, frame: Any, now: float) -> Belief:
    """Return the belief after a sighting was delivered now [s].

    The live pilot also refuses poses that repeat to the last bit and numbers that are not finite:
        simulated ones do neither.
    """
    at = frame.captured_at
    if stamp_fault(at, now, b.last_capture) != 0:
        return b
    if not b.begun:
        return _first(b, spans, know, frame, now)
    upright_ok, without, taken = upright_seen(
        b.upright, frame.z, frame.yaw, at, b.refusing, know.position_noise
    )
    if know.kind == DELAY_COMPENSATED:
        return _compensated(b, spans, know, frame, upright_ok, without, taken)
    return _on_arrival(b, know, frame, now, upright_ok, without, taken)


@compiled
def up_to_date(b: Belief, spans: Spans, know: Knowledge, now: float) -> Belief:
    """Return the belief brought forward to now [s]."""
    horizon, plain = b.horizon, b.plain
    if know.kind == DELAY_COMPENSATED:
        horizon = advanced(horizon, spans, know.model, know.delay, now)
        if b.begun:
            horizon = settled(horizon, spans, know.model, know.delay, now - OLDEST)
    else:
        plain = plain_advanced(plain, know.noise, now)
        if know.kind == HELD_SAMPLE and b.begun:
            plain = plain_measured(plain, b.x, b.y, know.position_noise * know.position_noise)
    return Belief(
        b.begun,
        b.refusing,
        b.last_capture,
        b.doubt,
        b.upright,
        horizon,
        plain,
        b.x,
        b.y,
        b.vx,
        b.vy,
    )


@compiled
def estimated(b: Belief, spans: Spans, know: Knowledge, now: float) -> Estimated:
    """Return where the drone is now [s], by a belief that is up to date."""
    z, climb, yaw = upright_at(b.upright, now)
    if know.kind == DELAY_COMPENSATED:
        x, y = looked(b.horizon, spans, know.model, know.delay, now)
        return Estimated(x.x, y.x, z, x.v, y.v, climb, yaw)
    if know.kind == FINITE_DIFFERENCE:
        return Estimated(b.x, b.y, z, b.vx, b.vy, climb, yaw)
    return Estimated(b.plain.x.x, b.plain.y.x, z, b.plain.x.v, b.plain.y.v, climb, yaw)


@compiled
def forecast(b: Belief, spans: Spans, know: Knowledge, here: Estimated, now: float) -> Where:
    """Return the state for control: of our filter when a command given now acts, of the others the
    estimate itself.
    """
    if know.kind == DELAY_COMPENSATED:
        x, y = looked(b.horizon, spans, know.model, know.delay, now + know.delay)
        return Where((x.x, y.x), (x.v, y.v), (x.d, y.d), here.z, here.yaw)
    return Where((here.x, here.y), (here.vx, here.vy), (0.0, 0.0), here.z, here.yaw)


@compiled
def told(b: Belief, spans: Spans, know: Knowledge, ux: float, uy: float, flown: bool) -> Belief:
    """Return the belief under a new command: world acceleration [m/s^2], or the drone's own hover
    when not flown.
    """
    if know.kind == DELAY_COMPENSATED:
        commanded(b.horizon, spans, ux, uy, flown)
        return b
    plain = plain_commanded(b.plain, ux, uy, flown)
    return Belief(
        b.begun,
        b.refusing,
        b.last_capture,
        b.doubt,
        b.upright,
        b.horizon,
        plain,
        b.x,
        b.y,
        b.vx,
        b.vy,
    )


@compiled
def _first(b: Belief, spans: Spans, know: Knowledge, frame: Any, now: float) -> Belief:
    at, variance = frame.captured_at, know.position_noise * know.position_noise
    upright = stood(frame.z, frame.yaw, at, know.position_noise)
    horizon = begun(b.horizon, spans, know.model, know.delay, at, frame.x, frame.y, know.first)
    plain = plain_begun(b.plain, frame.x, frame.y, now, variance)
    return Belief(True, False, at, b.doubt, upright, horizon, plain, frame.x, frame.y, 0.0, 0.0)


@compiled
def _compensated(
    b: Belief,
    spans: Spans,
    know: Knowledge,
    frame: Any,
    upright_ok: bool,
    without: Upright,
    taken: Upright,
) -> Belief:
    at, variance = frame.captured_at, know.position_noise * know.position_noise
    there = reached(b.horizon, spans, know.model, know.delay, at)
    doubt = b.doubt if b.refusing else there.spread.xx + variance
    dx, dy = frame.x - there.x.x, frame.y - there.y.x
    if not (plausible(dx * dx + dy * dy, doubt, GATE_FLOOR) and upright_ok):
        return Belief(
            True, True, b.last_capture, doubt, without, b.horizon, b.plain, b.x, b.y, b.vx, b.vy
        )
    horizon = measured(
        b.horizon, spans, know.model, know.delay, at, there, frame.x, frame.y, variance
    )
    return Belief(True, False, at, doubt, taken, horizon, b.plain, b.x, b.y, b.vx, b.vy)


@compiled
def _on_arrival(
    b: Belief,
    know: Knowledge,
    frame: Any,
    now: float,
    upright_ok: bool,
    without: Upright,
    taken: Upright,
) -> Belief:
    at, variance = frame.captured_at, know.position_noise * know.position_noise
    ok, plain = plain_judged(
        plain_advanced(b.plain, know.noise, now), frame.x, frame.y, b.refusing, variance
    )
    if know.kind != FINITE_DIFFERENCE and not (ok and upright_ok):
        return Belief(
            True, True, b.last_capture, b.doubt, without, b.horizon, plain, b.x, b.y, b.vx, b.vy
        )
    if know.kind == ON_ARRIVAL:
        plain = plain_measured(plain, frame.x, frame.y, variance)
    span = at - b.last_capture
    vx, vy = (frame.x - b.x) / span, (frame.y - b.y) / span
    return Belief(True, False, at, b.doubt, taken, b.horizon, plain, frame.x, frame.y, vx, vy)
