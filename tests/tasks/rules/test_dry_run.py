from __future__ import annotations

import time
from collections.abc import Iterator
from datetime import UTC
from pathlib import Path

import pytest
from rule_bench import KnownRoom, make_rule

from housefly.config.house_mode import HouseMode
from housefly.hub.memory import RoomMemory
from housefly.hub.query_handler import QueryHandler
from housefly.hub.room_status import RoomStatus
from housefly.hub.store.open import open_store
from housefly.messages import RoomEvent
from housefly.tasks.api.values import ReasonCode
from housefly.tasks.rules import dry_run as module
from housefly.tasks.rules.dry_run import dry_run, stored_events
from housefly.tasks.rules.mode_event import mode_event
from housefly.tasks.rules.room_facts import AskedRoomFacts
from housefly.tasks.rules.rule import Rule
from housefly.tasks.rules.rule_engine import RuleEngine

WEEK_AGO = float(round(time.time())) // 86400.0 * 86400.0 - 7 * 86400.0
"""Midnight, UTC; what is older, the store may throw away."""
DAY = 86400.0


@pytest.fixture
def memory(tmp_path: Path) -> Iterator[RoomMemory]:
    made = RoomMemory((), lambda: open_store(tmp_path / "room.db"))
    yield made
    made.close()


def ring(memory: RoomMemory, at: float) -> None:
    memory.add(RoomEvent("bell pressed", "doorbell", WEEK_AGO + at, "doorbell"))


def codes(memory: RoomMemory, *rules: Rule, room: object = None) -> list[tuple[float, str, str]]:
    answers = QueryHandler(memory, RoomStatus(memory.writer.report), time.time)
    events = stored_events(answers.answer, WEEK_AGO, WEEK_AGO + 2 * DAY)
    found = dry_run(
        RuleEngine(rules, UTC),
        events,
        WEEK_AGO,
        WEEK_AGO + 2 * DAY,
        HouseMode.HOME,
        AskedRoomFacts(answers.answer, live=False) if room is None else room,  # type: ignore[arg-type]
    )
    return [
        (round(firing.at - WEEK_AGO, 3), firing.rule, firing.code.value) for firing in found.firings
    ]


def test_what_happened_goes_through_the_same_rules_with_their_limits(memory: RoomMemory) -> None:
    for at in (100.0, 110.0, 4000.0):
        ring(memory, at)
    assert codes(memory, make_rule(cooldown="60 s")) == [
        (100.0, "bell", "ok"),
        (110.0, "bell", "cooldown"),
        (4000.0, "bell", "ok"),
    ]


def test_times_come_between_events_and_nothing_is_made_up_for(memory: RoomMemory) -> None:
    ring(memory, 7 * 3600.0)
    rules = (make_rule(), make_rule(when="{at: [06:00, 08:00]}", name="round", cooldown="0"))
    assert codes(memory, *rules) == [
        (6 * 3600.0, "round", "ok"),
        (7 * 3600.0, "bell", "ok"),
        (8 * 3600.0, "round", "ok"),
        (DAY + 6 * 3600.0, "round", "ok"),
        (DAY + 8 * 3600.0, "round", "ok"),
    ]


def test_the_modes_of_then_count(memory: RoomMemory) -> None:
    memory.add(mode_event(HouseMode.PRIVACY, HouseMode.AWAY, "alice", WEEK_AGO + 200.0))
    memory.add(
        RoomEvent("mode changed", "x", WEEK_AGO + 250.0, "a-device", facts=(("mode", "away"),))
    )
    for at in (100.0, 300.0):
        ring(memory, at)
    rule = make_rule(conditions="{mode: away}", cooldown="0")
    assert codes(memory, rule) == [(100.0, "bell", "ok"), (300.0, "bell", "mode")]


def test_conditions_are_asked_as_of_then(memory: RoomMemory) -> None:
    class Room(KnownRoom):
        def presence(self, person: str, at: float) -> str:  # type: ignore[override]
            return "yes" if at < WEEK_AGO + 200.0 else "no"

    for at in (100.0, 300.0):
        ring(memory, at)
    rule = make_rule(conditions="{present: anybody}", cooldown="0")
    assert codes(memory, rule, room=Room()) == [(100.0, "bell", "ok"), (300.0, "bell", "condition")]
    # A room that remembers nobody knows nothing: then nothing would have flown.
    assert {code for _, _, code in codes(memory, rule)} == {"condition"}


def test_a_storm_is_told_in_one_line_and_read_page_by_page(
    memory: RoomMemory, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "_PAGE", 50)
    for number in range(420):
        ring(memory, 100.0 + number / 10.0)
    answers = QueryHandler(memory, RoomStatus(memory.writer.report), time.time)
    events = stored_events(answers.answer, WEEK_AGO, WEEK_AGO + DAY)
    assert len(events) == 420
    assert [event.at for event in events] == sorted(event.at for event in events)
    assert codes(memory, make_rule()) == [(100.0, "bell", "ok"), (100.1, "bell", "cooldown")]


def test_a_dry_run_is_the_same_each_time_and_changes_nothing(memory: RoomMemory) -> None:
    ring(memory, 100.0)
    rule = make_rule()
    assert codes(memory, rule) == codes(memory, rule) == [(100.0, "bell", ReasonCode.OK.value)]
