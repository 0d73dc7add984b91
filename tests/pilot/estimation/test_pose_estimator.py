from __future__ import annotations

from collections.abc import Callable
from math import cos, inf, isfinite, nan, pi, sin

import numpy as np
import pytest
from estimator_bench import EstimatorBench
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.config.site import Site
from housefly.geometry import quaternion_from_euler, wrap_angle
from housefly.messages import Pose, Sighting
from housefly.pilot.estimation.estimator_state import EstimatorKind
from housefly.pilot.estimation.validation import RejectionReason

SITE = Site()
Make = Callable[[], EstimatorBench]


def delay_compensated() -> EstimatorBench:
    return EstimatorBench(EstimatorKind.DELAY_COMPENSATED)


def on_arrival() -> EstimatorBench:
    return EstimatorBench(EstimatorKind.ON_ARRIVAL)


both = pytest.mark.parametrize("make", [delay_compensated, on_arrival])


def seen(
    x: float,
    y: float,
    at: float,
    latency: float = 0.0,
    z: float = 1.0,
    yaw: float = 0.0,
    body: str = "ardrone",
) -> Sighting:
    hair = (
        1e-9 * sin(1e4 * at) if isfinite(at) else 0.0
    )  # a place that stays the same to the last bit counts as frozen
    return Sighting(
        body, Pose((x + hair, y, z), quaternion_from_euler(0.0, 0.0, yaw)), at, at + latency
    )


@both
def test_there_is_no_estimate_before_the_first_sighting(make: Make) -> None:
    estimator = make()
    assert estimator.estimate(1.0) is None
    assert estimator.ahead(1.0) is None


@both
def test_other_bodies_do_not_count(make: Make) -> None:
    estimator = make()
    estimator.update(seen(1.0, 1.0, 0.0, body="visitor"), now=0.0)
    assert estimator.estimate(0.1) is None


def drive(estimator: EstimatorBench, rate_hz: float, latency: float, seed: int = 3) -> list[float]:
    """Feed a drone under known commands, 10 ms steps; return the position errors of the last two
    seconds [m].
    """
    random = np.random.default_rng(seed)
    x = v = a = 0.0
    truth: list[float] = []
    sent: list[float] = []
    errors: list[float] = []
    last_frame = -1
    for n in range(800):
        now = 0.01 * n
        truth.append(x)
        frame = int(now * rate_hz + 1e-9)
        captured = n - round(latency / 0.01)
        if frame != last_frame and captured >= 0:
            last_frame = frame
            estimator.update(
                seen(truth[captured] + random.normal(0.0, 0.001), 0.0, 0.01 * captured, latency),
                now=now,
            )
        estimate = estimator.estimate(now)
        if n > 600 and estimate is not None:
            errors.append(estimate.position[0] - x)
        u = 1.0 * sin(2.0 * now)
        sent.append(u)
        estimator.command(now, u)
        felt = sent[n - 6] if n >= 6 else 0.0
        for _ in range(10):
            a += 0.001 * 7.0 * (felt - a)
            v += 0.001 * (a - 0.58 * v)
            x += 0.001 * v
    return errors


def rms(errors: list[float]) -> float:
    return float(np.sqrt(np.mean(np.square(errors))))


@pytest.mark.parametrize(
    ("rate_hz", "latency", "bound"),
    [(100.0, 0.02, 0.003), (30.0, 0.05, 0.005), (10.0, 0.05, 0.008)],
)
def test_position_is_right_now_although_sightings_are_late_and_rare(
    rate_hz: float, latency: float, bound: float
) -> None:
    assert rms(drive(delay_compensated(), rate_hz, latency)) < bound


def test_the_papers_filter_lags_by_the_latency_that_it_does_not_know() -> None:
    assert rms(drive(on_arrival(), 30.0, 0.05)) > 3.0 * rms(drive(delay_compensated(), 30.0, 0.05))


@both
def test_doubt_grows_with_the_age_of_the_pose_and_the_age_is_told(
    make: Make,
) -> None:
    estimator = make()
    for n in range(50):
        estimator.update(seen(1.0, 2.0, 0.01 * n), now=0.01 * n)
        estimator.command(0.01 * n, 0.0)
    doubts = [estimator.estimate(0.5 + 0.1 * n) for n in range(10)]
    stds = [doubt.position_std for doubt in doubts if doubt]
    assert stds == sorted(stds) and stds[-1] > 5.0 * stds[0]
    assert doubts[-1] is not None and doubts[-1].pose_age == pytest.approx(1.4 - 0.49)


