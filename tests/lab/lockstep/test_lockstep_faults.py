"""Faults in the simulated room without wires: links, reports, pilot, body, people in the way."""

from __future__ import annotations

from collections.abc import Callable
from math import hypot, isnan

import pytest
from kinematic_world import KinematicWorld

from housefly.config.site import Site, changed
from housefly.errors import ConfigError
from housefly.lab.lockstep.lockstep_room import LockstepRoom
from housefly.messages import Action, Command, DroneStatus, Setpoint, Telemetry
from housefly.room.model import Room
from housefly.twin.disturbance import Motor
from housefly.twin.faults.fault_types import FAULT_TYPES
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.faults.parse import parse_fault
from housefly.twin.faults.physical import disturb_of
from housefly.twin.faults.vocabulary import Injection
from housefly.twin.world import SimulatedWorld
from housefly.wires.ardrone.config import COM_WATCHDOG_TIME

MakeFaulty = Callable[..., tuple[SimulatedWorld, LockstepRoom]]
AIRBORNE_AT = 6.0


@pytest.fixture
def faulty(make_room: Callable[..., Room]) -> MakeFaulty:
    def make(*faults: str, **values: object) -> tuple[SimulatedWorld, LockstepRoom]:
        entries = [{"fault": fault} for fault in faults]
        site = changed(Site(), faults=entries, limits__tilt_max=0.3, **values)
        injector = FaultInjector(site)
        world = SimulatedWorld(site, make_room(), None, injector.movables, injector.people)
        return world, LockstepRoom(world, site, injector)

    return make


def keep(room: LockstepRoom, command: Command, seconds: float) -> list[Telemetry | None]:
    """Order the same thing a hundred times a second and return what the drone reports."""
    reports = []
    for _ in range(round(seconds * 100)):
        room.advance(0.01)
        reports.append(room.telemetry())
        room.send(command)
    return reports


def take_off(room: LockstepRoom) -> None:
    keep(room, Command(Action.IDLE), 0.2)
    keep(room, Command(Action.TAKE_OFF), AIRBORNE_AT - 0.2)


def course(make: MakeFaulty, *faults: str) -> list[tuple[object, ...]]:
    """Return everything that is told and true in a flight."""
    world, room = make(*faults)
    found: list[tuple[object, ...]] = []
    for command, seconds in (
        (Command(Action.TAKE_OFF), 5.0),
        (Command(Action.FLY, Setpoint(theta=0.05, yaw_rate=0.3)), 1.5),
        (Command(Action.HOVER), 1.0),
    ):
        for _ in range(round(seconds * 100)):
            room.advance(0.01)
            found.append((room.telemetry(), room.sightings(), world.truth()))
            room.send(command)
    return found


def test_faults_that_never_begin_change_nothing_bit_for_bit(faulty: MakeFaulty) -> None:
    late = ("mocap:off", "telemetry:off", "commands:delayed", "wind:wrong", "pilot:off", "F33")
    assert course(faulty, *(f"{fault}@9000s" for fault in late)) == course(faulty)


def test_the_same_seed_gives_the_same_faulty_flight_and_another_seed_another(
    faulty: MakeFaulty,
) -> None:
    faults = ("commands:intermittent@1s=0.5#{}", "mocap:intermittent=0.3#{}", "wind:wrong@4s#{}")
    first, again, other = (
        course(faulty, *(fault.format(seed) for fault in faults)) for seed in (3, 3, 4)
    )
    assert first == again
    assert first != other


def test_a_silent_drone_keeps_its_last_report_and_then_speaks_again(faulty: MakeFaulty) -> None:
    _, room = faulty("telemetry:off@1s+1s")
    reports = keep(room, Command(Action.IDLE), 3.0)
    ages = [
        0.01 * (n + 1) - report.received_at
        for n, report in enumerate(reports)
        if report is not None
    ]
    assert len(ages) == 300
    assert max(ages[:99]) < 0.01 and max(ages[201:]) < 0.01
    assert ages[198] == pytest.approx(1.0, abs=0.02)


