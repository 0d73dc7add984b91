"""Whom a name in a sentence means, and the intent that comes of it."""

from __future__ import annotations

from functools import cache
from typing import Any

from pydantic import TypeAdapter, ValidationError

from housefly.errors import WireError
from housefly.tasks.intents.intent import (
    Intent,
    IntentName,
    IntentSlots,
    Language,
    NameKind,
    checked_intent,
)
from housefly.tasks.intents.names import NamedSubject
from housefly.tasks.intents.reading import SentenceReading, SlotText
from housefly.tasks.intents.slot_values import intent_slots
from housefly.tasks.intents.spoken_names import SpokenName

_PLACE_FIRST = frozenset({IntentName.LOOK})
"""Intents for which a name that a place shares with a thing means the place."""
_MOST_CHOICES = 5


class AmbiguousName(Exception):
    """A name means several things; ``choices`` are their names."""

    def __init__(self, choices: tuple[str, ...]) -> None:
        super().__init__(", ".join(choices))
        self.choices = choices


def intent_of(
    reading: SentenceReading, sentence: str, language: Language, spoken: tuple[SpokenName, ...]
) -> Intent | None:
    """Return the intent of a reading; None when its slots make no sense together.

    Raises:
        AmbiguousName: a name means several things.
    """
    values: dict[str, Any] = dict(reading.fixed)
    for slot in reading.slots:
        if slot.slot == "owner":
            values["owner"] = _meant(slot, reading.intent, spoken, NameKind.PERSON).id
        elif slot.slot == "subject":
            subject = _meant(slot, reading.intent, spoken)
            values |= {"subject": subject.id, "subject_kind": subject.kind.value}
        else:
            values[slot.slot] = slot.value
    try:
        slots = _slots().validate_python(intent_slots(values))
        return checked_intent(Intent(reading.intent, slots, sentence, language))
    except (ValidationError, ValueError, WireError):
        return None


@cache
def _slots() -> TypeAdapter[IntentSlots]:
    return TypeAdapter(IntentSlots)


def _meant(
    slot: SlotText,
    intent: IntentName,
    spoken: tuple[SpokenName, ...],
    kind: NameKind | None = None,
) -> NamedSubject:
    """Return the one whom a name means; raises AmbiguousName."""
    called = [one for one in spoken if one.said == slot.value and kind in (None, one.subject.kind)]
    is_place = [one.subject.kind is NameKind.PLACE for one in called]
    if any(is_place) and not all(is_place):
        wanted = intent in _PLACE_FIRST
        called = [one for one, place in zip(called, is_place, strict=True) if place is wanted]
    subjects = tuple(dict.fromkeys(one.subject for one in called))
    if len(subjects) > 1:
        raise AmbiguousName(_told_apart(subjects))
    return subjects[0]


def _told_apart(subjects: tuple[NamedSubject, ...]) -> tuple[str, ...]:
    """Return a name for each that no other has, where there is one."""
    told: list[str] = []
    for subject in subjects[:_MOST_CHOICES]:
        others = {name.casefold() for one in subjects if one is not subject for name in one.names}
        own = (name for name in subject.names if name.casefold() not in others)
        told.append(next(own, subject.names[0]))
    return tuple(told)
