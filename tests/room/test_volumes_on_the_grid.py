"""Volumes of the site on the grid of the flight height."""

from __future__ import annotations

from housefly.config.site import Site, changed
from housefly.room.bsen import bsen
from housefly.room.grid import Cell, build_grid

SQUARE = [[6.0, 3.4], [8.0, 3.4], [8.0, 5.0], [6.0, 5.0]]
INSIDE, OUTSIDE = (7.0, 4.2), (9.0, 4.2)


def kinds(kind: str, **heights: float) -> tuple[Cell, Cell]:
    """Return what the cells in a volume and beside it are."""
    site = changed(Site(), volumes=({"kind": kind, "polygon": SQUARE, **heights},))
    grid = build_grid(bsen(), site)
    return grid.kind(grid.cell_of(INSIDE)), grid.kind(grid.cell_of(OUTSIDE))


def test_the_grid_keeps_out_and_in_where_a_volume_is_at_flight_height() -> None:
    assert kinds("keep_out") == (Cell.VIRTUAL, Cell.FREE)
    assert kinds("keep_in") == (Cell.FREE, Cell.VIRTUAL)
    assert kinds("keep_out", top=1.0) == (Cell.FREE, Cell.FREE)
    assert kinds("keep_in", bottom=1.2) == (Cell.VIRTUAL, Cell.VIRTUAL)