def test_a_drone_that_never_spoke_has_no_report(faulty: MakeFaulty) -> None:
    _, room = faulty("telemetry:off")
    assert keep(room, Command(Action.IDLE), 0.5) == [None] * 50


def test_late_reports_count_as_received_when_they_come(faulty: MakeFaulty) -> None:
    _, room = faulty("telemetry:delayed@6s=0.5")
    take_off(room)
    keep(room, Command(Action.HOVER), 1.0)
    before = room.telemetry()
    assert before is not None and before.received_at == pytest.approx(room.now, abs=0.011)
    reports = keep(room, Command(Action.LAND), 0.4)
    assert all(report is not None and report.status is DroneStatus.FLYING for report in reports)
    last = keep(room, Command(Action.LAND), 0.4)[-1]
    assert last is not None and last.status is DroneStatus.LANDING


@pytest.mark.parametrize(
    ("fault", "key", "off"),
    [("telemetry.yaw:wrong=0.5", "psi", 0.5), ("telemetry.height:wrong=0.3", "height", 0.3)],
)
def test_a_report_that_lies_is_off_by_its_size(
    faulty: MakeFaulty, fault: str, key: str, off: float
) -> None:
    lying, true = faulty(fault)[1], faulty()[1]
    for told, right in zip(
        keep(lying, Command(Action.TAKE_OFF), 2.0),
        keep(true, Command(Action.TAKE_OFF), 2.0),
        strict=True,
    ):
        assert getattr(told, key) - getattr(right, key) == pytest.approx(off)


def test_garbage_is_not_numbers_and_a_stuck_report_keeps_its_content(faulty: MakeFaulty) -> None:
    _, room = faulty("telemetry:garbage@1s+1s", "telemetry:stuck@3s")
    reports = keep(room, Command(Action.TAKE_OFF), 5.0)
    garbled, stuck = reports[150], reports[310:]
    assert garbled is not None and isnan(garbled.phi) and isnan(garbled.battery)
    assert len({(r.psi, r.height, r.velocity) for r in stuck if r is not None}) == 1
    assert len({r.received_at for r in stuck if r is not None}) > 150


@pytest.mark.parametrize("fault", ["commands:off@6s", "commands:garbage@6s"])
def test_a_drone_that_hears_nothing_flies_on_and_then_lands_by_itself(
    faulty: MakeFaulty, fault: str
) -> None:
    world, room = faulty(fault)
    take_off(room)
    assert world.onboard().flight.airborne
    keep(room, Command(Action.HOVER), COM_WATCHDOG_TIME - 0.1)
    assert not world.onboard().com_lost
    keep(room, Command(Action.HOVER), 0.5)
    assert world.onboard().com_lost
    keep(room, Command(Action.HOVER), 6.0)
    assert not world.onboard().flight.airborne


def test_late_commands_act_late_and_stuck_ones_go_on(faulty: MakeFaulty) -> None:
    def speed_of(*faults: str) -> float:
        world, room = faulty(*faults)
        take_off(room)
        keep(room, Command(Action.FLY, Setpoint(theta=0.1)), 0.5)
        keep(room, Command(Action.HOVER), 1.2)
        return hypot(*world.truth().velocity[:2])

    assert speed_of() < 0.15
    assert speed_of("commands:stuck@6.4s") > 0.6
    assert speed_of("commands:delayed@6.45s=1.0") > 0.4


@pytest.mark.parametrize(("fault", "heard"), [("copies", 1.0), ("order", 0.5)])
def test_copies_and_overtaken_datagrams_are_dropped(
    faulty: MakeFaulty, monkeypatch: pytest.MonkeyPatch, fault: str, heard: float
) -> None:
    def datagrams_heard(*faults: str) -> int:
        world, room = faulty(*faults)
        count = 0

        def keep_alive() -> None:
            nonlocal count
            count += 1

        monkeypatch.setattr(world, "keep_alive", keep_alive)
        keep(room, Command(Action.IDLE), 3.0)
        return count

    all_of_them = datagrams_heard()
    assert datagrams_heard(f"commands.{fault}:wrong=1") == pytest.approx(heard * all_of_them, abs=1)


