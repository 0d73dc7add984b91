"""The world as the pilot's shell sees it when the wires are cut out."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from housefly.config.site import Site, changed
from housefly.lab.lockstep.lockstep_room import LockstepRoom
from housefly.messages import Action, Command, DroneFault, DroneStatus, Setpoint
from housefly.room.model import Room
from housefly.twin.contracts import FlightState
from housefly.twin.plain_drone import FLIGHT_STATUS
from housefly.twin.world import SimulatedWorld


@pytest.fixture
def site() -> Site:
    return changed(Site(), limits__tilt_max=0.3)


@pytest.fixture
def world(site: Site, make_room: Callable[..., Room]) -> SimulatedWorld:
    return SimulatedWorld(site, make_room())


@pytest.fixture
def room(world: SimulatedWorld, site: Site) -> LockstepRoom:
    return LockstepRoom(world, site)


def keep(room: LockstepRoom, command: Command, seconds: float) -> DroneStatus:
    """Order the same thing a hundred times a second, as the pilot does."""
    for _ in range(round(seconds * 100)):
        room.advance(0.01)
        room.send(command)
    return room.telemetry().status


def test_a_whole_flight_by_commands(room: LockstepRoom) -> None:
    assert keep(room, Command(Action.IDLE), 0.5) is DroneStatus.LANDED
    assert keep(room, Command(Action.TAKE_OFF), 1.0) is DroneStatus.TAKING_OFF
    assert keep(room, Command(Action.TAKE_OFF), 5.0) is DroneStatus.FLYING
    assert keep(room, Command(Action.FLY, Setpoint(theta=0.05)), 1.0) is DroneStatus.FLYING
    assert room.telemetry().velocity[0] > 0.2
    assert keep(room, Command(Action.HOVER), 1.0) is DroneStatus.FLYING
    assert keep(room, Command(Action.LAND), 1.0) is DroneStatus.LANDING
    assert keep(room, Command(Action.LAND), 6.0) is DroneStatus.LANDED
    assert keep(room, Command(Action.TAKE_OFF), 1.0) is DroneStatus.TAKING_OFF


@pytest.mark.parametrize(
    ("setpoint", "axis", "value"),
    [
        (Setpoint(theta=0.1), "theta", 0.1),
        (Setpoint(phi=-0.1), "phi", -0.1),
        (Setpoint(vz=0.3), "climb", 0.3),
        (Setpoint(yaw_rate=0.8), "turn", 0.8),
    ],
)
def test_a_setpoint_is_reached_with_its_own_sign_and_size(
    room: LockstepRoom, setpoint: Setpoint, axis: str, value: float
) -> None:
    keep(room, Command(Action.IDLE), 0.2)
    keep(room, Command(Action.TAKE_OFF), 7.0)
    keep(room, Command(Action.FLY, setpoint), 1.4)
    before = room.telemetry()
    keep(room, Command(Action.FLY, setpoint), 1.0)
    after = room.telemetry()
    told = {
        "theta": after.theta,
        "phi": after.phi,
        "climb": after.height - before.height,
        "turn": after.psi - before.psi,
    }
    assert told[axis] == pytest.approx(value, rel=0.2)


def test_cut_and_reset_toggle_only_when_needed(room: LockstepRoom) -> None:
    keep(room, Command(Action.TAKE_OFF), 6.0)
    assert keep(room, Command(Action.CUT), 0.2) is DroneStatus.EMERGENCY
    for _ in range(10):
        assert keep(room, Command(Action.CUT), 0.3) is DroneStatus.EMERGENCY
    assert keep(room, Command(Action.RESET), 0.2) is DroneStatus.LANDED
    for _ in range(10):
        assert keep(room, Command(Action.RESET), 0.3) is DroneStatus.LANDED


def test_a_silent_pilot_lets_the_drone_hover_then_land(room: LockstepRoom) -> None:
    keep(room, Command(Action.TAKE_OFF), 6.0)
    keep(room, Command(Action.FLY, Setpoint(theta=0.05)), 0.5)
    room.advance(0.4)
    assert room.telemetry().status is DroneStatus.FLYING
    room.advance(1.4)
    assert abs(room.telemetry().velocity[0]) < 0.15
    room.advance(0.4)
    assert room.telemetry().status is DroneStatus.LANDING
    room.advance(8.0)
    assert room.telemetry().status is DroneStatus.LANDED


def test_sightings_carry_both_times_and_come_once(room: LockstepRoom, site: Site) -> None:
    room.advance(1.0)
    sightings = room.sightings()
    assert len(sightings) == pytest.approx(98, abs=2)
    assert room.sightings() == ()
    assert all(
        s.body == site.tracking.body and 0.02 <= s.received_at - s.captured_at < 0.03
        for s in sightings
    )


def test_telemetry_is_new_every_five_milliseconds(room: LockstepRoom) -> None:
    times = set()
    for _ in range(200):
        room.advance(0.005)
        times.add(room.telemetry().received_at)
    assert len(times) == 200


def test_a_low_battery_is_told_in_words(site: Site, make_room: Callable[..., Room]) -> None:
    low = changed(site, twin__battery=0.05)
    room = LockstepRoom(SimulatedWorld(low, make_room()), low)
    room.advance(0.1)
    assert room.telemetry().faults == (DroneFault.BATTERY_LOW,)
    assert room.telemetry().battery == pytest.approx(0.05)


def test_every_state_of_the_firmware_has_a_word_for_the_pilot() -> None:
    assert set(FLIGHT_STATUS) == set(FlightState)
