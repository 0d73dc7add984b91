"""Events that other processes tell the hub; what they may say is a small vocabulary."""

from __future__ import annotations

from typing import Annotated, Literal, get_args

from pydantic import Field, TypeAdapter, ValidationError

from housefly.errors import WireError
from housefly.hub.api.json import first_problem
from housefly.messages import RoomEvent

ToldEventKind = Literal[
    "task asked",
    "task started",
    "task paused",
    "task ended",
    "person asked",
    "person answered",
    "said",
    "found",
    "clip kept",
    "snapshot kept",
    "clip watched",
    "clip deleted",
    "rule fired",
    "mode changed",
]
"""What may be told."""
TOLD_EVENT_KINDS: frozenset[str] = frozenset(get_args(ToldEventKind))
TOLD_EVENT_SOURCE = "tasks"
"""The only source of told events: whoever may open the bus is trusted, but not with our words."""
_MAX_AWAY = 300.0
"""An event that is told to be further from now than this [s] is refused."""

_Short = Annotated[str, Field(max_length=200, pattern=r"^[^\x00-\x1f\x7f]*$")]
_Id = Annotated[str, Field(min_length=1, max_length=100, pattern=r"^[^\x00-\x1f\x7f]*$")]
_Number = Annotated[float, Field(allow_inf_nan=False)]
_Facts = Annotated[tuple[tuple[_Id, bool | _Number | _Short], ...], Field(max_length=20)]
_FACTS: TypeAdapter[_Facts] = TypeAdapter(_Facts)
_NAMES: TypeAdapter[tuple[_Id, _Short]] = TypeAdapter(tuple[_Id, _Short])


def checked_event(event: RoomEvent, now: float) -> RoomEvent:
    """Return an event that another process tells.

    Args:
        event: as told.
        now: Unix time [s].

    Raises:
        WireError: it says what nobody may tell, at a time that is not near now, or at length.
    """
    try:
        _NAMES.validate_python((event.thing, event.cause))
        _FACTS.validate_python(event.facts)
    except ValidationError as error:
        raise WireError(f"this is no event: {first_problem(error)}") from error
    if event.kind not in TOLD_EVENT_KINDS:
        allowed = ", ".join(sorted(TOLD_EVENT_KINDS))
        raise WireError(f"the event {event.kind[:60]!r} cannot be told; allowed: {allowed}")
    if event.source != TOLD_EVENT_SOURCE:
        raise WireError(f"an event of {event.source[:60]!r}; allowed: {TOLD_EVENT_SOURCE}")
    if not abs(event.at - now) <= _MAX_AWAY:
        raise WireError(f"an event {event.at - now:.0f} s from now; allowed: {_MAX_AWAY:.0f} s")
    if not 0.0 <= event.confidence <= 1.0:
        raise WireError(f"a confidence of {event.confidence}; allowed: 0 to 1")
    return event
