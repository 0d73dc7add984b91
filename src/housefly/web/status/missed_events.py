"""What the pilot said while no console listened: lines of the log, as the room's memory kept them.

A console that was started again knows what an earlier one kept; what happened between the two only
the memory has heard.
"""

from __future__ import annotations

from collections.abc import Iterable

from housefly.hub.api.answers import EventAnswer
from housefly.hub.flight_facts import PILOT
from housefly.messages import Severity
from housefly.messages.words import literal
from housefly.web.messages.server_messages import EventView

_SAME_MOMENT = 1.0
"""A line that was received is the same event, if it was told at most this long before [s]."""
_SEVERITIES = {one.value: one for one in Severity}


def missed_events(
    told: Iterable[EventAnswer], known: tuple[EventView, ...], offset: float
) -> tuple[EventView, ...]:
    """Return the lines of the pilot that are not among the known ones, by time, not numbered yet.

    Args:
        told: by the memory.
        known: the lines of the log.
        offset: Unix time at which the console's clock was zero [s].
    """
    lines = (_line(one, offset) for one in told if one.source == PILOT)
    return tuple(one for one in lines if one is not None and not _is_known(one, known))


def _line(event: EventAnswer, offset: float) -> EventView | None:
    severity = _SEVERITIES.get(str(event.facts.get("severity", "")))
    if severity is None:
        return None
    text = event.words or literal(str(event.facts.get("words", event.kind)))
    return EventView(0, event.at - offset, severity, event.kind.replace(" ", "_"), text)


def _is_known(line: EventView, known: tuple[EventView, ...]) -> bool:
    return any(
        one.code == line.code and one.text == line.text and abs(one.at - line.at) <= _SAME_MOMENT
        for one in known
    )
