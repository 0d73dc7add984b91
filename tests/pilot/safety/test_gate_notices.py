from __future__ import annotations

from housefly.messages import Action, Command, SafetyMode, Severity
from housefly.pilot.safety.gate import GateNotices, GateVerdict

HOVER = Command(Action.HOVER)
CLEAR = GateVerdict(HOVER, SafetyMode.NOMINAL)
LEVEL = GateVerdict(HOVER, SafetyMode.LEVEL, "tracking_old", "old")
LAND = GateVerdict(HOVER, SafetyMode.LAND, "tracking_lost", "lost")


def test_a_trouble_is_told_at_once_and_its_end_when_it_has_lasted() -> None:
    notices = GateNotices()
    assert [event.code for event in notices.after(LEVEL, 1.0)] == ["tracking_old"]
    assert notices.after(LEVEL, 1.5) == ()
    assert notices.after(CLEAR, 2.0) == ()
    assert [event.code for event in notices.after(CLEAR, 3.0)] == ["safety_clear"]
    assert notices.after(CLEAR, 9.0) == ()


def test_a_trouble_that_comes_and_goes_is_told_once() -> None:
    notices = GateNotices()
    told = [
        event for n in range(100) for event in notices.after(LEVEL if n % 4 < 2 else CLEAR, 0.1 * n)
    ]
    assert len(told) == 1


def test_a_worse_trouble_is_told_although_another_is_known() -> None:
    notices = GateNotices()
    notices.after(LEVEL, 1.0)
    (worse,) = notices.after(LAND, 2.0)
    assert worse.severity is Severity.FAULT and worse.text == "lost"