@both
def test_a_spike_of_one_metre_is_refused_and_not_felt(make: Make) -> None:
    estimator = make()
    for n in range(100):
        spike = 1.0 if n in (60, 61, 62) else 0.0
        assert estimator.update(seen(1.0 + spike, 2.0, 0.01 * n), now=0.01 * n) == ()
        estimator.command(0.01 * n, 0.0)
    estimate = estimator.estimate(0.99)
    assert estimate is not None and abs(estimate.position[0] - 1.0) < 1e-3
    assert estimator.rejected[RejectionReason.JUMP] == 3


@both
def test_a_jump_that_stays_is_never_believed_in_the_air_but_told(
    make: Make,
) -> None:
    estimator, events = make(), []
    for n in range(200):
        jump = 2.0 if n >= 100 else 0.0
        events += estimator.update(seen(1.0 + jump, 2.0, 0.01 * n), now=0.01 * n)
        estimator.command(0.01 * n, 0.0)
    assert [event.code for event in events] == ["tracking_refused"]
    assert 0.5 <= events[0].at - 1.0 < 0.6
    estimate = estimator.estimate(1.99)
    assert estimate is not None and estimate.position[0] < 1.5 and estimate.pose_age > 0.9


@both
@pytest.mark.parametrize("offset", [(0.4, 0.0), (0.0, 0.4)])
def test_a_refused_jump_is_not_believed_by_waiting(make: Make, offset: tuple[float, float]) -> None:
    estimator = make()
    for n in range(500):
        dx, dz = offset if n >= 100 else (0.0, 0.0)
        estimator.update(seen(1.0 + dx, 2.0, 0.01 * n, z=1.0 + dz), now=0.01 * n)
        estimator.command(0.01 * n, 0.0, flown=False)
    estimate = estimator.estimate(4.99)
    assert estimate is not None and estimate.pose_age > 3.9


@both
def test_on_the_ground_the_filter_starts_anew_where_the_drone_was_carried(
    make: Make,
) -> None:
    estimator, events = make(), []
    for n in range(300):
        jump = 2.0 if n >= 100 else 0.0
        events += estimator.update(seen(1.0 + jump, 2.0, 0.01 * n), now=0.01 * n, grounded=True)
    estimate = estimator.estimate(2.99)
    assert estimate is not None and estimate.position[0] == pytest.approx(3.0, abs=1e-3)
    assert "tracking_restarted" in [event.code for event in events]


@both
def test_a_yaw_flip_is_refused_like_a_jump(make: Make) -> None:
    estimator = make()
    for n in range(100):
        estimator.update(seen(1.0, 2.0, 0.01 * n, yaw=0.0 if n < 50 else pi), now=0.01 * n)
    estimate = estimator.estimate(0.99)
    assert estimate is not None and abs(estimate.yaw) < 0.1


@both
@pytest.mark.parametrize(
    ("captured", "reason"),
    [
        (0.5, RejectionReason.OUT_OF_ORDER),
        (0.4, RejectionReason.OUT_OF_ORDER),
        (0.9, RejectionReason.FUTURE),
        (nan, RejectionReason.NOT_FINITE),
        (inf, RejectionReason.NOT_FINITE),
    ],
)
def test_bad_stamps_are_dropped_and_counted(
    make: Make, captured: float, reason: RejectionReason
) -> None:
    estimator = make()
    estimator.update(seen(1.0, 2.0, 0.5), now=0.5)
    before = estimator.estimate(0.6)
    estimator.update(seen(1.1, 2.0, captured), now=0.6)
    assert estimator.estimate(0.6) == before
    assert estimator.rejected[reason] == 1


@both
def test_a_pose_that_is_too_old_or_no_rotation_is_dropped(make: Make) -> None:
    estimator = make()
    estimator.update(seen(1.0, 2.0, 0.5), now=0.5)
    estimator.update(seen(1.0, 2.0, 0.6), now=5.0)
    estimator.update(
        Sighting("ardrone", Pose((1.0, 2.0, 1.0), (0.5, 0.0, 0.0, 0.0)), 5.0, 5.0), now=5.0
    )
    assert estimator.rejected[RejectionReason.STALE] == 1
    assert estimator.rejected[RejectionReason.NOT_A_ROTATION] == 1


