"""Questions to the room, one frozen value each; ``hub.api.answers`` has the answers.

The same values cross the bus as JSON, are the parameters of the HTTP API, and are what
``housefly.connect()`` sends. Times are Unix time [s]; ``at`` None means now.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from pydantic import Field

_Name = Annotated[str, Field(min_length=1, max_length=200, pattern=r"^[^\x00-\x1f\x7f]*$")]
_Word = Annotated[str, Field(max_length=200, pattern=r"^[^\x00-\x1f\x7f]*$")]
_Time = Annotated[float, Field(ge=0.0, le=4102444800.0, allow_inf_nan=False)]
"""Unix time up to the year 2100 [s]."""
_Metres = Annotated[float, Field(ge=-1000.0, le=1000.0, allow_inf_nan=False)]
_Radius = Annotated[float, Field(gt=0.0, le=1000.0, allow_inf_nan=False)]
_Seconds = Annotated[float, Field(ge=0.0, le=86400.0, allow_inf_nan=False)]
_Hour = Annotated[float, Field(ge=0.0, le=24.0, allow_inf_nan=False)]
"""Of the local day [h]."""
_Limit = Annotated[int, Field(ge=1, le=10000)]


@dataclass(frozen=True, slots=True)
class WhereQuestion:
    """Where a thing is, by id, name or alias."""

    thing: _Name
    at: _Time | None = None
    ask: Literal["where"] = "where"


@dataclass(frozen=True, slots=True)
class CatalogueQuestion:
    """Which things there are, of one kind or of all."""

    kind: _Word = ""
    ask: Literal["catalogue"] = "catalogue"


@dataclass(frozen=True, slots=True)
class NearQuestion:
    """What is within a radius [m] of a point or of a thing."""

    radius: _Radius = 1.0
    thing: _Word = ""
    x: _Metres = 0.0
    y: _Metres = 0.0
    z: _Metres = 0.0
    kind: _Word = ""
    ask: Literal["near"] = "near"


@dataclass(frozen=True, slots=True)
class ContentsQuestion:
    """What is in a thing, however deep."""

    thing: _Name
    at: _Time | None = None
    ask: Literal["contents"] = "contents"


@dataclass(frozen=True, slots=True)
class TrajectoryQuestion:
    """Where a thing was between two times, at most one sample per source in ``every`` seconds."""

    thing: _Name
    since: _Time
    until: _Time | None = None
    every: _Seconds = 0.0
    source: _Word = ""
    ask: Literal["trajectory"] = "trajectory"


@dataclass(frozen=True, slots=True)
class EventsQuestion:
    """What happened between two times, the newest ``limit`` of it; "" means any."""

    since: _Time = 0.0
    until: _Time | None = None
    thing: _Word = ""
    kind: _Word = ""
    cause: _Word = ""
    limit: _Limit = 200
    ask: Literal["events"] = "events"


@dataclass(frozen=True, slots=True)
class FeedQuestion:
    """What happened in the day before a time, grouped by person, thing, flight and task."""

    of: Literal["all", "people", "things", "drone", "tasks"] = "all"
    until: _Time | None = None
    limit: Annotated[int, Field(ge=1, le=200)] = 50
    ask: Literal["feed"] = "feed"


@dataclass(frozen=True, slots=True)
class SensorsQuestion:
    """How every sensor does."""

    ask: Literal["sensors"] = "sensors"


@dataclass(frozen=True, slots=True)
class PictureQuestion:
    """Everything that has a place, and what holds now, at one time."""

    at: _Time | None = None
    ask: Literal["picture"] = "picture"


@dataclass(frozen=True, slots=True)
class StateQuestion:
    """Whether a thing, device or person is in a state: "on", "open", "up"; answered yes or no."""

    thing: _Name
    state: _Name
    at: _Time | None = None
    ask: Literal["is"] = "is"


@dataclass(frozen=True, slots=True)
class PeopleQuestion:
    """Who is there, in which posture, doing what; "" is everybody."""

    person: _Word = ""
    at: _Time | None = None
    ask: Literal["people"] = "people"


@dataclass(frozen=True, slots=True)
class NightsQuestion:
    """How often somebody was up at night, between two times; "" is every bed.

    A night is from one local hour to the other [h].
    """

    since: _Time
    thing: _Word = ""
    until: _Time | None = None
    from_hour: _Hour = 22.0
    to_hour: _Hour = 6.0
    ask: Literal["nights"] = "nights"


Question = (
    WhereQuestion
    | CatalogueQuestion
    | NearQuestion
    | ContentsQuestion
    | TrajectoryQuestion
    | EventsQuestion
    | FeedQuestion
    | SensorsQuestion
    | PictureQuestion
    | StateQuestion
    | PeopleQuestion
    | NightsQuestion
)
