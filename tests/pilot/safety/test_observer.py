from __future__ import annotations

from dataclasses import replace
from math import cos, exp, inf, isnan, nan, sin

import pytest

from housefly.config.limits import LimitsConfig
from housefly.geometry import GRAVITY
from housefly.messages import DroneStatus, Phase, Reference, Setpoint, Telemetry
from housefly.pilot.safety.inputs import GateInputs
from housefly.pilot.safety.observer import LATE_STEP, TILT_TIME_CONSTANT, FlightObserver

FINE = GateInputs(
    0.0, DroneStatus.FLYING, 0.9, 0.01, 0.05, (5.0, 2.0, 1.1), False, False, flight_height=1.1
)
HEARD = Telemetry(0.0, DroneStatus.FLYING, 0.9, theta=0.1)
TICK = 0.01


def test_what_we_ask_for_is_smoothed_about_as_the_drone_answers() -> None:
    observer = FlightObserver(LimitsConfig())
    leaning = replace(FINE, flown=Setpoint(theta=0.06, phi=-0.08))
    for n in range(1 + round(TILT_TIME_CONSTANT / TICK)):
        seen = observer.observe(replace(leaning, now=TICK * n), held=False, landing=False)
    share = 1.0 - exp(-1.0)
    assert TILT_TIME_CONSTANT == 0.2  # of the drone's inner loops, about
    assert seen.tilt_asked == pytest.approx(0.1 * share)
    report = Telemetry(0.0, DroneStatus.FLYING, 0.9, phi=-0.08 * share, theta=0.06 * share)
    seen = observer.observe(
        replace(leaning, now=TILT_TIME_CONSTANT, telemetry=report), held=False, landing=False
    )
    assert seen.tilt_error == pytest.approx(0.0, abs=1e-9)
    seen = observer.observe(replace(FINE, now=TILT_TIME_CONSTANT), held=False, landing=False)
    assert isnan(seen.tilt_asked) and isnan(seen.tilt_error)


def test_leaning_otherwise_than_told_is_added_up_while_the_drone_flies_as_told() -> None:
    observer, leaned = FlightObserver(LimitsConfig()), []
    report = Telemetry(0.0, DroneStatus.FLYING, 0.9, phi=0.0, theta=0.21)
    level = replace(FINE, telemetry=report, flown=Setpoint(), phase=Phase.OUTBOUND)
    for n in range(1600):
        flown = Setpoint() if n < 60 or 200 <= n < 240 else None
        inputs = replace(level, now=TICK * n, flown=flown)
        leaned.append(observer.observe(inputs, held=flown is None, landing=False).tilt_wrong_for)
    assert leaned[150] == pytest.approx(0.59) and leaned[300] == pytest.approx(0.99)
    assert leaned[1150] == pytest.approx(0.4, abs=0.02) and leaned[-1] == 0.0
    on_its_way_down = replace(level, now=20.0, phase=Phase.LANDING)
    for n in range(100):
        seen = observer.observe(
            replace(on_its_way_down, now=20.0 + TICK * n), held=False, landing=True
        )
    assert seen.tilt_wrong_for == 0.0


def test_holding_is_added_up_in_the_air_only_and_forgotten_after_ten_seconds() -> None:
    observer, held = FlightObserver(LimitsConfig()), []
    for n in range(1600):
        inputs = replace(FINE, now=TICK * n)
        held.append(observer.observe(inputs, held=n < 200, landing=False).held_for)
    assert held[150] == pytest.approx(1.5) and held[900] == pytest.approx(1.99)
    assert held[1100] == pytest.approx(0.99, abs=0.02) and held[-1] == 0.0
    ground = replace(FINE, status=DroneStatus.LANDED)
    for n in range(100):
        seen = observer.observe(replace(ground, now=20.0 + TICK * n), held=True, landing=False)
    assert seen.held_for == 0.0