def test_a_pilot_that_is_not_heard_lets_the_driver_hover_and_land(faulty: MakeFaulty) -> None:
    world, room = faulty("pilot:off@6.5s")
    take_off(room)
    keep(room, Command(Action.FLY, Setpoint(theta=0.05)), 2.2)
    assert world.onboard().flight.airborne
    keep(room, Command(Action.FLY, Setpoint(theta=0.05)), 8.0)
    assert not world.onboard().flight.airborne


def forward_speed(world: SimulatedWorld) -> float:
    return hypot(*world.truth().velocity[:2])


def test_a_late_pilot_acts_late_and_one_that_is_too_late_not_at_all(faulty: MakeFaulty) -> None:
    def speed_after(pause: float, *faults: str) -> float:
        world, room = faulty(*faults)
        take_off(room)
        keep(room, Command(Action.HOVER), 1.0)
        keep(room, Command(Action.FLY, Setpoint(theta=0.1)), pause)
        return forward_speed(world)

    assert speed_after(0.5) > 0.15
    assert speed_after(0.19, "pilot:delayed=0.2") < 0.02 < speed_after(0.19)
    assert speed_after(0.7, "pilot:delayed=0.2") == pytest.approx(speed_after(0.5), abs=0.05)
    assert speed_after(1.0, "pilot:delayed@7s=0.4") < 0.02, "what moves it and is late is refused"


def test_a_pilot_that_is_stuck_flies_on_by_its_last_command(faulty: MakeFaulty) -> None:
    world, room = faulty("pilot:stuck@6.5s")
    take_off(room)
    keep(room, Command(Action.FLY, Setpoint(theta=0.1)), 0.6)
    keep(room, Command(Action.HOVER), 1.4)
    assert forward_speed(world) > 0.6


@pytest.mark.parametrize(("rate", "lowest", "highest"), [(5.0, 0.35, 9.0), (0.5, 0.0, 0.3)])
def test_a_slow_pilot_flies_while_its_steps_come_before_the_watchdog(
    faulty: MakeFaulty, rate: float, lowest: float, highest: float
) -> None:
    world, room = faulty(f"pilot:slow@6.5s={rate}")
    take_off(room)
    keep(room, Command(Action.FLY, Setpoint(theta=0.1)), 0.5)
    keep(room, Command(Action.FLY, Setpoint(theta=0.1)), 1.0)
    assert lowest <= forward_speed(world) < highest


def test_a_pilot_without_numbers_is_one_that_is_not_heard(faulty: MakeFaulty) -> None:
    def last_of(fault: str) -> tuple[float, bool]:
        world, room = faulty(fault)
        take_off(room)
        keep(room, Command(Action.FLY, Setpoint(theta=0.05)), 1.5)
        speed = forward_speed(world)
        keep(room, Command(Action.FLY, Setpoint(theta=0.05)), 8.0)
        return speed, world.onboard().flight.airborne

    for fault in ("pilot:garbage@6.5s", "pilot:off@6.5s"):
        speed, airborne = last_of(fault)
        assert speed < 0.03 and not airborne, "it brakes, hovers and lands"
    speed, _ = last_of("pilot:garbage@100s")
    assert speed > 0.3, "it is flown on by a pilot that is well"


def test_every_motor_can_stand_still(faulty: MakeFaulty) -> None:
    names = [motor.name.lower() for motor in Motor]
    for number, name in enumerate(names):
        world, room = faulty(f"motor.{name}:off@1s")
        keep(room, Command(Action.IDLE), 1.1)
        gains = world.disturbances.motor_thrust
        assert [gain == 0.0 for gain in gains] == [place == number for place in range(4)]


def test_a_weak_motor_a_load_and_a_fan_act_on_the_body_while_they_last(faulty: MakeFaulty) -> None:
    world, room = faulty("motor.rear_left:wrong@1s+1s=0.6", "payload:wrong@1s+1s", "fan:wrong@1s")
    keep(room, Command(Action.IDLE), 0.9)
    assert world.disturbances.motor_thrust == (1.0,) * 4
    keep(room, Command(Action.IDLE), 0.5)
    now = world.disturbances
    assert now.motor_thrust == (1.0, 1.0, 1.0, 0.6)
    assert now.payload is not None and now.payload.mass == 0.05
    keep(room, Command(Action.IDLE), 1.0)
    assert world.disturbances.motor_thrust == (1.0,) * 4
    assert world.disturbances.payload is None
    assert world.disturbances.fan is not None
    assert world.disturbances.fan.place == pytest.approx((2.0, 2.5), abs=0.01)


