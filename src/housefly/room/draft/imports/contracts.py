"""What is said about a file of a room, and what comes of it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from housefly.messages.words import Words
from housefly.room.draft.model import SiteDraft

USUAL_UNITS = {
    1.0: Words("metres"),
    0.01: Words("centimetres"),
    0.001: Words("millimetres"),
    0.0254: Words("inches"),
    0.3048: Words("feet"),
}
"""Names by metres per unit."""


@dataclass(frozen=True, slots=True)
class ImportHints:
    """What a file does not say itself.

    Attributes:
        unit: metres per unit of the file; None is found out.
        up: the axis of a scan that points up; auto is found out.
        layers: words in the names of a plan's layers that hold walls; none is found out.
        unexplored: what floor counts as that the file does not show; the pad never lies there.
    """

    unit: float | None = None
    up: Literal["auto", "y", "z"] = "auto"
    layers: tuple[str, ...] = ()
    unexplored: Literal["wall", "free"] = "wall"


@dataclass(frozen=True, slots=True)
class Imported:
    """A draft with the room of a file, and what was found and assumed, a sentence each."""

    draft: SiteDraft
    notes: tuple[Words, ...]
