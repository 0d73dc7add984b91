"""Flights that share their beginning: many tests fly to the same place before something happens."""

from __future__ import annotations

import copy
import copyreg
from types import CellType, FunctionType
from typing import Any, TypeVar, cast

from numba.typed import List

from housefly.config.site import Site
from housefly.numeric import boxed, unboxed
from housefly.pilot.planning.column import StaticColumns
from housefly.pilot.planning.space.doors import DoorMap
from housefly.pilot.planning.space.search import SearchScratch
from housefly.pilot.planning.space.voxels import VoxelMap
from housefly.room.grid import OccupancyGrid
from housefly.room.model import Room
from housefly.sites.loaded_site import LoadedSite
from housefly.twin.drone_body import DroneBody

Flown = TypeVar("Flown")
CONSTANT = (LoadedSite, Site, Room, OccupancyGrid, StaticColumns, VoxelMap, DoorMap, SearchScratch)
"""What no flight changes."""


def branched(flight: Flown) -> Flown:
    """Return a copy of a flight that goes on by itself, bit for bit as the first would.

    Args:
        flight: pilot, drone, world and clock; it stays as it is.
    """
    copiers = cast("dict[type, Any]", vars(copy)["_deepcopy_dispatch"])
    before = copiers.copy()
    copiers |= {FunctionType: _function, DroneBody: _drone_body}
    copiers |= dict.fromkeys(CONSTANT, lambda one, memo: one)
    try:
        return copy.deepcopy(flight)
    finally:
        copiers.clear()
        copiers |= before


def _function(function: FunctionType, memo: dict[int, Any]) -> FunctionType:
    """Copy what a function holds on to, too: else the copy would move the first flight."""
    if not function.__closure__:
        return function
    cells = tuple(CellType() for _ in function.__closure__)
    memo[id(function)] = made = FunctionType(
        function.__code__, function.__globals__, function.__name__, function.__defaults__, cells
    )
    for cell, held in zip(cells, function.__closure__, strict=True):
        cell.cell_contents = copy.deepcopy(held.cell_contents, memo)
    return made


def _drone_body(body: DroneBody, memo: dict[int, Any]) -> DroneBody:
    """Copy a drone; its windows into MuJoCo's numbers look into the numbers of the copy."""
    memo[id(body)] = made = DroneBody.__new__(DroneBody)
    vars(made).update(copy.deepcopy(vars(body), memo))
    for name, whole in (
        ("_qpos", "qpos"),
        ("_qvel", "qvel"),
        ("_qacc", "qacc"),
        ("_force", "qfrc_applied"),
    ):
        window, numbers = getattr(body, name), getattr(body.data, whole)
        first = (window.ctypes.data - numbers.ctypes.data) // numbers.itemsize
        setattr(made, name, getattr(made.data, whole)[first : first + len(window)])
    return made


copyreg.pickle(cast("type[Any]", List), lambda box: (boxed, (unboxed(box),)))