def test_a_charge_falls_once_and_then_drains_on(faulty: MakeFaulty) -> None:
    world, room = faulty("battery:wrong@1s=0.5", "wind:wrong@2s")
    keep(room, Command(Action.IDLE), 0.9)
    assert world.onboard().battery > 0.99
    charges = []
    for seconds in (0.5, 0.5, 2.0):
        keep(room, Command(Action.IDLE), seconds)
        charges.append(world.onboard().battery)
    assert charges[0] == pytest.approx(0.5, abs=0.001)
    assert charges[1] - charges[2] == pytest.approx(4.0 * (charges[0] - charges[1]), rel=0.1)


def test_disturbances_of_somebody_else_stand_while_no_fault_is_physical(faulty: MakeFaulty) -> None:
    from housefly.twin.disturbance import Disturbances

    world, room = faulty("mocap:off@1s")
    world.disturb(Disturbances(wind=(1.0, 0.0, 0.0)))
    keep(room, Command(Action.IDLE), 2.0)
    assert world.disturbances.wind == (1.0, 0.0, 0.0)


def test_somebody_walks_up_and_a_chair_stands_where_it_was_put(faulty: MakeFaulty) -> None:
    world, room = faulty("people.walking:wrong@7s+2s=1.0", "obstacles:wrong@7s=1.0")
    take_off(room)
    keep(room, Command(Action.HOVER), 0.9)
    assert world.clearance().person > 100.0
    keep(room, Command(Action.HOVER), 0.2)
    gaps = []
    for _ in range(10):
        keep(room, Command(Action.HOVER), 0.1)
        gaps.append(world.clearance().person)
    assert gaps == sorted(gaps, reverse=True)
    assert gaps[0] - gaps[-1] == pytest.approx(0.9, abs=0.2)
    assert world.clearance().solid < 0.6
    keep(room, Command(Action.HOVER), 1.5)
    assert world.clearance().person > 100.0


def test_nobody_comes_to_the_pad_while_the_drone_stands_there(faulty: MakeFaulty) -> None:
    world, room = faulty("people.pad:wrong", "obstacles.pad:wrong")
    take_off(room)
    assert world.contact_log == ()
    assert world.clearance().person > 100.0
    keep(room, Command(Action.FLY, Setpoint(theta=0.08)), 3.0)
    assert world.clearance().person < 100.0


def test_nobody_can_be_put_in_the_way_of_a_room_that_has_nobody(faulty: MakeFaulty) -> None:
    _, room = faulty()
    with pytest.raises(ConfigError, match="somebody to put in the way"):
        room.inject(*parse_fault("F34@1s"))


def test_a_fault_for_wires_is_refused_in_lock_step_and_the_other_way_round() -> None:
    site = changed(Site(), faults=[{"fault": "video:off"}])
    with pytest.raises(ConfigError, match="cannot be made in lock step, only in wires"):
        FaultInjector(site)
    assert FaultInjector(site, Injection.WIRES).schedule.faults
    with pytest.raises(ConfigError, match="only in lock step"):
        FaultInjector(changed(Site(), faults=[{"fault": "F24"}]), Injection.WIRES)


def test_a_world_without_physics_refuses_faults() -> None:
    site = changed(Site(), faults=[{"fault": "wind:wrong"}])
    with pytest.raises(ConfigError, match="no physics"):
        LockstepRoom(KinematicWorld(), site).advance(0.01)


def test_every_type_that_is_physical_has_its_disturbance() -> None:
    physical = {"battery", "motor", "sonar", "flow", "imu", "wind", "fan", "payload", "tether"}
    for known in FAULT_TYPES:
        (fault,) = parse_fault(known.name)
        wanted = known.component.value in physical and known.name != "battery:garbage"
        assert (disturb_of(fault) is not None) == wanted, known.name
