"""Whom a name in a sentence means, and the intent that comes of it."""

from __future__ import annotations

from collections.abc import Mapping
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
from housefly.tasks.intents.spoken_names import SpokenName

_PLACE_FIRST = frozenset({IntentName.LOOK})
"""Intents for which a name that a place shares with a thing means the place."""
_MOST_CHOICES = 5

_HALVES = {"am": 0, "pm": 12}
_HALF_DAY = 12
_MINUTES = 60


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
        slots = _slots().validate_python(_intent_slots(values))
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


def _intent_slots(matched: Mapping[str, Any]) -> dict[str, Any]:
    """Return slots: ``hour``, ``minute``, ``past`` and ``half`` become ``at`` and ``either_half``.

    ``count`` and ``unit`` [min] become ``last_minutes``, or ``in_minutes`` where ``ahead`` stands.
    ``by``, a person of whom nothing is asked, is left out.
    Raises ValueError for a time that there is not.
    """
    slots = {name: value for name, value in matched.items() if name != "by"}
    hour, minute = slots.pop("hour", None), slots.pop("minute", None)
    past, half = slots.pop("past", None), slots.pop("half", None)
    half_to = slots.pop("half_to", None)
    if half_to is not None:
        hour, past = (int(half_to) - 1) or _HALF_DAY, 30
    if hour is not None:
        slots |= _clock(int(hour), int(minute or 0) + int(past or 0), half)
    count, unit, ahead = slots.pop("count", None), slots.pop("unit", None), slots.pop("ahead", None)
    if unit is not None:
        slots["in_minutes" if ahead else "last_minutes"] = float(1 if count is None else count) * (
            float(unit)
        )
    return slots


def _clock(hour: int, minute: int, half: str | None) -> dict[str, Any]:
    """Return ``at`` of hour and minute; ``half`` is "am", "pm" or not said."""
    if half is not None and hour > _HALF_DAY:
        half = None
    either = half is None and 1 <= hour <= _HALF_DAY
    if half is not None:
        hour = hour % _HALF_DAY + _HALVES[half]
    minutes = (hour * _MINUTES + minute) % (24 * _MINUTES)
    slots: dict[str, Any] = {"at": f"{minutes // _MINUTES:02d}:{minutes % _MINUTES:02d}"}
    return slots | ({"either_half": True} if either else {})
