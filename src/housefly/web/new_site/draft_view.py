"""What the page of ``housefly new`` shows: the draft, what it lacks, and where one could fly."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import ceil

import numpy as np

from housefly.config.airframe import airframe_named, airframe_names
from housefly.errors import ConfigError, HouseflyError
from housefly.geometry import Vec2
from housefly.hub.api.grid_view import grid_view
from housefly.hub.api.pilot_queries import GridView
from housefly.messages.words import Words, literal
from housefly.room.draft.alignment import fit_words, rigid_fit
from housefly.room.draft.missing import missing
from housefly.room.draft.model import DraftBox, SiteDraft
from housefly.room.draft.shapes import room_of_draft
from housefly.room.draft.site_of_draft import site_of_draft
from housefly.room.grid import build_grid

_SCAN_LETTERS = ".ul#"
_LOW = 0.3
"""What ends so far below the drone is drawn as low [m]."""
_SCAN_CELL, _SCAN_CELLS_MAX = 0.05, 400
"""Edge of a cell of the picture of a scan [m], and the most along one side."""


@dataclass(frozen=True, slots=True)
class MissingView:
    """What a step lacks, and what mends it; ``hinders`` False is advice."""

    step: str
    words: Words
    mend: Words
    hinders: bool


@dataclass(frozen=True, slots=True)
class FitView:
    """Where the tracking frame is on the map; ``trusted`` when nothing speaks against it."""

    words: tuple[Words, ...]
    trusted: bool


@dataclass(frozen=True, slots=True)
class ModelView:
    """A model of drone: as site files and its maker call it; ``address`` is the usual one."""

    model: str
    name: str
    address: str


@dataclass(frozen=True, slots=True)
class DraftView:
    """A draft and what follows from it.

    Attributes:
        version: names this very draft; a change must name it.
        folder: where the site is written.
        draft: without the boxes of a file, of which there may be thousands.
        scanned: how many those are.
        scan: where they stand; None without any.
        grid: where the drone may be, ``i`` too close; None while nobody can say.
        missing: in the order of the steps.
        fit: of the points of the tracking frame; None with fewer than two.
        models: of drones that can be chosen.
        settled: whether grid, scan, missing and fit are of this draft; else of an earlier one.
        undoable, redoable: whether there is a draft before and after this one.
        words: what was done; UNSAID for nothing.
        notes: what the last file held.
    """

    version: str
    folder: str
    draft: SiteDraft
    scanned: int
    scan: GridView | None
    grid: GridView | None
    missing: tuple[MissingView, ...]
    fit: FitView | None
    models: tuple[ModelView, ...]
    settled: bool
    undoable: bool
    redoable: bool
    words: Words
    notes: tuple[Words, ...]


def model_views() -> tuple[ModelView, ...]:
    """Return the models of drones that can be chosen."""
    airframes = ((model, airframe_named(model)) for model in airframe_names())
    return tuple(ModelView(model, one.name, one.usual_address) for model, one in airframes)


def missing_views(draft: SiteDraft) -> tuple[MissingView, ...]:
    """Return what a draft lacks, in the order of the steps."""
    return tuple(
        MissingView(one.step.value, one.words, one.mend, one.hinders) for one in missing(draft)
    )


def flyable(draft: SiteDraft) -> GridView | None:
    """Return where the drone may be as far as the draft says, None while nobody can say."""
    try:
        return grid_view(build_grid(room_of_draft(draft), site_of_draft(draft, simulated=True)))
    except HouseflyError:
        return None


def fit_view(draft: SiteDraft) -> FitView | None:
    """Return what the points of the tracking frame say, None with fewer than two."""
    if len(draft.frame_points) < 2:
        return None
    try:
        fit = rigid_fit(draft.frame_points)
    except ConfigError as error:
        return FitView((literal(error.problem),), trusted=False)
    return FitView(fit_words(fit, draft.frame_points), fit.is_trusted)


def scan_view(draft: SiteDraft) -> GridView | None:
    """Return where the boxes of a file stand; None without any.

    ``#`` as high as the drone flies or higher, ``l`` lower, ``u`` nobody has seen, ``.`` nothing.
    """
    if draft.bounds is None or not draft.scanned:
        return None
    x0, y0, x1, y1 = draft.bounds
    cell = max(_SCAN_CELL, max(x1 - x0, y1 - y0) / _SCAN_CELLS_MAX)
    width, height = max(1, ceil((x1 - x0) / cell)), max(1, ceil((y1 - y0) / cell))
    seen = np.zeros((height, width), dtype=np.uint8)
    for box in draft.scanned:
        low, high = _span(box)
        i, j = (max(0, int((at - at0) / cell)) for at, at0 in zip(low, (x0, y0), strict=True))
        k, m = (max(0, ceil((at - at0) / cell)) for at, at0 in zip(high, (x0, y0), strict=True))
        part = seen[j:m, i:k]
        np.maximum(part, _rank(box, draft.flight_height), out=part)
    rows = tuple("".join(_SCAN_LETTERS[one] for one in row) for row in seen.tolist())
    return GridView((x0, y0), cell, width, height, rows)


def _rank(box: DraftBox, flight_height: float) -> int:
    """Return the index of a box's letter; of boxes on top of each other the higher one is shown."""
    if box.thing == "unexplored":
        return 1
    return 2 if box.top < flight_height - _LOW else 3


def _span(box: DraftBox) -> tuple[Vec2, Vec2]:
    """Return the lower left and the upper right corner around a box [m]."""
    c, s = abs(np.cos(box.yaw)), abs(np.sin(box.yaw))
    a, b = (c * box.length + s * box.width) / 2, (s * box.length + c * box.width) / 2
    return (box.x - a, box.y - b), (box.x + a, box.y + b)


def without_scan(draft: SiteDraft) -> SiteDraft:
    """Return the draft as the page holds it."""
    return replace(draft, scanned=())