@pytest.mark.parametrize(
    ("disturbed", "change"),
    [({}, 0.7), ({"pose_age": 0.3}, 0.0), ({"late": 0.2}, 0.0)],
    ids=["seen", "after old poses", "after a late step"],
)
def test_a_velocity_that_is_put_right_after_blindness_is_no_blow(
    disturbed: dict[str, float], change: float
) -> None:
    observer = FlightObserver(LimitsConfig())
    for n in range(200):
        velocity = (0.5, 0.0, 0.0) if n < 115 else (-0.2, 0.0, 0.0)
        inputs = replace(FINE, now=TICK * n, velocity=velocity, phase=Phase.OUTBOUND)
        if 100 <= n < 110:
            inputs = replace(inputs, **disturbed)
        seen = observer.observe(inputs, held=False, landing=False)
        if n == 120:
            assert seen.velocity_change == pytest.approx(change)
    assert seen.velocity_change == 0.0


@pytest.mark.parametrize("yaw", [0.0, 1.0, -2.5])
@pytest.mark.parametrize(("leans", "blow"), [(-0.21, 0.0), (-0.21, 0.6), (0.0, 0.6)])
def test_a_blow_is_what_the_lean_of_a_drone_that_brakes_does_not_explain(
    yaw: float, leans: float, blow: float
) -> None:
    observer, x, brake = FlightObserver(LimitsConfig()), 1.0, GRAVITY * sin(0.21)
    report = Telemetry(0.0, DroneStatus.FLYING, 0.9, theta=leans)
    unexplained = []
    for n in range(100):
        x -= brake * TICK * (leans < 0.0) + blow * (n == 50)
        velocity = (x * cos(yaw), x * sin(yaw), 0.0)
        inputs = replace(FINE, now=TICK * n, velocity=velocity, yaw=yaw, telemetry=report)
        seen = observer.observe(replace(inputs, phase=Phase.OUTBOUND), held=False, landing=False)
        unexplained.append(seen.unexplained_change)
    assert max(unexplained) == pytest.approx(blow, abs=0.03)


@pytest.mark.parametrize(
    "unknown",
    [
        {"yaw": nan},
        {"telemetry": None},
        {"velocity": None},
        *({"telemetry": replace(HEARD, **{angle: inf})} for angle in ("theta", "phi")),
    ],
)
def test_where_the_lean_is_not_known_it_explains_nothing(unknown: dict[str, object]) -> None:
    known = replace(FINE, velocity=(0.5, 0.0, 0.0), yaw=0.0, telemetry=HEARD)
    observer = FlightObserver(LimitsConfig())
    assert observer.observe(known, held=False, landing=False).unexplained_change == 0.0
    seen = observer.observe(replace(known, **unknown), held=False, landing=False)
    assert seen.unexplained_change == inf


@pytest.mark.parametrize(
    "disturbed",
    [{"pose_age": 0.3}, {"late": 0.06}, {}],
    ids=["after old poses", "after a late step", "on time"],
)
def test_a_velocity_is_off_by_what_was_missed_only_where_something_was(
    disturbed: dict[str, float],
) -> None:
    observer = FlightObserver(LimitsConfig())
    for n in range(1000):
        inputs = replace(FINE, now=TICK * n, velocity=(0.3, 0.0, 0.0), flown=Setpoint())
        inputs = replace(inputs, reference=Reference((5.0, 2.0, 1.1), (0.0, 0.0, 0.0), 0.0))
        if n % 80 == 0:
            inputs = replace(inputs, **disturbed)
        seen = observer.observe(inputs, held=False, landing=False)
    assert (seen.velocity_error > 0.25) == (not disturbed)
    if disturbed:
        assert seen.velocity_error == 0.0


