"""What the simulated Crazyflie does, as its firmware's sources say: in stepped time, no wire.

The real firmware, run in the loop, did the same: level for two seconds of silence, then motors
off, and on the floor half a second later from a metre.
"""

from __future__ import annotations

from math import dist, hypot, inf

import pytest

from housefly.config.site import Site
from housefly.geometry import euler_from_quaternion, quaternion_from_euler, rotate, wrap_angle
from housefly.room.files import load_room
from housefly.twin.contracts import FlightState
from housefly.twin.crazyflie.firmware import CrazyflieFirmware
from housefly.twin.crazyflie.supervisor import SupervisorState
from housefly.twin.world import SimulatedWorld
from housefly.wires.crazyflie.high_level import GoTo, Land, StopTrajectory, TakeOff
from housefly.wires.crazyflie.localization import ToldPose
from housefly.wires.crazyflie.setpoints import (
    AltHold,
    FullState,
    GenericSetpoint,
    Hover,
    Place,
    Stop,
    WorldVelocity,
    ZDistance,
)
from housefly.wires.crazyflie.supervisor import SupervisorInfo

PERIOD = 0.01


class Stepped:
    """A world whose drone is told where it is, and given setpoints, in stepped time."""

    def __init__(self, seed: int = 1) -> None:
        site = Site(drone={"kind": "crazyflie"}, twin={"seed": seed})
        self.world = SimulatedWorld(site, load_room(site.room.model))
        firmware = self.world.first.firmware
        assert isinstance(firmware, CrazyflieFirmware)
        self.firmware, self.tracked = firmware, True

    @property
    def place(self) -> tuple[float, float, float]:
        return self.world.truth().pose.position

    @property
    def lean(self) -> float:
        phi, theta, _ = euler_from_quaternion(self.world.truth().pose.orientation)
        return hypot(phi, theta)

    def run(self, seconds: float, setpoint: GenericSetpoint | None = None) -> None:
        for _ in range(round(seconds / PERIOD)):
            if self.tracked:
                pose = self.world.truth().pose
                self.firmware.tell(ToldPose(pose.position, pose.orientation))
            if setpoint is not None:
                self.firmware.give(setpoint)
            self.world.advance(PERIOD)

    def hovering(self) -> Stepped:
        self.run(0.5)
        assert self.firmware.obey(TakeOff(1.0, 2.0)) == 0
        self.run(3.0)
        assert self.place[2] == pytest.approx(1.0, abs=0.03)
        return self


def test_a_stream_that_falls_silent_levels_out_and_then_the_motors_are_off_for_good() -> None:
    room = Stepped().hovering()
    room.run(0.6, AltHold(0.0, 0.1, 0.0, 0.0))
    assert room.lean > 0.08
    room.run(0.45)
    assert room.lean > 0.08 and room.firmware.supervisor.state is SupervisorState.FLYING
    room.run(0.4)
    assert room.lean < 0.02 and room.firmware.supervisor.state is SupervisorState.LEVEL_OUT
    room.run(1.1)
    assert room.place[2] > 0.9
    room.run(0.8)
    assert room.place[2] < 0.1
    assert room.firmware.supervisor.state is SupervisorState.LOCKED
    assert room.world.onboard().flight is FlightState.EMERGENCY
    assert room.firmware.obey(TakeOff(1.0, 2.0)) == 0
    room.run(3.0)
    assert room.place[2] < 0.1, "it must be switched off and on first"


def test_its_own_commander_bears_any_silence() -> None:
    room = Stepped().hovering()
    start = room.place
    room.run(5.0)
    assert dist(room.place, start) < 0.03


def test_setpoints_go_before_its_own_commander_and_make_it_forget() -> None:
    room = Stepped().hovering()
    x, y, _ = room.place
    assert room.firmware.obey(GoTo((x + 1.0, y, 1.0), 0.0, 2.0)) == 0
    room.run(0.3)
    room.run(1.5, Place(x, y, 1.0, room.firmware.estimator.yaw))
    assert hypot(room.place[0] - x, room.place[1] - y) < 0.1
    assert SupervisorInfo.HIGH_LEVEL_ACTIVE not in room.firmware.info


def test_setpoints_that_stop_without_a_landing_ordered_before_cut_the_motors() -> None:
    room = Stepped().hovering()
    room.run(0.5, Place(*room.place, room.firmware.estimator.yaw))
    room.firmware.stop_setpoints()
    room.run(0.6)
    assert room.place[2] < 0.1


