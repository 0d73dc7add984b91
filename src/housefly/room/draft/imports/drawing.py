"""What a floor plan's file draws: its shapes, and what was left out of it and why."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from enum import Enum

from housefly.geometry import Vec2
from housefly.messages.words import UNSAID, Words, figure, joined, said

_KINDS_MAX = 10
"""So many kinds are named in a sentence."""


class LeftOut(Enum):
    """Why something that a file draws became no wall, in words."""

    NO_SHAPE = "no lines or shapes"
    HIDDEN = "hidden, or on a layer that is frozen or off"
    BROKEN = "cannot be read"
    NO_WALL_LAYER = "on layers without walls"
    TOO_SMALL = "2 cm and smaller"
    FAR = "far away from all the rest"


@dataclass(frozen=True, slots=True)
class PlanShape:
    """A line, curve or outline of a plan as straight parts, in the file's unit, y up.

    Attributes:
        points: at least one.
        layer: that it is on, as it is shown.
        kind: what the format calls it.
        names: all words that may say what it is; the layer when empty.
        width: that it is drawn with.
    """

    points: tuple[Vec2, ...]
    layer: str
    kind: str
    names: str = ""
    width: float = 0.0


@dataclass(slots=True)
class PlanDrawing:
    """The shapes of a file, and how many of what were left out; together they are all it draws.

    Attributes:
        shapes: in the order of the file.
        left_out: how many, by reason and by kind or layer.
        unit: metres per unit as the file says them, None where it does not.
        unit_words: what it says.
        notes: what else was found, a sentence each.
    """

    shapes: list[PlanShape] = field(default_factory=list)
    left_out: Counter[tuple[LeftOut, str]] = field(default_factory=Counter)
    unit: float | None = None
    unit_words: Words = UNSAID
    notes: tuple[Words, ...] = ()

    def leave_out(self, reason: LeftOut, kind: str) -> None:
        """Count one thing."""
        self.left_out[reason, kind] += 1


def left_out_notes(left_out: Counter[tuple[LeftOut, str]]) -> tuple[Words, ...]:
    """Return a sentence for each reason, with how many of what."""
    notes = []
    for reason in LeftOut:
        kinds = Counter({kind: n for (why, kind), n in left_out.items() if why is reason})
        if kinds:
            named = [_counted(n, kind) for kind, n in kinds.most_common(_KINDS_MAX)]
            more = sum(kinds.values()) - sum(n for _, n in kinds.most_common(_KINDS_MAX))
            if more:
                named.append(Words("{n} more", n=figure(more)))
            notes.append(
                Words("left out: {names} ({words})", names=joined(", ", named), words=said(reason))
            )
    return tuple(notes)


def _counted(count: int, kind: str) -> Words:
    return Words("{n} {name}", n=figure(count), name=kind)
