from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import nan
from typing import Any

import pytest
from gate_bench import blind

from housefly.geometry import distance
from housefly.messages import (
    Action,
    DroneFault,
    DroneStatus,
    OrderKind,
    Phase,
    SafetyMode,
    Telemetry,
)
from housefly.pilot.safety.energy import GAUGE_STILL_TIME

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
    assert outputs.command.setpoint.vz < 0.0 and "silent" in outputs.reason
    assert flight.until(lambda o: o.command.action is Action.LAND, 6.0).safety is SafetyMode.LAND
    assert flight.body.z < 0.35, "sunk by tracking until there"
    flight.run(5.0)
    flight.talks = True
    landed(flight)


def test_an_order_to_land_is_kept_while_a_silent_drone_last_said_that_it_stands(fly: Fly) -> None:
    flight = fly()
    flight.run(0.5)
    flight.step(flight.order(OrderKind.TAKE_OFF))
    flight.talks = False
    flight.run(5.0)
    assert flight.body.z > 0.5
    flight.step(flight.order(OrderKind.LAND))
    flight.run(1.0)
    flight.talks = True
    landed(flight)


def test_an_empty_battery_lands_the_drone_where_it_is(fly: Fly) -> None:
    flight = cruising(fly())
    flight.battery = 0.14
    flight.until(lambda o: o.safety is SafetyMode.LAND, 1.2)
    landed(flight)
    assert flight.told("battery_low")


def test_a_drone_that_is_blown_away_is_held_then_landed_before_it_is_out(fly: Fly) -> None:
    flight = fly()
    flight.take_off()
    flight.wind = (-2.0, 0.0)
    flight.until(lambda o: o.safety is SafetyMode.LAND, 20.0)
    assert flight.told("drifting") and flight.body.x > -flight.site.limits.fence_margin


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


@pytest.mark.parametrize("damaged", [DroneStatus.LANDED, DroneStatus.EMERGENCY])
def test_one_damaged_report_in_flight_ends_no_mission(fly: Fly, damaged: DroneStatus) -> None:
    flight = cruising(fly())
    true, told = flight.report, len(flight.events)

    def damaged_once() -> Telemetry:
        flight.report = true
        return replace(true(), status=damaged)

    flight.report = damaged_once
    flight.run(0.1)
    assert flight.report is true, "it was told"
    outputs = flight.run(1.0)
    assert outputs.phase is Phase.OUTBOUND and outputs.safety is SafetyMode.NOMINAL
    assert flight.events[told:] == []


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
    own = {Phase.TAKING_OFF: Action.HOVER, Phase.LANDING: Action.LAND}
    assert outputs.command.action is own.get(moment, Action.FLY)
    assert outputs.safety is SafetyMode.STOPPED
    if moment in own:
        return
    flight.run(1.5)
    begun = flight.body
    assert flight.run(3.0).safety is SafetyMode.STOPPED
    assert distance((flight.body.x, flight.body.y), (begun.x, begun.y)) < 0.03


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


def test_a_complaint_of_the_drone_lands_it_or_is_shown(fly: Fly) -> None:
    flight = cruising(fly())
    flight.faults, flight.notes = (DroneFault.USER_EMERGENCY,), ("tilt limit refused",)
    outputs = flight.run(0.5)
    assert outputs.safety is SafetyMode.WARN and outputs.phase is Phase.OUTBOUND
    assert outputs.command.action is Action.FLY and len(outputs.warnings) == 2
    assert outputs.reason == outputs.warnings[0]
    flight.faults = (DroneFault.MOTORS_PROBLEM,)
    outputs = flight.run(0.5)
    assert outputs.safety is SafetyMode.LAND and "motors problem" in outputs.reason
    landed(flight)
    flight.step(flight.order(OrderKind.GO, place="entrance"))
    assert "motors problem" in flight.events[-1].text and flight.run(0.1).phase is Phase.IDLE


def test_a_drone_that_did_not_confirm_its_limits_stays_down_and_is_landed_in_the_air(
    fly: Fly,
) -> None:
    flight = fly()
    flight.configured = False
    flight.run(0.5)
    assert flight.step(flight.order(OrderKind.TAKE_OFF)).phase is Phase.IDLE
    assert "confirmed its limits" in flight.events[-1].text
    flight.configured = True
    flight.take_off()
    flight.configured = False
    assert flight.run(0.5).safety is SafetyMode.HOLD
    landed(flight)
    assert flight.told("configuring") and flight.now > 0.0


