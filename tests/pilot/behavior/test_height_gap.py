"""Whether something stands below the drone, by its own height and the tracked one."""

from __future__ import annotations

from collections.abc import Callable
from math import nan

import pytest

from housefly.config.airframe import airframe_named
from housefly.messages.sensing import DroneStatus, Estimate, Telemetry
from housefly.pilot.behavior.height_gap import (
    AGREEMENT_TIME,
    EVERYWHERE_STEPS,
    GAP_TIME,
    HEIGHT_GAP_MAX,
    LOW_MAX,
    STUCK_WAY,
    WAY_STEP,
    ShownEverywhere,
    SonarMonitor,
)
from housefly.pilot.behavior.mission import VehicleStatus

SONAR = airframe_named("ardrone").sonar
PERIOD = 0.05
FLYING, LANDED = DroneStatus.FLYING, DroneStatus.LANDED
Feel = Callable[..., float]


@pytest.fixture
def monitor() -> SonarMonitor:
    return SonarMonitor(SONAR)


@pytest.fixture
def feel(monitor: SonarMonitor) -> Feel:
    """Return what lets the monitor hear heights [m], and returns what it finds at the end [m]."""
    now = [0.0]

    def heard(
        *told: float,
        z: float = 1.1,
        status: DroneStatus = FLYING,
        age: float = 0.0,
        speed: float = 0.0,
    ) -> float:
        for height in told:
            now[0] += PERIOD
            place = (speed * now[0], 0.0, z)
            estimate = Estimate(now[0], place, (0.0, 0.0, 0.0), 0.0, 0.0, 0.0)
            report = Telemetry(now[0], status, 0.9, height=height)
            monitor.step(VehicleStatus(now[0], status, 0.9, age, estimate, False, telemetry=report))
        return monitor.found if monitor.is_sure(now[0]) else 0.0

    return heard


LONG = round(GAP_TIME / PERIOD) + 2


def test_a_stool_is_found_as_high_as_it_is(feel: Feel) -> None:
    assert feel(*[1.1] * LONG) == 0.0
    assert feel(*[0.5] * LONG) == pytest.approx(0.6)


@pytest.mark.parametrize("told", [0.0, 0.03, 0.15, 0.2])
def test_what_is_nearer_than_the_sonar_measures_is_found_no_lower_than_that(
    feel: Feel, told: float
) -> None:
    feel(1.1)
    assert feel(*[told] * LONG) == pytest.approx(1.1 - SONAR.range_min)


def test_it_seems_so_at_once_and_is_sure_a_little_later(feel: Feel, monitor: SonarMonitor) -> None:
    feel(1.1)
    assert feel(0.15) == 0.0 and monitor.found > 0.0
    assert feel(*[0.15] * LONG) > 0.0


WAY = round((STUCK_WAY + 2 * WAY_STEP) / (0.5 * PERIOD))
"""Reports on a way that is long enough, at 0.5 m/s."""


def test_a_sonar_that_tells_the_same_on_a_long_way_is_stuck_and_shows_nothing(feel: Feel) -> None:
    feel(1.1)
    assert feel(*[0.0] * LONG, speed=0.5) > 0.0
    assert feel(*[0.0] * WAY, speed=0.5) == 0.0
    assert feel(*[0.5, 0.51] * LONG, speed=0.5) > 0.0, "it works again"


def test_over_something_on_which_it_hovers_a_sonar_is_not_stuck(feel: Feel) -> None:
    feel(1.1)
    assert feel(*[0.15] * WAY) > 0.0


def test_over_something_long_a_sonar_that_works_is_believed(feel: Feel) -> None:
    feel(1.1)
    assert feel(*[0.5, 0.502] * WAY, speed=0.5) > 0.0


def test_one_echo_that_is_too_short_is_not_believed_for_long(
    feel: Feel, monitor: SonarMonitor
) -> None:
    assert feel(1.1, 0.15, *[1.1] * LONG) == 0.0
    assert monitor.found == 0.0


