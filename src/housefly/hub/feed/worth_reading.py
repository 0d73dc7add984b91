"""Leaves out events that say what another one says better."""

from __future__ import annotations

from collections.abc import Sequence

from housefly.hub.api.answers import EventAnswer
from housefly.hub.situations.kinds import POSTURES, SituationKind

_SAME_MOMENT = 2.0
"""A device's word and what was concluded from it come within this time [s]."""
_POSTURES_OVER = frozenset(SituationKind(kind).ended for kind in POSTURES)


def worth_reading(events: Sequence[EventAnswer]) -> list[EventAnswer]:
    """Return events by time without those that say what another says better.

    A device's word that somebody took a thing goes where it was concluded who; the end of a posture
    goes, because the next one begins.
    """
    concluded = [(one.kind, one.thing, one.at) for one in events if "evidence" in one.facts]
    return [one for one in events if not _is_said_better(one, concluded)]


def _is_said_better(event: EventAnswer, concluded: list[tuple[str, str, float]]) -> bool:
    if event.kind in _POSTURES_OVER:
        return True
    if "evidence" in event.facts:
        return False
    return any(
        kind == event.kind and thing == event.thing and abs(at - event.at) <= _SAME_MOMENT
        for kind, thing, at in concluded
    )