def test_a_late_loop_slows_then_holds_then_lands(fly: Fly) -> None:
    flight = cruising(fly())
    flight.late = 0.06
    flight.run(3.0)
    assert flight.outputs.safety is SafetyMode.SLOW and flight.speed < 0.35
    flight.late = 0.3
    assert flight.run(0.5).safety is SafetyMode.HOLD
    flight.late = 0.0
    assert flight.run(3.5).safety is SafetyMode.NOMINAL
    flight.late = 1.1
    assert flight.run(0.1).safety is SafetyMode.LAND


def test_a_pose_that_stays_half_a_second_old_does_not_hover_for_ever(fly: Fly) -> None:
    flight = cruising(fly())
    flight.tracking.latency = 0.5
    flight.until(lambda o: o.safety is SafetyMode.LAND, 6.0)
    assert flight.told("held_too_often")
    landed(flight)


def test_a_drone_that_is_held_fast_is_told_and_landed(fly: Fly) -> None:
    flight = cruising(fly())
    free, place = flight._fly, flight.body

    def held_fast() -> None:
        free()
        b = flight.body
        flight.body = b._replace(x=place.x, y=place.y, vx=0.0, vy=0.0)

    flight._fly = held_fast
    flight.until(lambda o: o.safety is SafetyMode.LAND, 6.0)
    landed(flight)


def test_charge_for_no_more_than_the_way_home_turns_it_home_and_less_keeps_it_down(
    fly: Fly,
) -> None:
    flight = fly()
    flight.battery = 0.3
    cruising(flight)
    flight.battery = 0.2
    flight.until(lambda o: o.safety is SafetyMode.RETURN, 1.5)
    flight.until(lambda o: o.phase is Phase.RETURNING, 0.5)
    flight.step(flight.order(OrderKind.GO, place="entrance"))
    assert "coming home for safety" in flight.events[-1].text
    flight.battery = 0.3
    assert flight.run(1.2).safety is SafetyMode.NOMINAL
    flight.step(flight.order(OrderKind.GO, place="entrance"))
    assert "coming home for safety" in flight.events[-1].text, "whatever the gauge shows since"
    landed(flight, 60.0)
    assert flight.home_error < 0.1 and flight.told("battery_return")
    flight.battery = 0.25
    flight.run(0.1)
    flight.step(flight.order(OrderKind.SERVICE, place="entrance"))
    assert "there and back" in flight.events[-1].text
    assert flight.run(0.1).phase is Phase.IDLE


def turned_home(flight: Any) -> Any:
    """Return in mid-flight, when the charge turns the drone home."""
    flight.battery = 0.3
    cruising(flight)
    flight.battery = 0.2
    flight.until(lambda o: o.safety is SafetyMode.RETURN and o.phase is Phase.RETURNING, 2.0)
    return flight


def test_a_drone_turned_home_is_slowed_and_held_by_a_late_loop_and_flies_home_after_it(
    fly: Fly,
) -> None:
    flight = turned_home(fly())
    flight.late = 0.06
    assert flight.run(3.0).safety is SafetyMode.RETURN and 0.1 < flight.speed < 0.35
    flight.late = 0.3
    outputs = flight.run(1.5)
    assert (outputs.safety, outputs.command.action) == (SafetyMode.RETURN, Action.HOVER)
    assert any("the drone holds itself" in words for words in outputs.warnings)
    assert "coming home" in outputs.reason and flight.speed < 0.1
    flight.late = 0.0
    landed(flight, 60.0)
    assert flight.home_error < 0.1 and flight.outputs.safety is SafetyMode.NOMINAL


@pytest.mark.parametrize("seed", [1, 2])
def test_a_drone_turned_home_comes_home_at_ten_hertz_though_three_frames_of_ten_are_lost(
    fly: Fly, seed: int
) -> None:
    flight = turned_home(fly(seed=seed, tracking={"rate_hz": 10.0, "loss": 0.3}))
    landed(flight, 60.0)
    assert flight.told("tracking_old") and flight.home_error < 0.3


def test_a_drone_turned_home_that_tracking_lost_for_good_lands_after_two_seconds(fly: Fly) -> None:
    flight = turned_home(fly())
    lost = flight.now
    flight.tracking.gaps = ((lost, 1e9),)
    flight.until(lambda o: o.safety is SafetyMode.LAND, 3.0)
    assert 1.9 < flight.now - lost < 2.1 and flight.told("tracking_lost")
    landed(flight)


def test_a_gauge_that_stood_still_refuses_the_next_take_off_until_it_shows_another_number(
    fly: Fly,
) -> None:
    flight, shown = cruising(fly()), [0.8]
    told = flight.report
    flight.report = lambda: replace(told(), battery=shown[0])
    flight.run(GAUGE_STILL_TIME + 1.0)
    assert flight.told("battery_gauge")
    flight.step(flight.order(OrderKind.LAND))
    landed(flight)
    flight.run(5.0)
    outputs = flight.step(flight.order(OrderKind.TAKE_OFF))
    assert outputs.phase is Phase.IDLE
    assert "the battery's gauge stood still: stuck at 80%, must be moving" in flight.events[-1].text
    shown[0] = 0.79
    flight.run(0.1)
    assert flight.step(flight.order(OrderKind.TAKE_OFF)).phase is Phase.TAKING_OFF


