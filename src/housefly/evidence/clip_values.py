"""What is asked about clips and snapshots, and what is wanted of the recorder: pure values.

Times are Unix time [s].
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Annotated, Literal

from pydantic import Field

_Word = Annotated[str, Field(max_length=200, pattern=r"^[^\x00-\x1f\x7f]*$")]
_Name = Annotated[str, Field(min_length=1, max_length=80, pattern=r"^[^\x00-\x1f\x7f]*$")]
_Time = Annotated[float, Field(ge=0.0, le=4102444800.0, allow_inf_nan=False)]


class ClipRefusal(Enum):
    """Why a clip is refused: the code of its ``TaskError``."""

    NO_SUCH_CLIP = "bad_parameter"
    NOT_NOW = "not_ready"
    MODE = "mode"


@dataclass(frozen=True, slots=True)
class StartClip:
    """Record from now on, with seconds of the past before it [s].

    ``place``, ``thing`` and ``people`` are what the clip shows; "" and () where not known.
    """

    before: float = 5.0
    place: str = ""
    thing: str = ""
    people: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class TakeSnapshot:
    """Keep one picture, of a place, a thing or people."""

    place: str = ""
    thing: str = ""
    people: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class ClipsQuestion:
    """Which clips and snapshots there are; "" and 0 mean any, the newest first.

    ``before`` is the last clip of the page before; "" begins with the newest.
    """

    since: _Time = 0.0
    until: _Time | None = None
    person: _Word = ""
    place: _Word = ""
    thing: _Word = ""
    task: Annotated[int, Field(ge=0, le=2**53)] = 0
    limit: Annotated[int, Field(ge=1, le=1000)] = 50
    ask: Literal["clips"] = "clips"
    caused_by: _Word = ""
    before: _Word = ""


@dataclass(frozen=True, slots=True)
class KeepClip:
    """Keep a clip or snapshot until somebody deletes it; with ``keep`` False, as long as others."""

    clip: _Name
    keep: bool = True
    by: _Word = ""
    ask: Literal["keep_clip"] = "keep_clip"


@dataclass(frozen=True, slots=True)
class DeleteClip:
    """Delete a clip or snapshot at once, also one that is kept; nothing brings it back."""

    clip: _Name
    by: _Word = ""
    ask: Literal["delete_clip"] = "delete_clip"


@dataclass(frozen=True, slots=True)
class ClipInfo:
    """One clip or snapshot.

    Attributes:
        id: of the clip.
        kind: "clip" or "snapshot".
        task: id of the task that asked for it.
        service, place, thing, people: what it shows.
        cause: id of the event behind it.
        began_at, duration: [Unix time, s] and [s].
        size: of the file [bytes].
        keep_until: when it is deleted [Unix time, s]; None is kept until somebody deletes it.
        blanked: whether part of it was blanked for privacy.
        cut_off: whether its end is missing, as after a crash or on a full disk.
        drone: that filmed it; "" of one that an earlier version kept.
    """

    id: str
    kind: str
    task: int
    service: str
    place: str
    thing: str
    people: tuple[str, ...]
    cause: str
    began_at: float
    duration: float
    size: int
    keep_until: float | None = None
    blanked: bool = False
    cut_off: bool = False
    drone: str = ""


@dataclass(frozen=True, slots=True)
class ClipsAnswer:
    """Clips and snapshots, the newest first; after an order, the one that it concerns."""

    clips: tuple[ClipInfo, ...]