def test_a_landing_ordered_before_the_setpoints_stop_sinks_softly_and_ends_landed() -> None:
    room = Stepped().hovering()
    room.run(0.5, Place(*room.place, room.firmware.estimator.yaw))
    assert room.firmware.obey(Land(0.0, 2.5)) == 0
    assert room.firmware.obey(Land(0.0, 2.5)) == 1, "it lands already"
    room.firmware.stop_setpoints()
    fastest = 0.0
    for _ in range(60):
        room.run(0.1)
        fastest = max(fastest, -room.world.truth().velocity[2])
    assert fastest < 1.2 and room.place[2] < 0.03
    assert room.world.onboard().flight is FlightState.LANDED
    assert room.firmware.obey(TakeOff(1.0, 2.0)) == 0, "and it flies again"
    room.run(4.0)
    assert room.place[2] > 0.9


@pytest.mark.parametrize(
    ("setpoint", "moved"),
    [
        (AltHold(0.0, 0.1, 0.0, 0.0), (1.0, 0.0, 0.0)),
        (AltHold(0.1, 0.0, 0.0, 0.0), (0.0, -1.0, 0.0)),
        (AltHold(0.0, 0.0, 0.0, 0.4), (0.0, 0.0, 1.0)),
        (ZDistance(0.0, 0.1, 0.0, 1.0), (1.0, 0.0, 0.0)),
        (Hover(0.4, 0.0, 0.0, 1.0), (1.0, 0.0, 0.0)),
        (WorldVelocity(0.0, 0.4, 0.0, 0.0), None),
        (FullState((0.0, 0.0, 1.6), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)), None),
    ],
)
def test_each_setpoint_moves_it_as_it_says(
    setpoint: GenericSetpoint, moved: tuple[float, float, float] | None
) -> None:
    room = Stepped().hovering()
    start, pose = room.place, room.world.truth().pose
    if isinstance(setpoint, FullState):
        setpoint = FullState((start[0], start[1], 1.6), *((0.0, 0.0, 0.0),) * 2)
        room.run(2.0, setpoint)
        assert dist(room.place, setpoint.position) < 0.1
        return
    room.run(1.0, setpoint)
    way = [now - then for now, then in zip(room.place, start, strict=True)]
    if moved is None:
        assert way[1] > 0.15 and abs(way[0]) < 0.1
        return
    wanted = rotate(quaternion_from_euler(0.0, 0.0, pose.yaw), moved)
    along = sum(a * b for a, b in zip(way, wanted, strict=True))
    assert along > 0.15 and along > 0.8 * hypot(*way)


def test_a_full_state_is_faced_by_its_attitude_and_not_by_its_yaw_rate() -> None:
    room = Stepped().hovering()
    yaw = wrap_angle(room.world.truth().pose.yaw + 1.0)
    room.run(2.0, FullState(room.place, yaw=yaw, yaw_rate=-1.0))
    assert abs(wrap_angle(room.world.truth().pose.yaw - yaw)) < 0.1


def test_told_to_turn_it_turns_counter_clockwise() -> None:
    room = Stepped().hovering()
    before = room.world.truth().pose.yaw
    room.run(1.0, AltHold(0.0, 0.0, 0.5, 0.0))
    assert 0.3 < room.world.truth().pose.yaw - before < 0.6


def test_without_poses_it_drifts_and_with_them_it_does_not() -> None:
    room = Stepped(seed=3).hovering()
    believed = room.firmware.estimator
    assert dist(believed.position, room.place) < 0.02
    room.tracked = False
    room.run(6.0)
    assert dist(believed.position, room.place) > 0.1
    room.tracked = True
    room.run(1.0)
    assert dist(believed.position, room.place) < 0.05


def test_stop_and_the_commanders_own_stop_let_it_fall() -> None:
    for stop in (Stop(), StopTrajectory()):
        room = Stepped().hovering()
        if isinstance(stop, Stop):
            room.firmware.give(stop)
        else:
            room.firmware.obey(stop)
        room.run(0.6)
        assert room.place[2] < 0.1


def test_the_emergency_watchdog_stops_it_a_second_after_it_was_fed_last() -> None:
    room = Stepped().hovering()
    for _ in range(5):
        room.firmware.supervisor.feed_watchdog()
        room.run(0.8)
    assert room.place[2] > 0.9
    room.run(0.8)
    assert room.firmware.supervisor.state is SupervisorState.LOCKED
    room.world.toggle_emergency()
    room.run(0.5)
    assert room.firmware.supervisor.state is SupervisorState.READY


def test_its_battery_is_empty_after_five_minutes_of_hovering() -> None:
    room = Stepped().hovering()
    before = room.world.onboard().battery
    room.run(6.0)
    used = before - room.world.onboard().battery
    assert 6.0 / used == pytest.approx(300.0, rel=0.1)
    assert used < inf
