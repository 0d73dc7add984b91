"""Why the drone landed stands in the log also of a console that was away then."""

from __future__ import annotations

from housefly.clock import SteppedClock
from housefly.hub.api.answers import EventAnswer
from housefly.messages import Severity
from housefly.messages.words import Words, literal
from housefly.web.messages.server_messages import EventView
from housefly.web.status.missed_events import missed_events
from housefly.web.status.state_feed import StateFeed
from housefly.web.status.stop_latch import StopLatch

OFFSET = 1.7e9
"""Unix time at which the console's clock was zero [s]."""
LANDED = Words("battery {p}%: landing", p="14")


def told(at: float, words: Words, kind: str = "battery low", source: str = "pilot") -> EventAnswer:
    facts = {"severity": "warning", "words": str(words)} if source == "pilot" else {}
    return EventAnswer(kind, "ardrone", OFFSET + at, source, "", 1.0, dict(facts), words)


def test_what_the_memory_heard_meanwhile_is_in_the_log_at_its_own_time() -> None:
    clock = SteppedClock(100.0)
    feed = StateFeed(clock, "ardrone")
    kept = (EventView(7, 60.0, Severity.INFO, "order_accepted", literal("Home")),)
    feed.restore(kept, StopLatch())
    memory = (
        told(59.9, literal("Home"), "order accepted"),
        told(75.0, LANDED),
        told(76.0, literal("looking"), "looking", source="hub"),
        EventAnswer("flight ended", "ardrone", OFFSET + 80.0, "pilot", "", 1.0, {}),
    )
    feed.recall(missed_events(memory, feed.events_after(0), OFFSET))
    log = feed.events_after(0)
    assert [(one.number, one.at, one.code) for one in log] == [
        (7, 60.0, "order_accepted"),
        (8, 75.0, "battery_low"),
    ]
    assert log[1].text == LANDED and log[1].severity is Severity.WARNING
    assert missed_events(memory, log, OFFSET) == ()


def test_the_same_words_at_another_time_are_another_event() -> None:
    known = (EventView(1, 60.0, Severity.WARNING, "battery_low", LANDED),)
    found = missed_events((told(70.0, LANDED),), known, OFFSET)
    assert [one.at for one in found] == [70.0]
