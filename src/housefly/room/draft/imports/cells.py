"""Squares of floor that are occupied or unknown, as the boxes of a draft."""

from __future__ import annotations

import numpy as np

from housefly.errors import RoomError
from housefly.messages.words import Words, figure, joined
from housefly.room.draft.model import SCANNED_MAX, DraftBox
from housefly.room.reach import Mask
from housefly.room.rectangles import rectangles


def boxes_of_cells(
    mask: Mask, edge: float, top: float, thing: str, *, bottom: float = 0.0
) -> tuple[DraftBox, ...]:
    """Return few boxes that cover exactly the marked cells, from (0, 0) on.

    Args:
        mask: shape (nx, ny).
        edge: of a cell [m].
        top: height of the boxes' top [m].
        thing: what they are; their names are it with a number.
        bottom: height that they begin at [m].

    Raises:
        RoomError: there are more than a room may have.
    """
    # No two boxes share a lower left corner, so they are at least as many as these.
    padded = np.pad(mask, ((1, 0), (1, 0)))
    corners = int((mask & ~padded[:-1, 1:] & ~padded[1:, :-1]).sum())
    if corners > SCANNED_MAX:
        raise RoomError(_too_many(corners))
    return tuple(
        DraftBox(
            name=f"{thing} {n}",
            x=round((i0 + i1) / 2 * edge, 4),
            y=round((j0 + j1) / 2 * edge, 4),
            length=round((i1 - i0) * edge, 4),
            width=round((j1 - j0) * edge, 4),
            top=top,
            bottom=bottom,
            thing=thing,
        )
        for n, (i0, j0, i1, j1) in enumerate(rectangles(mask))
    )


def refuse_too_many(boxes: tuple[DraftBox, ...], name: str) -> None:
    """Raise RoomError when a file makes more boxes than a room may have."""
    if len(boxes) > SCANNED_MAX:
        raise RoomError(joined(": ", (name, _too_many(len(boxes)))))


def _too_many(count: int) -> Words:
    return Words(
        "{n} boxes and more are needed, at most {m} are supported: cut out the part to fly in, and"
        " clean it of single points",
        n=figure(count),
        m=figure(SCANNED_MAX),
    )


def without_holes(known: Mask, rounds: int = 2) -> Mask:
    """Return the mask with small holes closed: cells with five and more marked neighbours."""
    for _ in range(rounds):
        known = known | (neighbours(known) >= 5)
    return known


def neighbours(mask: Mask) -> np.ndarray[tuple[int, ...], np.dtype[np.int8]]:
    """Return how many of a cell's eight neighbours are marked; shape as the mask."""
    padded = np.pad(mask.astype(np.int8), 1)
    nx, ny = mask.shape
    total = np.zeros(mask.shape, dtype=np.int8)
    for dx in range(3):
        for dy in range(3):
            if (dx, dy) != (1, 1):
                total += padded[dx : dx + nx, dy : dy + ny]
    return total
