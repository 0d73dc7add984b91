"""The intent document: its schema is current, and says what the code says."""

from __future__ import annotations

import json
from typing import Any

import jsonschema
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import WireError
from housefly.tasks.intents.intent import (
    FLYING_INTENTS,
    INTENT_SLOTS,
    SCHEMA_FILE,
    Intent,
    IntentName,
    IntentSlots,
    NameKind,
    intent_from_json,
    intent_to_json,
    may_fly,
    schema_text,
)

_VALUES: dict[str, Any] = {
    "subject": "cup", "subject_kind": "thing", "owner": "person-1", "state": "on", "empty": True,
    "go": True, "at": "03:00", "either_half": True, "since": True, "day": "monday",
    "period": "night", "last_minutes": 5.0, "in_minutes": 5.0, "event": "bell", "mode": "away",
    "service": "water_plants",
}  # fmt: skip


def test_the_schema_file_is_the_one_of_the_types() -> None:
    assert SCHEMA_FILE.read_text(encoding="utf-8") == schema_text(), (
        "run python -m housefly.tasks.intents.intent"
    )


def test_every_intent_has_its_slots_in_the_table() -> None:
    assert set(INTENT_SLOTS) == set(IntentName)
    assert set(_VALUES) == {name for one in INTENT_SLOTS.values()
                            for name in one.required | one.optional}  # fmt: skip


@given(intent=st.sampled_from(IntentName), slots=st.sets(st.sampled_from(sorted(_VALUES))))
def test_schema_and_code_allow_the_same_intents(intent: IntentName, slots: set[str]) -> None:
    tree = {"intent": intent.value, "slots": {name: _VALUES[name] for name in slots}}
    allowed = _accepts(tree)
    try:
        read = intent_from_json(json.dumps(tree))
    except WireError:
        assert not allowed
        return
    assert allowed
    assert intent_from_json(intent_to_json(read)) == read
    assert read.given() == tree["slots"]


@pytest.mark.parametrize(
    "text",
    [
        "", "{}", "[]", "null", '{"intent": "explode"}', '{"intent": "look"}',
        '{"intent": "land", "speed": 3}', '{"intent": "land", "slots": {"velocity": 1}}',
        '{"intent": "look", "slots": {"subject": "a\\u0000", "subject_kind": "thing"}}',
        '{"intent": "came_at", "slots": {"at": "25:00"}}',
        '{"intent": "call_me", "slots": {"event": "time", "in_minutes": -1}}',
        '{"intent": "land", "language": "fr"}',
    ],
)  # fmt: skip
def test_what_is_no_intent_is_refused_with_the_key(text: str) -> None:
    with pytest.raises(WireError):
        intent_from_json(text)


def test_whatever_asks_for_a_flight_is_known() -> None:
    where = IntentSlots(subject="cup", subject_kind=NameKind.THING)
    assert not may_fly(Intent(IntentName.WHERE, where))
    going = IntentSlots(subject="cup", subject_kind=NameKind.THING, go=True)
    assert may_fly(Intent(IntentName.WHERE, going))
    assert all(may_fly(Intent(name)) for name in FLYING_INTENTS)


def _accepts(tree: dict[str, Any]) -> bool:
    validator = jsonschema.Draft202012Validator(json.loads(SCHEMA_FILE.read_text(encoding="utf-8")))
    return bool(validator.is_valid(tree))
