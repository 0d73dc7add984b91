"""Which lines leave for a Tello, and how often."""

from __future__ import annotations

from collections import Counter

import pytest

from housefly.drones.tello.talk import Talk
from housefly.messages import Action as A
from housefly.messages import Command, VelocitySetpoint
from housefly.messages import DroneStatus as S
from housefly.messages.steering import Instruction, flying
from housefly.wires.tello.answers import value
from housefly.wires.tello.conversions import FullSticks
from housefly.wires.tello.lines import Question, Sticks, Word

FULL = FullSticks(1.5, 0.45, 1.0)
AHEAD = flying(VelocitySetpoint(forward=0.75))


def said(
    command: Command,
    status: S,
    seconds: float = 2.0,
    *,
    state_age: float = 0.05,
    lands_all: bool = False,
    wants_pictures: bool = False,
) -> Counter:
    """Return how often each line leaves in some time, 30 turns a second; the SDK is known."""
    talk, told = Talk(FULL), Instruction(command, 1, 0.0, lands_all)
    talk.sdk = "20"
    seen: Counter = Counter()
    for turn in range(round(30 * seconds)):
        seen.update(
            talk.lines(
                told,
                status,
                10.0 + turn / 30,
                state_age=state_age,
                wants_pictures=wants_pictures,
            )
        )
    return seen


@pytest.mark.parametrize("status", [S.FLYING, S.UNKNOWN])
def test_sticks_leave_at_each_turn_also_before_anybody_knows_whether_it_flies(status):
    assert said(AHEAD, S.FLYING) == {Sticks(ahead=50): 60}
    for action in (A.HOVER, A.IDLE):
        assert said(Command(action), status) == {Sticks(): 60}


@pytest.mark.parametrize("status", [S.TAKING_OFF, S.LANDING])
def test_nothing_disturbs_a_take_off_or_a_landing_but_the_order_to_land(status):
    assert said(AHEAD, status, wants_pictures=True) == {}
    assert said(Command(A.TAKE_OFF), status) == {}
    assert said(Command(A.LAND), status) == {Word.LAND: 4}


def test_a_take_off_is_said_again_after_three_seconds_only():
    assert said(Command(A.TAKE_OFF), S.LANDED, 2.9) == {Word.TAKE_OFF: 1}
    assert said(Command(A.TAKE_OFF), S.LANDED, 3.2) == {Word.TAKE_OFF: 2}
    assert said(Command(A.TAKE_OFF), S.FLYING) == {Sticks(): 60}


def test_what_must_be_down_is_told_to_land_also_where_nobody_knows_whether_it_flies():
    assert said(AHEAD, S.UNKNOWN, lands_all=True) == {Word.LAND: 4}
    assert said(Command(A.LAND), S.LANDED) == {}


def test_motors_are_cut_ten_times_a_second_whatever_it_does():
    for status in S:
        assert said(Command(A.CUT), status)[Word.EMERGENCY] == 20


def test_a_silent_drone_is_greeted_twice_a_second_and_steered_all_the_same():
    assert said(AHEAD, S.FLYING, state_age=2.0) == {Word.COMMAND: 4, Sticks(ahead=50): 60}


def test_pictures_are_asked_for_until_they_come():
    assert said(Command(A.IDLE), S.LANDED, 4.5, wants_pictures=True) == {Word.STREAM_ON: 3}


def test_its_sdk_is_asked_for_until_it_answers_and_not_for_ever():
    talk, told = Talk(FULL), Instruction(Command(A.IDLE), 1, 0.0, False)

    def turn(now: float):
        return talk.lines(told, S.LANDED, now, state_age=0.0, wants_pictures=False)

    assert [len(turn(float(second))) for second in range(0, 20, 2)] == [1, 1, 1] + 7 * [0]
    talk.hear(value("30"))
    assert talk.sdk == "30"
    assert Question.SDK.value == "sdk?"
