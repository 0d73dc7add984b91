"""What a MAVLink vehicle is told, and when; told by orders, not by bytes."""

from __future__ import annotations

from dataclasses import dataclass, field

import pytest

from housefly.drones.mavlink.checks import Checks
from housefly.drones.mavlink.orders import Deed, Order, Orders
from housefly.drones.mavlink.vehicle import Vehicle
from housefly.messages import Action, Command, DroneStatus, VelocitySetpoint
from housefly.messages.steering import Instruction, flying
from housefly.wires.mavlink.autopilots import AUTOPILOTS
from housefly.wires.mavlink.reports import (
    Answer,
    AttitudeReport,
    ChargeReport,
    Heartbeat,
    Landed,
    LandedReport,
    OriginReport,
    ParameterReport,
    Result,
    Said,
    SystemState,
)
from housefly.wires.mavlink.requests import CommandId

COPTER, PX4 = AUTOPILOTS["arducopter"], AUTOPILOTS["px4"]
AHEAD = VelocitySetpoint(forward=0.4)


@dataclass
class Told:
    """A vehicle, and what it is told in each step of 50 ms."""

    model: str
    now: float = 10.0
    mode: int = 0
    armed: bool = False
    landed: Landed = Landed.ON_GROUND
    vehicle: Vehicle = field(init=False)
    orders: Orders = field(init=False)

    def __post_init__(self) -> None:
        self.vehicle = Vehicle(AUTOPILOTS[self.model])
        self.orders = Orders(self.vehicle)

    def hear(self) -> None:
        number = self.vehicle.autopilot.number
        heartbeat = Heartbeat(number, self.mode, self.armed, SystemState.ACTIVE)
        for report in (heartbeat, LandedReport(self.landed), AttitudeReport((0, 0, 0), self.now)):
            self.vehicle.hear(report, self.now)

    def step(self, command: Command, seconds: float = 0.05, lands_all: bool = False) -> list[Order]:
        """Hear it, and return what it is told in this time."""
        orders, end = [], self.now + seconds
        while self.now < end - 1e-9:
            self.hear()
            told = Instruction(command, 1, self.now, lands_all)
            orders += self.orders.due(told, self.now)
            self.now += 0.05
        return orders


TAKE_OFF, LAND, IDLE = Command(Action.TAKE_OFF), Command(Action.LAND), Command(Action.IDLE)


def flying_copter(model: str = "arducopter") -> Told:
    told = Told(model, mode=AUTOPILOTS[model].steered.number, armed=True, landed=Landed.IN_AIR)
    told.step(flying(AHEAD), 1.0)
    return told


def test_arducopter_is_set_to_guided_armed_and_told_to_take_off_and_nothing_else() -> None:
    told = Told("arducopter")
    assert told.step(TAKE_OFF, 0.3) == [COPTER.steered], "and not again at once"
    told.mode = COPTER.steered.number
    assert told.step(TAKE_OFF, 0.3) == [Deed.ARM]
    told.armed = True
    assert told.step(TAKE_OFF, 0.3) == [Deed.TAKE_OFF]
    told.landed = Landed.TAKING_OFF
    assert told.step(TAKE_OFF, 0.5) == [], "a setpoint would end its take-off"
    told.landed = Landed.IN_AIR
    assert told.step(flying(AHEAD), 0.1) == [AHEAD, AHEAD]


def test_px4_hears_setpoints_for_a_while_before_it_is_asked_for_offboard() -> None:
    told = Told("px4", mode=PX4.ready.number)
    first = told.step(TAKE_OFF, 0.1)
    assert Deed.ARM in first and VelocitySetpoint() in first
    told.armed = True
    assert Deed.TAKE_OFF in told.step(TAKE_OFF, 0.1)
    told.landed, told.mode = Landed.TAKING_OFF, next(iter(PX4.passing - {PX4.ready.number}))
    assert set(told.step(TAKE_OFF, 1.0)) == {VelocitySetpoint()}
    told.landed, told.mode = Landed.IN_AIR, PX4.ready.number
    assert told.step(flying(AHEAD)) == [AHEAD, PX4.steered]
    told.mode = PX4.steered.number
    assert told.step(flying(AHEAD)) == [AHEAD]
    fresh = flying_copter("px4")
    fresh.step(LAND, 2.0)
    early = fresh.step(flying(AHEAD), 0.5)
    assert PX4.steered not in early, "the stream has only begun"


