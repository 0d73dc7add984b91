"""The simulated autopilot obeys, refuses and bears silence as ArduCopter and PX4 do."""

from __future__ import annotations

from math import cos, sin

import pytest
from mavlink_room import TARGET, Room, room_with

from housefly.messages import VelocitySetpoint
from housefly.twin.contracts import FlightState
from housefly.wires.mavlink import requests
from housefly.wires.mavlink.autopilots import AUTOPILOTS
from housefly.wires.mavlink.dialect import dialect
from housefly.wires.mavlink.reports import Landed, Result
from housefly.wires.mavlink.requests import CommandId

AHEAD = VelocitySetpoint(forward=0.4)
REFUSED = {
    "arducopter": (Result.FAILED, "Arm: Need Position Estimate"),
    "px4": (
        Result.TEMPORARILY_REJECTED,
        "Arming denied: Resolve system health failures first",
    ),
}


def flying(model: str) -> Room:
    """Return a room with the drone in the air, on its way ahead."""
    room = room_with(model)
    room.take_off()
    room.asked = AHEAD
    room.run(1.5)
    assert room.speed > 0.25
    return room


@pytest.mark.parametrize("model", AUTOPILOTS)
def test_it_arms_only_once_it_knows_where_it_is_and_says_so_otherwise(model: str) -> None:
    room = room_with(model)
    result, words = REFUSED[model]
    assert room.order(CommandId.ARM, 1.0) == result
    room.run(0.1)
    assert room.said == [words]
    assert room.order(CommandId.ARM, 1.0) == result, "told where it is, and no origin yet"
    room.tell(requests.origin_order(1, 0.0, 0.0, 0.0))
    assert not room.vehicle.has_origin, "zeros are no place"
    room.tell(requests.origin_order(1, 45.0, 7.0, 0.0))
    assert room.order(CommandId.ARM, 1.0) == Result.ACCEPTED
    room.has_poses = False
    room.run(11.0)
    assert not room.vehicle.armed, "nothing came of it"
    assert room.order(CommandId.ARM, 1.0) == result, "it was told too long ago"


@pytest.mark.parametrize("model", AUTOPILOTS)
def test_it_takes_off_flies_lands_and_disarms_by_itself(model: str) -> None:
    room = flying(model)
    assert room.vehicle.landed is Landed.IN_AIR and room.vehicle.armed
    before = room.world.truth().pose
    room.run(1.5)
    after = room.world.truth().pose
    ahead = cos(before.yaw), sin(before.yaw)
    moved = [there - here for there, here in zip(after.position, before.position, strict=True)]
    assert ahead[0] * moved[0] + ahead[1] * moved[1] > 0.35
    assert room.order(CommandId.ARM, 0.0) == Result.FAILED, "not in the air"
    assert room.order(CommandId.LAND) == Result.ACCEPTED
    room.asked = None
    room.run(0.3)
    assert room.vehicle.landed is Landed.LANDING
    room.run(10.0, lambda: not room.vehicle.armed)
    assert room.flight is FlightState.LANDED and not room.world.contact_log


def test_px4_refuses_offboard_without_setpoints_and_arducopter_a_take_off_unarmed() -> None:
    room = room_with("px4")
    room.run(0.3)
    room.tell(requests.origin_order(1, 45.0, 7.0, 0.0))
    steered = room.vehicle.autopilot.steered
    assert room.set_mode(steered) == Result.TEMPORARILY_REJECTED
    room.asked = VelocitySetpoint()
    room.run(0.1)
    assert room.set_mode(steered) == Result.ACCEPTED
    copter = room_with("arducopter")
    assert copter.order(CommandId.TAKE_OFF, *(0.0,) * 6, 1.0) == Result.FAILED
    assert copter.order(CommandId.SET_MODE, 1.0, 200.0) == Result.DENIED
    assert copter.order(CommandId.REQUEST, 148.0) == Result.UNSUPPORTED


def test_arducopter_flies_on_for_three_seconds_when_setpoints_end_and_then_stops() -> None:
    room = flying("arducopter")
    room.asked = None
    room.run(2.9)
    assert room.speed > 0.25
    took = room.run(3.0, lambda: room.speed < 0.05)
    assert 0.5 < took < 2.0, "measured on its own program: 0.94 to 0.98 s"
    room.run(6.0)
    assert room.flight.airborne and room.vehicle.mode == room.vehicle.autopilot.steered.number


def test_arducopter_lands_five_seconds_after_the_last_heartbeat() -> None:
    room = flying("arducopter")
    room.asked, room.has_heartbeats = None, False
    took = room.run(8.0, lambda: room.vehicle.landed is Landed.LANDING)
    assert 4.0 <= took <= 5.2
    assert "GCS Failsafe" in room.said
    paused = room.run(6.0, lambda: room.flight is FlightState.LANDING)
    assert 3.8 <= paused <= 4.2, "LAND_WITH_DELAY_MS"
    room.run(10.0, lambda: not room.vehicle.armed)
    assert room.flight is FlightState.LANDED


def test_whoever_takes_arducopter_in_its_pause_before_a_landing_has_it() -> None:
    room = flying("arducopter")
    room.asked, room.has_heartbeats = None, False
    room.run(8.0, lambda: room.vehicle.landed is Landed.LANDING)
    room.has_heartbeats, room.asked = True, VelocitySetpoint()
    room.run(1.5)
    assert room.set_mode(room.vehicle.autopilot.steered) == 0
    room.run(5.0)
    assert room.flight.airborne and room.vehicle.landed is Landed.IN_AIR


def test_px4_lands_a_second_after_the_last_setpoint() -> None:
    room = flying("px4")
    room.asked = None
    took = room.run(3.0, lambda: room.vehicle.landed is Landed.LANDING)
    assert 0.95 <= took <= 1.2
    room.run(10.0, lambda: not room.vehicle.armed)
    assert room.flight is FlightState.LANDED


@pytest.mark.parametrize(("model", "after"), [("arducopter", 8.0), ("px4", 5.0)])
def test_without_poses_it_reckons_for_a_while_and_lands(model: str, after: float) -> None:
    room = flying(model)
    room.asked, room.has_poses = VelocitySetpoint(), False
    took = room.run(12.0, lambda: room.vehicle.landed is Landed.LANDING)
    assert after - 0.1 <= took <= after + 0.3
    assert any("EKF" in text for text in room.said)


def test_cut_it_falls_and_can_be_armed_again_once_it_lies_still() -> None:
    room = flying("arducopter")
    assert room.tell(requests.arming(TARGET, False, by_force=True))[0].result == 0
    room.asked = None
    room.run(1.5)
    assert room.height < 0.3 and not room.vehicle.armed
    assert room.order(CommandId.ARM, 1.0) == Result.ACCEPTED


def test_its_parameters_are_told_and_set_and_decide_what_it_does() -> None:
    room = room_with("px4")
    (told,) = room.tell(requests.parameter_request(TARGET, "COM_OBL_RC_ACT"))
    assert told.param_id == "COM_OBL_RC_ACT"
    assert room.tell(requests.parameter_request(TARGET, "NO_SUCH")) == []
    assert len(room.tell(dialect().MAVLink_param_request_list_message(*TARGET))) > 5
    room.tell(dialect().MAVLink_param_set_message(*TARGET, b"COM_OF_LOSS_T", 0.5, 9))
    assert room.vehicle.parameters["COM_OF_LOSS_T"] == 0.5