def test_the_time_at_a_height_starts_anew_with_another_height_and_another_flight() -> None:
    observer, times = FlightObserver(LimitsConfig()), []
    for n in range(30):
        height = 1.1 if n < 20 else 0.9
        inputs = replace(FINE, now=0.1 * n, flight_height=height)
        times.append(observer.observe(inputs, held=False, landing=False).climbing_for)
    assert times[19] == pytest.approx(1.8) and times[29] == pytest.approx(0.8)
    landing = replace(FINE, now=3.0, phase=Phase.LANDING)
    seen = observer.observe(landing, held=False, landing=False)
    assert seen.climbing_for == 0.0 and seen.landing_for == 0.0
    later = observer.observe(replace(landing, now=3.5), held=False, landing=False)
    assert later.landing_for == pytest.approx(0.5)


def test_a_height_that_moves_with_a_trajectory_is_the_same_height_until_it_jumps() -> None:
    def climbed(step: float, follows: bool) -> float:
        observer = FlightObserver(LimitsConfig())
        for n in range(20):
            inputs = replace(
                FINE, now=0.1 * n, flight_height=1.1 + step * n, height_follows=follows
            )
            seen = observer.observe(inputs, held=False, landing=False)
        return seen.climbing_for

    assert climbed(0.01, follows=True) == pytest.approx(1.8)
    assert climbed(0.01, follows=False) == climbed(0.2, follows=True) == 0.0


def test_a_pose_that_is_just_fresh_enough_is_believed() -> None:
    limits = LimitsConfig()
    observer = FlightObserver(limits)
    stands = replace(
        FINE,
        status=DroneStatus.LANDED,
        position=(5.0, 2.0, 0.07),
        pose_age=limits.pose_age_level,
    )
    assert observer.observe(stands, held=False, landing=False).standing_height == 0.07
    for n in range(100):
        velocity = (0.5 if n < 90 else 0.0, 0.0, 0.0)
        flies = replace(FINE, now=TICK * n, pose_age=limits.pose_age_level, velocity=velocity)
        flies = replace(flies, phase=Phase.OUTBOUND)
        seen = observer.observe(flies, held=False, landing=False)
    assert seen.velocity_change == pytest.approx(0.5)


def test_a_take_off_drifts_in_both_directions_of_the_plane() -> None:
    observer = FlightObserver(LimitsConfig())
    rises = replace(FINE, status=DroneStatus.TAKING_OFF, velocity=(0.3, -0.4, 0.2))
    for n in range(300):
        seen = observer.observe(replace(rises, now=TICK * n), held=False, landing=False)
    assert seen.take_off_velocity == pytest.approx((0.3, -0.4))


def test_a_step_counts_as_late_beyond_its_bound_only() -> None:
    observer = FlightObserver(LimitsConfig())
    for n, late in enumerate((LATE_STEP, LATE_STEP, 0.051, 0.06)):
        inputs = replace(FINE, now=TICK * n, late=late)
        seen = observer.observe(inputs, held=False, landing=False)
    assert seen.late_steps == 2


def test_what_is_off_counts_from_the_moment_at_which_the_drone_has_recovered() -> None:
    observer, errors = FlightObserver(LimitsConfig()), []
    wanted = Reference((5.0, 2.0, 1.1), (0.0, 0.0, 0.0), 0.0)
    flies = replace(FINE, phase=Phase.OUTBOUND, reference=wanted, flown=Setpoint())
    for n in range(18):  # an eighth of a second: its sums are exact
        blown = replace(flies, now=n / 8.0, velocity=(0.2, 0.0, 0.0))
        errors.append(observer.observe(blown, held=False, landing=False).velocity_error)
    assert errors[7] == 0.0 and errors[8] > 0.0


def test_a_pilot_whose_every_step_is_late_is_held_as_long_as_the_clock_says() -> None:
    observer = FlightObserver(LimitsConfig())
    for n in range(11):
        late = replace(FINE, now=0.4 * n, late=0.39)
        seen = observer.observe(late, held=True, landing=False)
    assert seen.held_for == pytest.approx(4.0)