@both
def test_yaw_follows_through_the_cut_without_a_jump(make: Make) -> None:
    estimator = make()
    for n in range(400):
        now = 0.01 * n
        estimator.update(seen(1.0, 2.0, now, yaw=3.0 + 0.5 * now), now=now)
        estimate = estimator.estimate(now)
        assert estimate is not None
        assert -pi < estimate.yaw <= pi
        if n > 100:
            assert abs(wrap_angle(estimate.yaw - 3.0 - 0.5 * now)) < 0.02


def test_a_steady_push_is_learned_and_offered_for_cancelling() -> None:
    estimator, v, x = delay_compensated(), 0.0, 0.0
    for n in range(600):
        now = 0.01 * n
        estimator.update(seen(x, 0.0, now), now=now)
        estimator.command(now, 0.0)
        v += 0.01 * (0.15 - 0.58 * v)
        x += 0.01 * v
    ahead = estimator.ahead(6.0)
    assert ahead is not None and ahead.disturbance[0] == pytest.approx(0.15, abs=0.03)


def test_the_state_for_control_is_one_command_delay_ahead_of_the_estimate() -> None:
    estimator = delay_compensated()
    for n in range(200):
        estimator.update(seen(0.4 * 0.01 * n, 0.0, 0.01 * n), now=0.01 * n)
        estimator.command(0.01 * n, 0.4 * 0.58)
    estimate, ahead = estimator.estimate(1.99), estimator.ahead(1.99)
    assert estimate is not None and ahead is not None
    assert ahead.position[0] - estimate.position[0] == pytest.approx(
        0.4 * SITE.drone.command_delay, abs=2e-3
    )


def test_asking_twice_does_not_change_the_answer() -> None:
    estimator = delay_compensated()
    estimator.update(seen(1.0, 2.0, 0.0), now=0.0)
    estimator.command(0.0, 0.3)
    assert estimator.estimate(3.0) == estimator.estimate(3.0)


anything = st.one_of(st.floats(), st.floats(-5.0, 5.0))
garbage = st.builds(
    Sighting,
    st.sampled_from(["ardrone", "visitor"]),
    st.builds(
        Pose,
        st.tuples(anything, anything, anything),
        st.tuples(*[st.floats(-1.0, 1.0) | st.floats()] * 4),
    ),
    st.floats(-1.0, 3.0) | st.floats(),
    st.just(0.0),
)


@both
@settings(max_examples=60)
@given(data=st.lists(garbage, max_size=20))
def test_no_garbage_makes_the_estimate_infinite(make: Make, data: list[Sighting]) -> None:
    estimator = make()
    estimator.update(seen(1.0, 1.0, 0.0), now=0.0)
    for n, sighting in enumerate(data, start=1):
        estimator.update(sighting, now=0.1 * n, grounded=n % 2 == 0)
        estimator.command(0.1 * n, cos(n), sin(n), flown=n % 3 > 0)
        estimate = estimator.estimate(0.1 * n)
        assert estimate is not None
        assert all(
            isfinite(value)
            for value in (
                *estimate.position,
                *estimate.velocity,
                estimate.yaw,
                estimate.position_std,
            )
        )


@both
@pytest.mark.parametrize(("off", "believed"), [(0.1, True), (0.3, False), (1.0, False)])
@pytest.mark.parametrize("blind", [0.3, 1.0, 1.9])
def test_without_flow_no_far_place_is_believed_after_a_gap(
    make: Make, off: float, believed: bool, blind: float
) -> None:
    estimator = make()
    for tick in range(100):
        at = 0.01 * tick
        estimator.command(at, 0.0)
        estimator.update(seen(1.0, 1.0, at), now=at)
        estimator.estimate(at)
    back = 0.99 + blind
    while at < back:
        at += 0.01
        estimator.command(at, 0.0, flown=False)
        estimator.estimate(at)
    for tick in range(20):
        estimator.update(seen(1.0 + off, 1.0, back + 0.01 * tick), now=back + 0.01 * tick)
    found = estimator.estimate(back + 0.2)
    assert found is not None
    assert (found.pose_age < 0.1) is believed
