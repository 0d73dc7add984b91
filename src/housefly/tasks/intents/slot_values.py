"""Makes the slots of an intent from what a sentence matched."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

_HALVES = {"am": 0, "pm": 12}
_HALF_DAY = 12
_MINUTES = 60


def intent_slots(matched: Mapping[str, Any]) -> dict[str, Any]:
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