def test_an_order_whose_effect_does_not_show_is_repeated_twice_a_second() -> None:
    told = flying_copter()
    assert told.step(LAND, 2.0) == [COPTER.landing] * 4
    told.mode = COPTER.landing.number
    assert told.step(LAND, 2.0) == []


@pytest.mark.parametrize("model", AUTOPILOTS)
def test_who_takes_it_by_another_mode_keeps_it_until_it_is_down_but_the_motors_can_be_cut(
    model: str,
) -> None:
    told = flying_copter(model)
    told.mode = 5 if model == "arducopter" else PX4.ready.number
    for command in (flying(AHEAD), Command(Action.HOVER), LAND, IDLE):
        assert told.step(command, 1.0, lands_all=True) == []
    assert told.orders.is_taken(told.now)
    assert told.step(Command(Action.CUT)) == [Deed.CUT]
    told.landed, told.armed = Landed.ON_GROUND, False
    told.step(IDLE)
    assert not told.orders.is_taken(told.now)


def test_its_own_failsafe_that_lands_it_is_not_called_back() -> None:
    told = flying_copter()
    told.mode, told.landed = COPTER.landing.number, Landed.LANDING
    assert told.step(flying(AHEAD), 1.0) == []


def test_what_we_armed_and_did_not_fly_is_disarmed_and_what_others_armed_is_not() -> None:
    told = Told("arducopter", mode=4)
    told.step(TAKE_OFF)
    told.armed = True
    assert told.step(IDLE, 0.2) == [Deed.DISARM]
    other = Told("arducopter", mode=0, armed=True)
    assert other.step(IDLE, 1.0) == []


def test_where_nobody_knows_whether_it_flies_it_is_told_to_land_all_the_same() -> None:
    told = Told("arducopter", landed=Landed.UNKNOWN, armed=True)
    assert told.vehicle.status(told.now) is DroneStatus.UNKNOWN
    assert told.step(LAND) == [COPTER.landing]
    assert told.step(IDLE, 0.2) == []
    assert Told("arducopter", landed=Landed.UNKNOWN, armed=True).step(IDLE, lands_all=True) == [
        COPTER.landing
    ]


def test_a_refusal_is_told_in_the_autopilots_own_words_for_as_long_as_it_lasts() -> None:
    told = Told("arducopter")
    refusals = told.vehicle.refusals
    told.vehicle.hear(Said(2, "Arm: Need Position Estimate"), 10.0)
    told.vehicle.hear(Said(6, "EKF3 IMU0 initialised"), 10.0)
    told.vehicle.hear(Answer(CommandId.ARM, Result.FAILED), 10.1)
    assert refusals.told(10.2) == ("the drone will not arm: Arm: Need Position Estimate",)
    told.vehicle.hear(Answer(CommandId.ARM, Result.ACCEPTED), 11.0)
    assert refusals.told(11.0) == ("Arm: Need Position Estimate",), "a warning still"
    assert refusals.told(20.0) == ()
    told.vehicle.hear(Answer(CommandId.SET_MODE, Result.DENIED), 21.0)
    assert refusals.told(21.0) == ("the drone will not change its mode: denied",)
    told.vehicle.hear(Said(3, "x" * 50, series=7, piece=0), 30.0)
    assert refusals.told(30.0) == ()
    told.vehicle.hear(Said(3, "end", series=7, piece=1), 30.0)
    assert refusals.told(30.0) == ("x" * 50 + "end",)


def test_what_must_be_set_is_asked_for_and_named_with_what_is_allowed() -> None:
    vehicle = Vehicle(COPTER)
    checks = Checks(vehicle, "10.0.0.5")
    assert not checks.is_done and "FS_GCS_ENABLE" in checks.notes[0]
    vehicle.hear(Heartbeat(3, 4, False, SystemState.STANDBY), 1.0)
    checks.pose_sent_at = 1.0
    asked = [message.get_type() for message in checks.due((1, 1), 1.0)]
    assert asked.count("PARAM_REQUEST_READ") == len(COPTER.needs)
    assert "SET_GPS_GLOBAL_ORIGIN" in asked and asked.count("COMMAND_LONG") == 5
    for need in COPTER.needs:
        value = 0.0 if need.name == "FS_GCS_ENABLE" else need.least
        vehicle.hear(ParameterReport(need.name, value, value), 1.0)
    vehicle.hear(OriginReport(), 1.0)
    vehicle.hear(ChargeReport(0.9), 1.0)
    assert checks.notes == (
        "set FS_GCS_ENABLE to 5 on the drone (it is 0): it flies on when the ground falls silent",
    )
    vehicle.hear(ParameterReport("FS_GCS_ENABLE", 5.0, 0.0), 1.0)
    assert checks.is_done
    vehicle.hear(Heartbeat(12, 4, False, SystemState.STANDBY), 1.0)
    assert checks.notes == (
        "what answers at 10.0.0.5 does not speak ArduCopter (MAV_AUTOPILOT 12)",
    )


