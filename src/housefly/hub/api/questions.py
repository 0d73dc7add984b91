"""What may be asked of the room: one frozen value a question; ``bus.room_answers`` has what it
answers.

The same values cross the bus as JSON, are the parameters and bodies of the HTTP API, and come back
from ``housefly.connect()``. Times are Unix time [s]; ``at`` None means now.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from pydantic import Field

Name = Annotated[str, Field(min_length=1, max_length=200, pattern=r"^[^\x00-\x1f\x7f]*$")]
Word = Annotated[str, Field(max_length=200, pattern=r"^[^\x00-\x1f\x7f]*$")]
Time = Annotated[float, Field(ge=0.0, le=4102444800.0, allow_inf_nan=False)]
"""Unix time up to the year 2100 [s]."""
Metres = Annotated[float, Field(ge=-1000.0, le=1000.0, allow_inf_nan=False)]
Radius = Annotated[float, Field(gt=0.0, le=1000.0, allow_inf_nan=False)]
Seconds = Annotated[float, Field(ge=0.0, le=86400.0, allow_inf_nan=False)]
Limit = Annotated[int, Field(ge=1, le=10000)]


@dataclass(frozen=True, slots=True)
class Where:
    """Where a thing is, by id, name or alias."""

    thing: Name
    at: Time | None = None
    ask: Literal["where"] = "where"


@dataclass(frozen=True, slots=True)
class Catalogue:
    """Which things there are, of one kind or of all."""

    kind: Word = ""
    ask: Literal["catalogue"] = "catalogue"


@dataclass(frozen=True, slots=True)
class Near:
    """What is within a radius [m] of a point or of a thing."""

    radius: Radius = 1.0
    thing: Word = ""
    x: Metres = 0.0
    y: Metres = 0.0
    z: Metres = 0.0
    kind: Word = ""
    ask: Literal["near"] = "near"


@dataclass(frozen=True, slots=True)
class Contents:
    """What is in a thing, however deep."""

    thing: Name
    at: Time | None = None
    ask: Literal["contents"] = "contents"


@dataclass(frozen=True, slots=True)
class Trajectory:
    """Where a thing was between two times, at most one sample in ``every`` seconds of each source."""

    thing: Name
    since: Time
    until: Time | None = None
    every: Seconds = 0.0
    source: Word = ""
    ask: Literal["trajectory"] = "trajectory"


@dataclass(frozen=True, slots=True)
class Events:
    """What happened between two times, the newest ``limit`` of it; "" means any."""

    since: Time = 0.0
    until: Time | None = None
    thing: Word = ""
    kind: Word = ""
    cause: Word = ""
    limit: Limit = 200
    ask: Literal["events"] = "events"


@dataclass(frozen=True, slots=True)
class Sensors:
    """How every sensor does."""

    ask: Literal["sensors"] = "sensors"


@dataclass(frozen=True, slots=True)
class Picture:
    """Everything that has a place, and what holds now, at one time."""

    at: Time | None = None
    ask: Literal["picture"] = "picture"


Question = Where | Catalogue | Near | Contents | Trajectory | Events | Sensors | Picture
