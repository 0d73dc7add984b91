from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from housefly.geometry import heading_to, wrap_angle
from housefly.messages import Action, Behavior, DroneStatus, OrderKind, Phase, SafetyMode, Severity
from housefly.pilot.control.model import Constants

SERVICE = [
    Phase.IDLE,
    Phase.TAKING_OFF,
    Phase.OUTBOUND,
    Phase.LOOKING,
    Phase.RETURNING,
    Phase.LANDING,
    Phase.IDLE,
]
Fly = Callable[..., Any]


@pytest.mark.parametrize(
    ("rate_hz", "latency", "loss"),
    [
        (100.0, 0.02, 0.0),
        (10.0, 0.05, 0.2),
        *(
            pytest.param(*tracking, marks=pytest.mark.safety)
            for tracking in (
                (100.0, 0.05, 0.2),
                (30.0, 0.05, 0.2),
                (30.0, 0.03, 0.0),
                (10.0, 0.02, 0.0),
            )
        ),
    ],
)
def test_the_whole_service_is_flown_close_to_the_path(
    fly: Fly, rate_hz: float, latency: float, loss: float
) -> None:
    flight = fly(tracking={"rate_hz": rate_hz, "latency": latency, "loss": loss})
    score = flight.service()
    assert flight.phases[1 - len(SERVICE) - 1 :] == SERVICE
    assert score.rms < 0.03 and max(score.errors) < 0.1
    assert flight.home_error < 0.1
    assert all(event.severity is not Severity.FAULT for event in flight.events)


@pytest.mark.parametrize("rate_hz", [pytest.param(100.0, marks=pytest.mark.safety), 10.0])
@pytest.mark.parametrize(
    ("constants", "delay"),
    [
        (Constants(lag=5.0), 0.1),
        pytest.param(Constants(lag=10.0, gain=1.2), 0.04, marks=pytest.mark.safety),
        (Constants(gain=0.8, drag=0.3), 0.06),
    ],
)
def test_a_drone_that_differs_from_its_profile_is_still_flown_well(
    fly: Fly, rate_hz: float, constants: Constants, delay: float
) -> None:
    flight = fly(tracking={"rate_hz": rate_hz, "latency": 0.05}, constants=constants, delay=delay)
    assert flight.service().rms < 0.05
    assert flight.home_error < 0.1


def test_a_steady_draught_moves_neither_the_path_nor_the_landing(fly: Fly) -> None:
    flight = fly(wind=(0.2, -0.1), tracking={"rate_hz": 30.0, "latency": 0.05})
    assert flight.service().rms < 0.03
    assert flight.home_error < 0.1


def test_the_drone_faces_the_visitor_while_it_looks_and_the_pads_way_when_it_lands(
    fly: Fly,
) -> None:
    flight = fly()
    flight.run(0.5)
    flight.step(flight.order(OrderKind.SERVICE, place="entrance", look_s=2.0))
    flight.until(lambda o: o.phase is Phase.RETURNING)
    wanted = heading_to((flight.body.x, flight.body.y), (10.75, 0.0))
    assert abs(wrap_angle(flight.body.psi - wanted)) < 0.15
    flight.until(lambda o: o.phase is Phase.LANDING)
    assert abs(wrap_angle(flight.body.psi - flight.room.home_yaw)) < 0.4
    assert flight.home_error < 0.1


def test_the_phases_name_the_goal_and_carry_the_path(fly: Fly) -> None:
    flight = fly()
    flight.run(0.5)
    outputs = flight.step(flight.order(OrderKind.GO, place="entrance"))
    assert (
        outputs.phase is Phase.TAKING_OFF
        and outputs.path is not None
        and outputs.goal_name == "entrance"
    )
    outputs = flight.until(lambda o: o.phase is Phase.HOLDING)
    assert outputs.path.waypoints[-1] == pytest.approx((10.75, 1.25))
    assert outputs.reference is not None and outputs.estimate is not None
    assert flight.run(5.0).phase is Phase.HOLDING


@pytest.mark.parametrize(
    "rate_hz", [*(pytest.param(rate, marks=pytest.mark.safety) for rate in (100.0, 30.0)), 10.0]
)
def test_mode_paper_flies_the_service_too(fly: Fly, rate_hz: float) -> None:
    flight = fly(mode="paper", tracking={"rate_hz": rate_hz, "latency": 0.02})
    score = flight.service()
    assert flight.phases[1 - len(SERVICE) - 1 :] == SERVICE
    assert score.rms < 0.25 and max(score.errors) < 0.75


@pytest.mark.interop
def test_mode_default_is_better_than_mode_paper_in_the_same_room(fly: Fly) -> None:
    tracking = {"rate_hz": 10.0, "latency": 0.05, "loss": 0.2}
    default = fly(tracking=tracking, wind=(0.1, 0.1)).service()
    paper = fly(mode="paper", tracking=tracking, wind=(0.1, 0.1)).service()
    assert 2.0 * default.rms < paper.rms
    assert 5.0 * default.switches / default.flown_s < paper.switches / paper.flown_s


def test_mode_paper_commands_one_axis_at_a_time_and_mode_default_all(fly: Fly) -> None:
    allowed = {
        Behavior.HOVER: (0, 0, 0, 0),
        Behavior.ALTITUDE_CONTROL: (0, 0, 1, 0),
        Behavior.YAW_CONTROL: (0, 0, 0, 1),
        Behavior.PATH_TRACKING: (1, 1, 0, 0),
    }
    flight = fly(mode="paper")
    outputs = flight.depart()
    while outputs.phase is Phase.OUTBOUND:
        s = outputs.command.setpoint
        for value, free in zip(
            (s.theta, s.phi, s.vz, s.yaw_rate), allowed[outputs.behavior], strict=True
        ):
            assert value == 0.0 or free
        assert (outputs.command.action is Action.HOVER) == (outputs.behavior is Behavior.HOVER)
        outputs = flight.step()


def test_mode_default_holds_its_place_while_it_turns_and_mode_paper_drifts(fly: Fly) -> None:
    moved = {}
    for mode in ("default", "paper"):
        flight = fly(mode=mode, wind=(0.0, 0.3), map__planner="grid")
        flight.body, flight.origin_known = flight.body._replace(psi=3.0), True
        flight.run(0.5)
        flight.step(flight.order(OrderKind.GO, place="entrance"))
        flight.until(lambda o: o.behavior is Behavior.YAW_CONTROL)
        start = flight.body
        flight.until(lambda o: o.behavior is Behavior.PATH_TRACKING)
        moved[mode] = abs(flight.body.y - start.y)
    assert moved["default"] < 0.05
    assert moved["paper"] > 3.0 * moved["default"]


def test_half_a_second_without_tracking_is_flown_through_and_five_seconds_end_in_a_landing(
    fly: Fly,
) -> None:
    short = fly(tracking={"gaps": ((15.0, 15.5),)}, wind=(0.1, 0.0))
    score = short.service()
    assert short.told("tracking_old") and short.told("safety_clear")
    assert max(score.errors) < 0.15 and short.home_error < 0.1

    long = fly(tracking={"gaps": ((15.0, 20.0),)})
    long.run(0.5)
    long.step(long.order(OrderKind.SERVICE, place="entrance"))
    long.until(
        lambda o: long.status is DroneStatus.LANDED and o.phase is Phase.IDLE and long.now > 5.0
    )
    assert long.told("tracking_lost")
    assert Phase.RETURNING not in long.phases
    assert long.run(5.0).phase is Phase.IDLE
    assert long.outputs.safety is SafetyMode.NOMINAL
