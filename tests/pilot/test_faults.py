from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import nan
from typing import Any

import pytest
from gate_bench import blind

from housefly.geometry import distance
from housefly.messages import Action, DroneStatus, OrderKind, Phase, SafetyMode

Fly = Callable[..., Any]


def cruising(flight: Any) -> Any:
    """Send the drone towards the entrance and return in mid-flight."""
    flight.depart(6.0)
    return flight


def landed(flight: Any, limit: float = 15.0) -> None:
    flight.until(lambda o: o.phase is Phase.IDLE and flight.status is DroneStatus.LANDED, limit)


def test_tracking_older_than_a_quarter_second_means_hover_and_it_goes_on_by_itself(
    fly: Fly,
) -> None:
    flight = cruising(fly())
    lost = flight.now
    flight.tracking.gaps = ((lost, lost + 1.0),)
    outputs = flight.until(lambda o: o.safety is SafetyMode.HOLD)
    assert 0.2 < flight.now - lost < 0.3
    assert outputs.command.action is Action.HOVER
    assert "tracking lost" in outputs.reason
    outputs = flight.run(0.7)
    assert outputs.safety is SafetyMode.HOLD and outputs.reference.velocity[0] < 0.15
    flight.until(lambda o: o.safety is SafetyMode.NOMINAL, 2.0)
    assert flight.until(lambda o: o.phase is Phase.HOLDING).goal_name == "entrance"


def test_tracking_older_than_two_seconds_lands_and_nothing_moves_without_a_fresh_order(
    fly: Fly,
) -> None:
    flight = cruising(fly())
    lost = flight.now
    flight.tracking.gaps = ((lost, lost + 2.5),)
    flight.until(lambda o: o.safety is SafetyMode.LAND)
    assert 1.9 < flight.now - lost < 2.1
    flight.step(flight.order(OrderKind.GO, place="entrance"))
    landed(flight)
    outputs = flight.run(5.0)
    assert outputs.phase is Phase.IDLE and outputs.command.action is Action.IDLE
    assert outputs.safety is SafetyMode.NOMINAL
    flight.step(flight.order(OrderKind.HOME))
    flight.step(flight.order(OrderKind.SERVICE, place="entrance"))
    flight.until(lambda o: o.phase is Phase.LOOKING)


def test_without_the_gate_the_same_loss_of_tracking_does_harm(fly: Fly) -> None:
    strayed = {}
    for guarded in (True, False):
        flight = fly(wind=(0.0, 0.0))
        flight.take_off()
        flight.wind = (0.3, 0.2)
        if not guarded:
            flight.pilot._gate.assess = blind
        flight.tracking.gaps = ((flight.now, 1e9),)
        start = (flight.body.x, flight.body.y)
        flight.run(8.0)
        strayed[guarded] = distance((flight.body.x, flight.body.y), start)
    assert strayed[True] < 0.5
    assert strayed[False] > 2.0


def test_a_spike_of_the_tracking_moves_nothing(fly: Fly) -> None:
    flight = fly()
    flight.take_off()
    flight.run(3.0)
    here = (flight.body.x, flight.body.y)
    look = flight._look
    flight._look = lambda: tuple(
        replace(s, pose=replace(s.pose, position=(s.pose.position[0] + 1.0, *s.pose.position[1:])))
        for s in look()
    )
    flight.run(0.05)
    flight._look = look
    flight.run(2.0)
    assert distance((flight.body.x, flight.body.y), here) < 0.03


def test_a_tracking_system_that_jumps_for_good_is_told_and_ends_in_a_landing(fly: Fly) -> None:
    flight = fly()
    flight.take_off()
    here = (flight.body.x, flight.body.y)
    look = flight._look
    flight._look = lambda: tuple(
        replace(s, pose=replace(s.pose, position=(s.pose.position[0] + 1.5, *s.pose.position[1:])))
        for s in look()
    )
    landed(flight)
    assert flight.told("tracking_refused") and flight.told("tracking_lost")
    assert distance((flight.body.x, flight.body.y), here) < 0.4
    flight.run(1.0)
    assert flight.told("tracking_restarted")


def test_poses_that_are_not_numbers_count_as_no_tracking(fly: Fly) -> None:
    flight = fly()
    flight.take_off()
    look = flight._look
    flight._look = lambda: tuple(
        replace(s, pose=replace(s.pose, position=(nan, 0.0, 1.0))) for s in look()
    )
    landed(flight)
    assert flight.told("tracking_lost")


def test_a_drone_that_falls_silent_is_landed(fly: Fly) -> None:
    flight = cruising(fly())
    flight.talks = False
    outputs = flight.until(lambda o: o.safety is SafetyMode.LAND, 1.2)
    assert outputs.command.action is Action.LAND and "silent" in outputs.reason
    flight.run(5.0)
    flight.talks = True
    landed(flight)


def test_an_empty_battery_lands_the_drone_where_it_is(fly: Fly) -> None:
    flight = cruising(fly())
    flight.battery = 0.14
    flight.until(lambda o: o.safety is SafetyMode.LAND, 1.2)
    landed(flight)
    assert flight.told("battery_low")


def test_a_drone_blown_out_of_its_map_is_landed(fly: Fly) -> None:
    flight = fly()
    flight.take_off()
    flight.wind = (-4.0, 0.0)
    flight.until(lambda o: o.safety is SafetyMode.LAND, 20.0)
    assert flight.told("outside_fence")


def test_a_drone_that_lands_by_itself_or_cuts_out_ends_the_mission_in_words(fly: Fly) -> None:
    flight = cruising(fly())
    flight._become(DroneStatus.LANDING)
    landed(flight)
    assert flight.told("sinking")
    tumbled = cruising(fly())
    tumbled._become(DroneStatus.EMERGENCY)
    outputs = tumbled.run(0.2)
    assert outputs.phase is Phase.IDLE and outputs.command.action is Action.IDLE
    assert outputs.safety is SafetyMode.CUT and tumbled.told("emergency")


@pytest.mark.parametrize(
    "moment", [Phase.TAKING_OFF, Phase.OUTBOUND, Phase.LOOKING, Phase.RETURNING, Phase.LANDING]
)
def test_stop_takes_effect_in_the_same_step_in_every_phase(fly: Fly, moment: Phase) -> None:
    flight = fly()
    flight.run(0.5)
    flight.step(flight.order(OrderKind.SERVICE, goal=(3.0, 2.5), look_s=1.0))
    flight.until(lambda o: o.phase is moment)
    flight.run(0.1)
    outputs = flight.step(flight.order(OrderKind.STOP))
    assert outputs.command.action is (Action.LAND if moment is Phase.LANDING else Action.HOVER)
    assert outputs.safety is SafetyMode.STOPPED


def test_a_fault_free_flight_reports_no_fault(fly: Fly) -> None:
    flight = fly(tracking={"rate_hz": 10.0, "latency": 0.05, "loss": 0.3})
    flight.service()
    codes = {event.code for event in flight.events}
    assert not codes & {
        "tracking_lost",
        "tracking_refused",
        "outside_fence",
        "not_finite",
        "telemetry_lost",
        "overdue",
    }
