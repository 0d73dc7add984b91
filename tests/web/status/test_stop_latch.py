"""STOP from the press to the pilot's own word, over restarts of the pilot."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.messages import (
    Action,
    Command,
    Inputs,
    Order,
    OrderKind,
    Outputs,
    PilotStep,
    SafetyMode,
)
from housefly.web.messages.verdict_message import StopProgress
from housefly.web.status.stop_latch import CONFIRM_TIMEOUT, StopLatch


def step(
    at: float, safety: SafetyMode = SafetyMode.NOMINAL, *orders: OrderKind, number: int = 0
) -> PilotStep:
    asked = tuple(Order(kind, sender="Anna") for kind in orders)
    return PilotStep(
        number, at, Inputs(orders=asked), Outputs(Command(Action.HOVER), safety=safety)
    )


def progress(latch: StopLatch, now: float) -> StopProgress:
    return latch.view(now, airborne=True, pilot_is_heard=True).progress


def test_stop_is_sent_then_confirmed_by_the_pilots_own_word_then_over() -> None:
    latch = StopLatch().pressed("Anna", 10.0)
    assert progress(latch, 10.1) is StopProgress.SENT
    latch = latch.heard(step(10.1))
    assert progress(latch, 10.2) is StopProgress.SENT, "an older step says nothing"
    latch = latch.heard(step(10.2, SafetyMode.STOPPED, OrderKind.STOP))
    assert progress(latch, 60.0) is StopProgress.CONFIRMED
    latch = latch.heard(step(61.0, SafetyMode.NOMINAL, OrderKind.RESUME))
    assert progress(latch, 61.0) is StopProgress.NONE


def test_stop_that_nobody_confirms_has_failed_and_is_sent_again() -> None:
    latch = StopLatch().pressed("Anna", 10.0)
    assert not latch.must_send(10.1) and latch.must_send(10.6)
    assert not latch.sent_again(10.6).must_send(10.7)
    late = 10.1 + CONFIRM_TIMEOUT
    assert progress(latch.sent_again(late), late) is StopProgress.FAILED
    assert progress(latch.acknowledged(), late) is StopProgress.CONFIRMED


def test_an_acknowledged_stop_of_a_pilot_that_is_gone_is_not_believed_for_long() -> None:
    latch = StopLatch().pressed("Anna", 10.0).acknowledged()
    assert progress(latch.heard(step(10.5)), 10.5) is StopProgress.CONFIRMED
    assert progress(latch.heard(step(12.0)), 12.0) is StopProgress.FAILED


def test_a_new_pilot_is_stopped_again() -> None:
    latch = StopLatch().pressed("Anna", 10.0).heard(step(10.1, SafetyMode.STOPPED))
    latch = latch.pilot_restarted(20.0).heard(step(20.1))
    assert progress(latch, 20.1) is StopProgress.SENT and latch.must_send(20.2)
    latch = latch.sent_again(20.2).heard(step(20.3, SafetyMode.STOPPED, OrderKind.STOP))
    assert progress(latch, 99.0) is StopProgress.CONFIRMED and latch.by == "Anna"


def test_a_landing_does_not_hide_that_stop_was_taken() -> None:
    latch = StopLatch().pressed("Anna", 10.0)
    latch = latch.heard(step(10.1, SafetyMode.LAND, OrderKind.STOP))
    latch = latch.heard(step(12.0, SafetyMode.LAND))
    assert progress(latch, 12.0) is StopProgress.CONFIRMED
    assert progress(latch.heard(step(13.0, SafetyMode.STOPPED)), 13.0) is StopProgress.CONFIRMED
    assert progress(latch.heard(step(13.0)), 13.0) is StopProgress.NONE


HAPPENINGS = st.lists(
    st.sampled_from(["press", "quiet step", "restart", "acknowledged", "later"]), max_size=30
)


@given(HAPPENINGS)
def test_only_a_pilot_that_was_stopped_and_is_no_more_releases_it(happenings: list[str]) -> None:
    latch, now, pressed = StopLatch(), 10.0, False
    for one in happenings:
        now += 2.0 if one == "later" else 0.01
        pressed |= one == "press"
        match one:
            case "press":
                latch = latch.pressed("Anna", now)
            case "quiet step":
                latch = latch.heard(step(now))
            case "restart":
                latch = latch.pilot_restarted(now)
            case "acknowledged":
                latch = latch.acknowledged()
        assert latch.holds == pressed
    if pressed:
        latch = latch.heard(step(now, SafetyMode.STOPPED)).heard(step(now + 0.01))
        assert not latch.holds
