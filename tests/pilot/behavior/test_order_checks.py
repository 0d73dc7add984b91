from __future__ import annotations

from dataclasses import replace
from itertools import product
from math import inf, nan

import pytest

from housefly.config.limits import LimitsConfig
from housefly.messages import DroneFault, DroneStatus, Order, OrderKind, Phase, Telemetry
from housefly.pilot.behavior.mission import VehicleStatus
from housefly.pilot.behavior.mission_tables import ORDERS, REFUSALS, Response
from housefly.pilot.behavior.order_checks import EXPIRING_ORDERS, OrderContext, refusal
from housefly.pilot.estimation.consistency import TrackingConsistency

LIMITS = LimitsConfig()


def reason(order: Order, context: OrderContext) -> str:
    """Return why an order may not be obeyed, "" when it may."""
    refused = refusal(order, context, LIMITS)
    return refused.reason if refused else ""


FINE = OrderContext(
    age=0.0,
    response=Response.START,
    stopped=False,
    landing_forced=False,
    status=DroneStatus.LANDED,
    battery=0.9,
    telemetry_age=0.01,
    pose_age=0.01,
)


@pytest.mark.parametrize("kind", [OrderKind.GO, OrderKind.SERVICE, OrderKind.TAKE_OFF])
def test_nothing_is_refused_when_all_is_well(kind: OrderKind) -> None:
    assert reason(Order(kind), FINE) == ""


@pytest.mark.parametrize(
    ("change", "word"),
    [
        ({"age": 0.6}, "expire"),
        ({"age": nan}, "expire"),
        ({"age": -5.0}, "expire"),
        ({"battery": 0.19}, "battery"),
        ({"battery": nan}, "battery"),
        ({"pose_age": 0.3}, "as it was 0.30 s ago (limits.pose_age_level: 0.25 s)"),
        ({"pose_age": inf}, "tracking does not see the drone"),
        ({"telemetry_age": inf}, "answer"),
        ({"stopped": True}, "STOP"),
        ({"landing_forced": True}, "landed for safety"),
        ({"status": DroneStatus.EMERGENCY}, "emergency"),
        ({"status": DroneStatus.UNKNOWN}, "unknown"),
        ({"response": Response.COMING_DOWN}, "landing"),
    ],
)
def test_each_obstacle_is_named_in_words(change: dict[str, object], word: str) -> None:
    assert word in reason(Order(OrderKind.GO), replace(FINE, **change))  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("kind", "phase"), list(product([OrderKind.LAND, OrderKind.STOP, OrderKind.CUT], Phase))
)
def test_land_stop_and_cut_are_never_refused(kind: OrderKind, phase: Phase) -> None:
    worst = OrderContext(1e9, ORDERS[kind][phase], True, True, DroneStatus.UNKNOWN, nan, inf, inf)
    assert reason(Order(kind), worst) == ""


@pytest.mark.parametrize(("kind", "phase"), list(product(OrderKind, Phase)))
def test_an_old_order_that_moves_or_releases_is_always_refused(
    kind: OrderKind, phase: Phase
) -> None:
    old = replace(FINE, age=0.51, response=ORDERS[kind][phase])
    assert bool(reason(Order(kind), old)) == (kind in EXPIRING_ORDERS or old.response in REFUSALS)


def test_reset_is_only_for_an_emergency() -> None:
    reset = replace(FINE, response=Response.RESET)
    assert "no emergency" in reason(Order(OrderKind.RESET), reset)
    assert reason(Order(OrderKind.RESET), replace(reset, status=DroneStatus.EMERGENCY)) == ""


def seen(**changes: object) -> OrderContext:
    """A drone on the ground with these values in its status."""
    vehicle = VehicleStatus(0.0, DroneStatus.LANDED, 0.9, 0.01, None, landing_forced=False)
    return replace(FINE, vehicle=replace(vehicle, **changes))  # type: ignore[arg-type]


REPORT = Telemetry(0.0, DroneStatus.LANDED, 0.9)


@pytest.mark.parametrize(
    ("change", "word"),
    [
        ({"telemetry": replace(REPORT, configured=False)}, "not confirmed its limits"),
        ({"telemetry": replace(REPORT, faults=(DroneFault.MOTORS_PROBLEM,))}, "motors problem"),
        ({"telemetry": replace(REPORT, faults=(DroneFault.ULTRASOUND_DEAF,))}, "ultrasound deaf"),
        ({"consistency": TrackingConsistency(height_error=0.31)}, "+0.31 m"),
        ({"consistency": TrackingConsistency(height_error=-0.31)}, "-0.31 m"),
        ({"return_wanted": True}, "coming home"),
    ],
)
def test_a_drone_that_is_not_fit_stays_down_and_says_why(
    change: dict[str, object], word: str
) -> None:
    assert word in reason(Order(OrderKind.GO), seen(**change))


@pytest.mark.parametrize(
    "change",
    [
        {"telemetry": replace(REPORT, faults=(DroneFault.USER_EMERGENCY,))},
        {"telemetry": REPORT, "consistency": TrackingConsistency(height_error=0.29)},
    ],
)
def test_what_does_not_matter_refuses_nothing(change: dict[str, object]) -> None:
    assert reason(Order(OrderKind.GO), seen(**change)) == ""


def test_home_may_be_ordered_of_a_drone_that_is_to_come_home() -> None:
    wanted = replace(seen(return_wanted=True), response=Response.DEPART)
    assert reason(Order(OrderKind.HOME), wanted) == ""