def test_echoes_from_near_that_come_and_go_are_believed(feel: Feel) -> None:
    assert feel(1.1, *[0.15, 4.0, 1.1] * LONG) > 0.0


def test_a_drone_that_has_left_what_stood_below_finds_nothing(feel: Feel) -> None:
    assert feel(1.1, *[0.15] * LONG) > 0.0
    assert feel(*[1.1] * round(AGREEMENT_TIME / PERIOD + 2)) == 0.0


def test_the_floor_at_the_end_of_a_landing_is_nothing(feel: Feel, monitor: SonarMonitor) -> None:
    feel(1.1)
    for z in (0.45, 0.3, 0.25, 0.1, 0.03):
        feel(*[max(0.0, z - 0.06)] * LONG, z=z)
        assert monitor.found == 0.0


@pytest.mark.parametrize("told", [0.0, 0.03])
def test_a_sonar_that_tells_the_floor_since_the_take_off_is_not_believed(
    feel: Feel, monitor: SonarMonitor, told: float
) -> None:
    feel(1.1)
    feel(told, z=0.0, status=LANDED)
    assert feel(*[told] * LONG) == 0.0
    assert monitor.found == 0.0


def test_a_pilot_that_begins_above_somebody_finds_them(feel: Feel) -> None:
    assert feel(*[0.15] * LONG) > 0.0


@pytest.mark.parametrize("told", [1.1, 1.1 - HEIGHT_GAP_MAX + 0.01, 3.0, nan])
def test_a_height_that_agrees_or_is_higher_or_is_no_number_is_nothing(
    feel: Feel, monitor: SonarMonitor, told: float
) -> None:
    feel(*[told] * LONG)
    assert monitor.found == 0.0


def test_an_old_report_says_nothing(feel: Feel, monitor: SonarMonitor) -> None:
    feel(1.1)
    feel(*[0.15] * LONG, age=1.0)
    assert monitor.found == 0.0


EVERYWHERE = EVERYWHERE_STEPS * WAY_STEP
BETWEEN = 0.02
"""So far the drone flies between two reports [m]."""


def flown(way: float, *heights: float, begun: ShownEverywhere | None = None) -> ShownEverywhere:
    """Return what a straight way [m] showed, with these heights again and again [m]."""
    everywhere = begun or ShownEverywhere()
    for number in range(round(way / BETWEEN) + 1):
        everywhere.step((BETWEEN * number, 0.0), heights[number % len(heights)])
    return everywhere


@pytest.mark.parametrize("heights", [(0.4,), (0.0, 0.5), (0.0, 0.9, 0.3, 0.0, 0.3)])
def test_a_sonar_that_is_low_or_noisy_on_a_long_way_is_wrong(heights: tuple[float, ...]) -> None:
    assert flown(EVERYWHERE + 2 * WAY_STEP, *heights).is_wrong
    assert not flown(EVERYWHERE - 2 * WAY_STEP, *heights).is_wrong


def test_who_may_follow_the_drone_is_never_taken_for_a_wrong_sonar() -> None:
    assert not flown(3 * EVERYWHERE, 0.9).is_wrong
    assert not flown(3 * EVERYWHERE, LOW_MAX + 0.01).is_wrong


def test_floor_that_shows_on_two_steps_makes_it_believed_again() -> None:
    everywhere = flown(EVERYWHERE + 2 * WAY_STEP, 0.4)
    assert not flown(4 * WAY_STEP, 0.0, begun=everywhere).is_wrong


def test_something_below_a_drone_that_hovers_says_nothing_of_the_sonar() -> None:
    everywhere = ShownEverywhere()
    for number in range(10_000):
        everywhere.step((0.1 * (number % 2), 0.0), 0.4)
    assert not everywhere.is_wrong


def test_a_new_flight_begins_anew() -> None:
    everywhere = flown(EVERYWHERE + 2 * WAY_STEP, 0.4)
    everywhere.forget()
    assert not everywhere.is_wrong
