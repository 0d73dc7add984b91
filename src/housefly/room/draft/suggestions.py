"""What would suit a draft: how close to fly to walls, and where the pad may lie."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from housefly.config.site import changed
from housefly.geometry import Vec2
from housefly.room.distance import clearance_field, footprints
from housefly.room.draft.model import SiteDraft
from housefly.room.draft.shapes import shell_of_draft
from housefly.room.grid import (
    Cell,
    build_grid,
    cell_middles,
    extent_of,
    in_rectangle,
    inflation,
)
from housefly.room.model import Room
from housefly.room.spots import PROFILES, ClearanceProfile, largest_area, site_for

PAD_CLEARANCE = 0.5
"""From the middle of the pad to whatever stands on the floor [m]."""
_CONNECTED_SHARE = 0.6
"""Keep less distance while a smaller share than this of the flyable floor is connected."""


def clearance_profile(draft: SiteDraft) -> ClearanceProfile:
    """Return the most careful way to fly that leaves most of the floor in one part."""
    if draft.bounds is None:
        return PROFILES[0]
    shell = shell_of_draft(draft)
    best, best_share = PROFILES[0], -1.0
    for manner in PROFILES:
        home, share = _roomiest(
            replace(shell, home=draft.pad or shell.home),
            manner,
            draft,
            connected_to_home=draft.pad is not None,
        )
        if home is not None and share >= _CONNECTED_SHARE:
            return manner
        if home is not None and best_share < 0.0:
            best, best_share = manner, share
    return best


def suggested_pad(draft: SiteDraft) -> Vec2 | None:
    """Return the roomiest spot for the pad [m], None where the drone fits nowhere."""
    shell = shell_of_draft(draft)
    return _roomiest(shell, clearance_profile(draft), draft)[0]


def _roomiest(
    room: Room, manner: ClearanceProfile, draft: SiteDraft, *, connected_to_home: bool = False
) -> tuple[Vec2 | None, float]:
    """Return the roomiest point of the largest flyable part, and its share of all parts."""
    site = site_for(manner)
    grid = build_grid(room, changed(site, map__flight_height=draft.flight_height))
    xs, ys = cell_middles(extent_of(grid), grid.resolution)
    flyable = grid.clearance >= inflation(site)
    for zone in draft.zones:
        flyable &= ~in_rectangle(zone.rectangle, xs, ys)
    if connected_to_home:
        flyable &= grid.cells != Cell.OUTSIDE
    area = largest_area(flyable)
    if area is None:
        return None, 0.0
    x_min, y_min, x_max, y_max = room.bounds
    edge_x = np.minimum(xs - x_min, x_max - xs)[:, None]
    edge_y = np.minimum(ys - y_min, y_max - ys)[None, :]
    on_floor = clearance_field(footprints(room.solids, 0.02, draft.flight_height), xs, ys, 5.0)
    on_floor[~area] = 0.0
    if not (on_floor >= PAD_CLEARANCE).any():
        return None, 0.0
    roomy = np.minimum(np.minimum(grid.clearance, on_floor), np.minimum(edge_x, edge_y))
    i, j = np.unravel_index(
        int(np.where(on_floor >= PAD_CLEARANCE, roomy, -1.0).argmax()), grid.shape
    )
    x, y = grid.centre_of((int(i), int(j)))
    return (round(x, 2), round(y, 2)), float(area.sum() / flyable.sum())