def test_a_drone_without_orders_comes_home_and_lands(fly: Fly) -> None:
    flight = fly(limits__hold_timeout=5.0)
    flight.depart()
    flight.until(lambda o: o.phase is Phase.HOLDING)
    held = flight.now
    flight.until(lambda o: o.phase is Phase.RETURNING, 6.0)
    assert flight.now - held > 4.9
    landed(flight, 60.0)
    assert flight.home_error < 0.1


def ignore_land(flight: Any) -> None:
    """Let the drone obey everything but Land, and stop on the floor."""
    obeyed, floor = flight._firmware, flight._fly

    def deaf_to_landing() -> None:
        if flight.command.action is not Action.LAND:
            obeyed()

    def on_the_floor() -> None:
        floor()
        flight.body = flight.body._replace(z=max(0.0, flight.body.z))

    flight._firmware, flight._fly = deaf_to_landing, on_the_floor


def test_a_landing_that_the_drone_does_not_do_is_done_for_it_and_its_motors_cut(fly: Fly) -> None:
    flight = fly()
    flight.take_off()
    ignore_land(flight)
    flight.step(flight.order(OrderKind.LAND))
    outputs = flight.until(lambda o: o.safety is SafetyMode.DESCEND, 16.0)
    assert outputs.command.action is Action.FLY and outputs.command.setpoint.vz < 0.0
    outputs = flight.until(lambda o: o.safety is SafetyMode.CUT, 15.0)
    assert flight.body.z < 0.05 and outputs.command.action is Action.CUT
    assert flight.told("landing_refused") and flight.told("motors_running")


def test_a_landing_that_the_drone_does_not_do_is_done_for_it_although_nobody_tracks_it(
    fly: Fly,
) -> None:
    flight = fly()
    flight.take_off()
    ignore_land(flight)
    flight.tracking.gaps = ((flight.now, flight.now + 100.0),)
    outputs = flight.until(lambda o: o.safety is SafetyMode.DESCEND, 25.0)
    assert outputs.command.action is Action.FLY and outputs.command.setpoint.vz < 0.0
    flight.until(lambda o: flight.body.z < 0.05, 15.0)
    assert flight.told("tracking_lost") and flight.told("landing_refused")
    assert flight.outputs is not None and abs(flight.outputs.command.setpoint.theta) < 0.01


def test_a_drone_that_stands_on_something_has_not_just_landed(fly: Fly) -> None:
    flight = cruising(fly())
    free = flight._fly

    def on_a_stool() -> None:
        free()
        b = flight.body
        if flight.status is DroneStatus.LANDING and b.z <= 0.6:
            flight._become(DroneStatus.LANDED)
        flight.body = b._replace(z=max(b.z, 0.6))

    flight._fly = on_a_stool
    flight.step(flight.order(OrderKind.LAND))
    flight.until(lambda o: o.phase is Phase.IDLE, 15.0)
    last = next(event for event in reversed(flight.events) if event.code == "grounded")
    assert "on something" in last.text and "landed" not in last.text
    assert any("on something" in words for words in flight.run(0.5).warnings)


@pytest.mark.parametrize("push", [(0.0, 3.0), (-0.5, 3.0)])
def test_a_drone_that_was_pushed_off_its_course_rests_and_goes_on_from_where_it_is(
    fly: Fly, push: tuple[float, float]
) -> None:
    flight = cruising(fly())
    calm, flight.wind = flight.wind, push
    flight.until(lambda o: o.safety is SafetyMode.HOLD, 3.0)
    flight.wind = calm
    flight.until(lambda o: o.phase is Phase.HOLDING, 60.0)
    assert flight.told("off_course") and flight.status is DroneStatus.FLYING
    assert distance((flight.body.x, flight.body.y), (10.75, 1.25)) < 0.15


def test_a_drone_whose_orders_go_on_lagging_is_landed(fly: Fly) -> None:
    flight = cruising(fly())
    flight.delay = 1.0
    landed(flight, 40.0)


def test_a_drone_that_is_held_off_its_course_by_tracking_that_is_refused_goes_nowhere(
    fly: Fly,
) -> None:
    flight = cruising(fly())
    look = flight._look
    flight._look = lambda: tuple(
        replace(s, pose=replace(s.pose, position=(s.pose.position[0] + 0.9, *s.pose.position[1:])))
        for s in look()
    )
    landed(flight, 30.0)
    assert not flight.told("off_course")
