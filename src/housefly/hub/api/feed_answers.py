"""What happened, as people would tell it: one entry a person's way, a thing, a flight, a task.

Times are Unix time [s].
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from housefly.messages.words import Words

FeedTopic = Literal["people", "things", "drone", "tasks"]


@dataclass(frozen=True, slots=True)
class FeedEntry:
    """Something that happened, for one line of a feed.

    Attributes:
        of: what it is about.
        thing: id of the person, thing or drone; "" of a task.
        name: of whom or what it is.
        words: what happened to it, in order: "kitchen, then sofa".
        began_at, at: when it began, and its last part.
        pictures: ids of the clips and snapshots that were kept, oldest first.
        alarms: whether somebody should look.
    """

    of: FeedTopic
    thing: str
    name: Words
    words: Words
    began_at: float
    at: float
    pictures: tuple[str, ...] = ()
    alarms: bool = False


@dataclass(frozen=True, slots=True)
class FeedAnswer:
    """What happened, the newest first."""

    entries: tuple[FeedEntry, ...]
