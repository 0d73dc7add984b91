"""Whether a scanner sees the walls of the map where they are: else it, or its place, is wrong.

A scanner whose distances are half a metre off puts people half a metre from where they are. Walls
do not move: of the beams that should end on one, most do. Where they do not, and one error of the
distances or of the scanner's place explains it, the scanner is not believed, and the error is told.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import degrees, hypot, inf
from typing import Any

import numpy as np

from housefly.config.laser import LaserConfig
from housefly.numeric import FloatArray, compiled
from housefly.perception.background import expected_ranges
from housefly.perception.beams import BeamScan
from housefly.room.model import Room

AGREEMENT, AGREEMENT_SHARE = 0.12, 0.01
"""A beam ends on its wall when it ends so near to it [m], and so much more of its length."""
SEEN_SHARE = 0.75
"""A scanner sees the walls when so many of the beams that should end on one do."""
EXPLAINED_SHARE, EXPLAINED_MORE = 0.6, 0.2
"""An error explains what is seen when with it so many do, and so many more than without: people
who stand before the walls are no error.
"""
THROUGH_SHARE = 0.4
"""Where so many end behind their wall, whatever explains it, scanner and map do not belong
together.
"""
BEAMS_MIN = 40
"""Fewer beams on walls than this say nothing."""
WALL_MIN = 1.0
"""Walls nearer than this say nothing: much of an error is cut off there [m]."""
LOOK_PERIOD = 0.5
"""How often it is looked [s]."""
LOOKS = 3
"""So many looks in a row must find it ..."""
EXPLAINED_EVERY = 10
"""... and it is explained anew after so many: that takes longer."""
_STEPS = 8
"""The place that fits is found in so many steps ..."""
_MOVED, _TURNED = 0.01, 0.005
"""... by derivatives over this way and turn [m, rad]."""
_BEHIND = 0.3
"""A beam that ends farther behind its wall than this has gone through it [m]."""
_DISTRUST = "what it sees is put right, and it is not relied on"
_OUTLIER = 1.0
"""Beams that end farther from their wall are no part of it [m]."""


@dataclass(frozen=True, slots=True, eq=False)
class WallError:
    """What is wrong with a scanner, and what is right.

    Attributes:
        words: for people.
        longer: its distances are too long by this [m].
        laser: where it is by the walls; None where nothing explains what it sees.
    """

    words: str
    longer: float = 0.0
    laser: LaserConfig | None = None


@dataclass(frozen=True, slots=True, eq=False)
class WallView:
    """What one scanner has seen of the walls.

    Attributes:
        walls: distance of the wall on which each beam should end [m]; infinite for other beams.
        due: when to look again [s].
        looks: so many so far.
        strikes: looks in a row that did not see the walls.
        share: of the beams that should end on a wall did, when it was explained last.
        error: what is wrong, or None.
    """

    walls: FloatArray
    due: float = -inf
    looks: int = 0
    strikes: int = 0
    share: float = 1.0
    error: WallError | None = None


class WallCheck:
    """Compares the scans of all scanners of a room with its walls."""

    def __init__(self, room: Room) -> None:
        self._solids = room.solids
        self._walls = tuple(solid for solid in room.solids if solid.thing == "wall")
        self._views: dict[str, WallView] = {}

    def look(self, scan: BeamScan, laser: LaserConfig) -> WallError | None:
        """Return what is wrong with a scanner, or None.

        It looks at the first scans, and every ``LOOK_PERIOD`` from then on.
        """
        view = self._views.get(scan.source)
        if view is None or len(view.walls) != len(scan.ranges):
            view = WallView(self._expected(scan, laser))
        if scan.captured_at >= view.due or scan.captured_at < view.due - LOOK_PERIOD:
            looks = view.looks + 1
            due = scan.captured_at + (LOOK_PERIOD if looks >= LOOKS else 0.0)
            view = self._looked(replace(view, due=due, looks=looks), scan, laser)
        self._views[scan.source] = view
        is_open = view.looks < LOOKS and view.strikes > 0
        return (
            WallError("it is compared with the walls of the map", laser=laser)
            if is_open
            else (view.error)
        )

    def _expected(self, scan: BeamScan, laser: LaserConfig) -> FloatArray:
        """Return the distance of the wall on which each beam should end [m]; else infinite."""
        shape = scan.first_angle, scan.step, len(scan.ranges)
        walls = expected_ranges(self._walls, laser, *shape)
        first = expected_ranges(self._solids, laser, *shape)
        is_seen = (walls <= first + 1e-6) & (walls > WALL_MIN)
        return np.where(is_seen, walls, inf)

    def _looked(self, view: WallView, scan: BeamScan, laser: LaserConfig) -> WallView:
        on_wall = np.isfinite(view.walls) & np.isfinite(scan.ranges)
        share = _agreeing(scan.ranges, view.walls)
        if np.count_nonzero(on_wall) < BEAMS_MIN or share >= SEEN_SHARE:
            return replace(view, strikes=0, share=1.0, error=None)
        strikes = view.strikes + 1
        is_due = strikes % EXPLAINED_EVERY == LOOKS or share < view.share - EXPLAINED_MORE
        if strikes < LOOKS or not is_due:
            return replace(view, strikes=strikes)
        error = self._explained(view.walls, scan, laser)
        return replace(view, strikes=strikes, share=share, error=error)

    def _explained(self, walls: FloatArray, scan: BeamScan, laser: LaserConfig) -> WallError | None:
        """Return which error makes the scan fit the walls, or None."""
        on_wall = np.isfinite(walls) & np.isfinite(scan.ranges)
        off = float(np.median(scan.ranges[on_wall] - walls[on_wall]))
        enough = max(EXPLAINED_SHARE, _agreeing(scan.ranges, walls) + EXPLAINED_MORE)
        if _agreeing(scan.ranges - off, walls) >= enough:
            way = "long" if off > 0.0 else "short"
            words = f"its distances are {abs(off):.2f} m too {way} by the walls of the map"
            return WallError(f"{words}: {_DISTRUST}; restart it, and see its settings", off, laser)
        found = self._fitted(scan, laser)
        if found is not None and _agreeing(scan.ranges, self._expected(scan, found)) >= enough:
            moved = hypot(found.x - laser.x, found.y - laser.y)
            turned = abs(degrees(found.yaw - laser.yaw))
            words = (
                f"by the walls of the map it is {moved:.2f} m from where the site has it, turned by"
                f" {turned:.0f} deg: {_DISTRUST}; x = {found.x:.2f}, y = {found.y:.2f},"
                f" yaw = {found.yaw:.2f} in [[lasers]] fit, or put it back"
            )
            return WallError(words, laser=found)
        behind = np.count_nonzero(scan.ranges[on_wall] > walls[on_wall] + _BEHIND)
        if behind > THROUGH_SHARE * np.count_nonzero(on_wall):
            return WallError(
                "it sees through the walls of the map: it is not believed; compare its place and"
                " the map with the room"
            )
        return None

    def _fitted(self, scan: BeamScan, laser: LaserConfig) -> LaserConfig | None:
        """Return the place of the scanner that fits the walls; None where none near it does."""
        here = laser
        for _ in range(_STEPS):
            walls = self._expected(scan, here)
            steps = ((_MOVED, 0.0, 0.0), (0.0, _MOVED, 0.0), (0.0, 0.0, _TURNED))
            with np.errstate(invalid="ignore"):  # beams that should end on no wall
                off = scan.ranges - walls
                slopes = [
                    (self._expected(scan, _moved(here, *step)) - walls) / max(step)
                    for step in steps
                ]
            dx, dy, turn = _least_squares(off, slopes[0], slopes[1], slopes[2], _OUTLIER)
            here = _moved(here, dx, dy, turn)
            if not (abs(here.x) < 1000.0 and abs(here.y) < 1000.0 and abs(here.yaw) < 3.14):
                return None
        return here


def _moved(laser: LaserConfig, dx: float, dy: float, turn: float) -> LaserConfig:
    return laser.model_copy(update={"x": laser.x + dx, "y": laser.y + dy, "yaw": laser.yaw + turn})


def _agreeing(ranges: FloatArray, walls: FloatArray) -> float:
    """Return the share of the beams that should end on a wall, and do."""
    on_wall = np.isfinite(walls) & np.isfinite(ranges)
    off = np.abs(ranges[on_wall] - walls[on_wall])
    agreeing = np.count_nonzero(off < AGREEMENT + AGREEMENT_SHARE * walls[on_wall])
    return float(agreeing) / max(int(np.count_nonzero(on_wall)), 1)


@compiled
def _least_squares(
    off: Any, by_x: Any, by_y: Any, by_turn: Any, outlier: float
) -> tuple[float, float, float]:
    """Return the step in x, y [m] and yaw [rad] that takes the distances off the walls best."""
    a, b, c, d, e, f = 1e-9, 0.0, 0.0, 1e-9, 0.0, 1e-9
    p, q, r = 0.0, 0.0, 0.0
    for n in range(off.size):
        w, x, y, t = off[n], by_x[n], by_y[n], by_turn[n]
        if not (abs(w) < outlier and abs(x) < 5.0 and abs(y) < 5.0 and abs(t) < 50.0):
            continue
        a, b, c = a + x * x, b + x * y, c + x * t
        d, e, f = d + y * y, e + y * t, f + t * t
        p, q, r = p + x * w, q + y * w, r + t * w
    det = a * (d * f - e * e) - b * (b * f - c * e) + c * (b * e - c * d)
    if not abs(det) > 1e-12:
        return 0.0, 0.0, 0.0
    x = p * (d * f - e * e) - b * (q * f - e * r) + c * (q * e - d * r)
    y = a * (q * f - e * r) - p * (b * f - c * e) + c * (b * r - c * q)
    t = a * (d * r - q * e) - b * (b * r - c * q) + p * (b * e - c * d)
    return x / det, y / det, t / det
