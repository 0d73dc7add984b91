"""What other processes may tell the room's memory, and what they may not."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.bus.codec import from_cdr, to_cdr
from housefly.errors import WireError
from housefly.hub.api.told_events import (
    TOLD_EVENT_KINDS,
    TOLD_EVENT_SOURCE,
    checked_event,
)
from housefly.messages import RoomEvent

NOW = 1.7e9
EVENT = RoomEvent(
    "task ended",
    "ardrone",
    NOW,
    TOLD_EVENT_SOURCE,
    "task 1",
    facts=(("task", 1.0), ("words", "done"), ("ok", True)),
)

words = st.text(st.characters(exclude_categories=["C"]), min_size=1, max_size=60)


@given(
    st.sampled_from(sorted(TOLD_EVENT_KINDS)),
    words,
    st.floats(NOW - 299.0, NOW + 299.0),
    st.lists(st.tuples(words, words | st.booleans() | st.floats(-1e9, 1e9)), max_size=20),
)
def test_what_may_be_told_arrives_as_it_was_told(
    kind: str, thing: str, at: float, facts: list[tuple[str, str | float | bool]]
) -> None:
    event = RoomEvent(kind, thing, at, TOLD_EVENT_SOURCE, facts=tuple(facts))
    read = from_cdr(RoomEvent, to_cdr(event))
    assert repr(checked_event(read, NOW)) == repr(event)


@pytest.mark.parametrize(
    ("event", "why"),
    [
        (replace(EVENT, kind="bell pressed"), "cannot be told"),
        (replace(EVENT, source="doorbell"), "allowed: tasks"),
        (replace(EVENT, at=NOW - 301.0), "from now"),
        (replace(EVENT, at=NOW + 301.0), "from now"),
        (replace(EVENT, confidence=1.5), "0 to 1"),
        (replace(EVENT, thing=""), "no event"),
        (replace(EVENT, thing="a\nb"), "no event"),
        (replace(EVENT, cause="x" * 201), "no event"),
        (replace(EVENT, facts=(("words", "x" * 201),)), "no event"),
        (replace(EVENT, facts=tuple((f"f{n}", 1.0) for n in range(21))), "no event"),
        (replace(EVENT, facts=(("weight", float("nan")),)), "no event"),
    ],
)
def test_nobody_tells_other_things_at_other_times_or_at_length(event: RoomEvent, why: str) -> None:
    with pytest.raises(WireError, match=why):
        checked_event(event, NOW)
