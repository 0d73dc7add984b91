"""Whether a Tello flies, told by the seconds of its motors, its answers, and what it was told."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.drones.tello.flight_watch import (
    MOTORS_STAND_AFTER,
    TAKE_OFF_TIME_MAX,
    FlightWatch,
)
from housefly.messages import DroneStatus as S
from housefly.wires.tello.answers import DONE, refusal
from housefly.wires.tello.lines import Word
from housefly.wires.tello.state import TelloState


def state(motors: float, tof: int) -> TelloState:
    return TelloState(pitch=0, roll=0, yaw=0, tof=tof, h=0, bat=50, time=int(motors))


class Drone:
    """Sends ten states a second to a watch, and remembers what it makes of them."""

    def __init__(self) -> None:
        self.watch, self.now, self.motors = FlightWatch(), 100.0, 7.3

    def lasts(self, seconds: float, *, turns: bool, tof: int) -> set[S]:
        seen = set()
        for _ in range(round(10 * seconds)):
            self.now += 0.1
            self.motors += 0.1 if turns else 0.0
            self.watch.see(state(self.motors, tof), self.now)
            seen.add(self.watch.status())
        return seen


def test_before_its_seconds_could_count_nobody_knows_and_then_it_stands():
    drone = Drone()
    assert drone.watch.status() is S.UNKNOWN
    assert drone.lasts(1.2, turns=False, tof=10) == {S.UNKNOWN}
    drone.lasts(0.4, turns=False, tof=10)
    assert drone.lasts(5.0, turns=False, tof=10) == {S.LANDED}


def test_one_that_is_found_in_the_air_is_known_within_a_second_of_its_motors():
    drone = Drone()
    drone.lasts(1.1, turns=True, tof=90)
    assert drone.lasts(30.0, turns=True, tof=90) == {S.FLYING}


def test_a_whole_flight():
    drone = Drone()
    drone.lasts(3.0, turns=False, tof=10)
    drone.watch.sent(Word.TAKE_OFF, drone.now)
    drone.watch.hear(DONE, drone.now)  # a late answer to something else
    assert drone.lasts(1.1, turns=True, tof=10) <= {S.LANDED, S.TAKING_OFF}
    assert drone.lasts(3.0, turns=True, tof=60) == {S.TAKING_OFF}
    drone.watch.hear(DONE, drone.now)
    assert drone.lasts(4.0, turns=True, tof=90) == {S.FLYING}
    drone.watch.sent(Word.LAND, drone.now)
    assert drone.lasts(2.0, turns=True, tof=50) == {S.LANDING}
    drone.lasts(0.2, turns=True, tof=10)
    drone.watch.hear(DONE, drone.now)
    assert drone.lasts(5.0, turns=False, tof=10) == {S.LANDED}


def test_an_answer_that_is_lost_costs_only_time():
    drone = Drone()
    drone.lasts(3.0, turns=False, tof=10)
    drone.watch.sent(Word.TAKE_OFF, drone.now)
    drone.lasts(TAKE_OFF_TIME_MAX, turns=True, tof=90)
    drone.lasts(0.2, turns=True, tof=90)
    assert drone.lasts(1.0, turns=True, tof=90) == {S.FLYING}
    drone.watch.sent(Word.LAND, drone.now)
    assert drone.lasts(3.0, turns=True, tof=40) == {S.LANDING}
    drone.lasts(MOTORS_STAND_AFTER + 1.1, turns=False, tof=10)
    assert drone.lasts(1.0, turns=False, tof=10) == {S.LANDED}


def test_a_refused_take_off_stays_down_and_says_why():
    drone = Drone()
    drone.lasts(3.0, turns=False, tof=10)
    drone.watch.sent(Word.TAKE_OFF, drone.now)
    drone.watch.hear(refusal("No valid imu"), drone.now)
    assert drone.lasts(5.0, turns=False, tof=10) == {S.LANDED}
    assert drone.watch.refusal == "error No valid imu"
    drone.watch.sent(Word.TAKE_OFF, drone.now)
    assert drone.watch.refusal == ""


def test_a_drone_that_lands_by_itself_is_down_once_its_motors_stand():
    drone = Drone()
    drone.lasts(5.0, turns=True, tof=90)
    drone.lasts(MOTORS_STAND_AFTER + 1.1, turns=False, tof=10)
    assert drone.lasts(2.0, turns=False, tof=10) == {S.LANDED}


def test_cut_motors_are_an_emergency_until_it_is_reset():
    drone = Drone()
    drone.lasts(5.0, turns=True, tof=90)
    drone.watch.sent(Word.EMERGENCY, drone.now)
    assert drone.lasts(5.0, turns=False, tof=10) == {S.EMERGENCY}
    drone.watch.reset()
    assert drone.lasts(1.0, turns=False, tof=10) == {S.LANDED}


@given(st.lists(st.tuples(st.booleans(), st.integers(0, 3), st.integers(0, 200)), max_size=60))
def test_turning_motors_are_never_called_standing_for_longer_than_a_second_lasts(events):
    drone = Drone()
    drone.lasts(2.0, turns=True, tof=90)
    for is_told, which, tof in events:
        if is_told:
            drone.watch.sent((Word.TAKE_OFF, Word.LAND, Word.COMMAND, Word.STOP)[which], drone.now)
        drone.lasts(0.3, turns=True, tof=tof)
        assert drone.watch.status() in (S.FLYING, S.TAKING_OFF, S.LANDING)


@given(st.lists(st.booleans(), min_size=200, max_size=400), st.floats(0.0, 0.99))
def test_states_that_are_lost_never_bring_down_a_drone_that_flies(heard, phase):
    drone = Drone()
    drone.motors = 7.0 + phase
    drone.lasts(1.5, turns=True, tof=90)
    for is_heard in heard:
        drone.now += 0.1
        drone.motors += 0.1
        if is_heard:
            drone.watch.see(state(drone.motors, 90), drone.now)
        assert drone.watch.status() is S.FLYING


def test_states_that_come_in_one_burst_after_a_stall_never_bring_it_down_either():
    drone = Drone()
    drone.lasts(3.0, turns=True, tof=90)
    waiting = []
    for _ in range(25):
        drone.now += 0.1
        drone.motors += 0.1
        waiting.append(state(drone.motors, 90))
    for one in waiting:
        drone.watch.see(one, drone.now)
        assert drone.watch.status() is S.FLYING