def test_one_that_starts_anew_is_asked_for_everything_again() -> None:
    vehicle = Vehicle(COPTER)
    vehicle.hear(AttitudeReport((0.0, 0.0, 0.0), 100.0), 1.0)
    vehicle.hear(OriginReport(), 1.0)
    vehicle.hear(ParameterReport("FS_GCS_ENABLE", 5.0, 0.0), 1.0)
    vehicle.hear(AttitudeReport((0.0, 0.0, 0.0), 3.0), 2.0)
    assert vehicle.restarts == 1 and not vehicle.has_origin and not vehicle.parameters


def test_a_heading_that_it_takes_over_from_our_poses_is_no_turn_of_its_own() -> None:
    vehicle, told = Vehicle(PX4), []
    headings = (0.0, 0.01, 3.1, 3.12, -3.13, -3.1)
    for number, heading in enumerate(headings):
        vehicle.hear(AttitudeReport((0.0, 0.0, heading), 5.0 + 0.02 * number), 1.0)
        report = vehicle.report(1.0, configured=True, notes=())
        assert report is not None
        told.append(report.psi)
    assert told == pytest.approx([0.0, 0.01, 0.01, 0.03, 0.0631853, 0.0931853], abs=1e-6)


def test_what_was_cut_by_order_is_an_emergency_until_a_reset_or_somebody_arms_it() -> None:
    told = flying_copter()
    assert told.step(Command(Action.CUT)) == [Deed.CUT]
    assert told.vehicle.status(told.now) is DroneStatus.FLYING, "not yet"
    told.armed, told.landed = False, Landed.ON_GROUND
    told.step(IDLE)
    assert told.vehicle.status(told.now) is DroneStatus.EMERGENCY
    told.step(Command(Action.RESET))
    assert told.vehicle.status(told.now) is DroneStatus.LANDED
    told.step(Command(Action.CUT))
    assert told.vehicle.status(told.now) is DroneStatus.EMERGENCY
    told.armed = True
    told.step(IDLE)
    told.armed = False
    told.step(IDLE)
    assert told.vehicle.status(told.now) is DroneStatus.LANDED


def test_what_it_said_long_ago_of_flying_says_nothing_now() -> None:
    told = flying_copter()
    assert told.vehicle.status(told.now) is DroneStatus.FLYING
    told.vehicle.hear(
        Heartbeat(COPTER.number, COPTER.steered.number, True, SystemState.ACTIVE), told.now + 3.5
    )
    assert told.vehicle.status(told.now + 3.5) is DroneStatus.UNKNOWN


def test_an_origin_that_arducopter_forgot_as_its_estimator_began_is_set_again() -> None:
    vehicle = Vehicle(COPTER)
    checks = Checks(vehicle, "10.0.0.5")

    def asked(now: float, *, answers: bool) -> set[str]:
        vehicle.hear(Heartbeat(COPTER.number, 4, vehicle.armed, SystemState.STANDBY), now)
        checks.pose_sent_at = now
        sent = {message.get_type() for message in checks.due((1, 1), now)}
        if answers:
            vehicle.hear(OriginReport(), now)
        return sent

    assert "SET_GPS_GLOBAL_ORIGIN" in asked(10.0, answers=True)
    told = [asked(10.5 + 0.5 * step, answers=step < 8) for step in range(20)]
    assert all("SET_GPS_GLOBAL_ORIGIN" not in sent for sent in told[:8])
    assert "SET_GPS_GLOBAL_ORIGIN" in told[-1] and not vehicle.has_origin
    vehicle.hear(OriginReport(), 30.0)
    vehicle.armed = True
    assert "SET_GPS_GLOBAL_ORIGIN" not in asked(40.0, answers=False) and vehicle.has_origin
