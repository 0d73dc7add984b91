"""Clusters in a depth image that the room model does not explain."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from math import atan2

import numpy as np
from numpy.typing import NDArray

from housefly.geometry import Vec2, distance
from housefly.numeric import FloatArray, elementwise
from housefly.perception.clusters import Cluster, cluster_of
from housefly.perception.depth import occupied_cells
from housefly.room.distance import clearance_field, footprints
from housefly.room.grid import Cell, OccupancyGrid
from housefly.room.model import Room

_RESOLUTION = 0.1
"""Edge of a cell [m]."""
_EXPLAINED_DISTANCE = 0.2
"""Points within this distance of the modelled room belong to it [m].

It covers the camera's noise, the error of its pose, and the edge of a cell.
"""
_BAND_MARGIN = 0.05
"""The room counts this far below and above the camera's band [m]: its pose is not exact."""
_MIN_POINTS = 12
"""Clusters of fewer points are noise."""
_GAP_CELLS = 4
"""Cells no farther apart than this belong to one cluster.

A side seen at a flat angle has holes, and no drone fits between.
"""
_MAX_CLUSTERS = 64
"""Only this many clusters count, the nearest."""


def known_room(room: Room, band: Vec2) -> OccupancyGrid:
    """Return the floor plan whose cells are occupied where the room model explains points [m]."""
    x_min, y_min, x_max, y_max = room.bounds
    xs = np.arange(x_min + _RESOLUTION / 2, x_max, _RESOLUTION)
    ys = np.arange(y_min + _RESOLUTION / 2, y_max, _RESOLUTION)
    solids = [replace(solid, collides=True) for solid in room.solids]
    clearance = clearance_field(
        footprints(solids, band[0] - _BAND_MARGIN, band[1] + _BAND_MARGIN),
        xs,
        ys,
        2.0 * _EXPLAINED_DISTANCE,
    )
    cells = np.where(clearance < _EXPLAINED_DISTANCE, Cell.OCCUPIED, Cell.FREE).astype(np.uint8)
    return OccupancyGrid((x_min, y_min), _RESOLUTION, cells, clearance)


def unexplained(
    points: FloatArray, known: OccupancyGrid, band: Vec2, origin: Vec2
) -> tuple[Cluster, ...]:
    """Return the clusters of points that the room model does not explain.

    Args:
        points: world points [m], shape (n, 3).
        known: from ``known_room``.
        band: lowest and highest height that counts [m].
        origin: where the camera is [m].
    """
    points = points[(points[:, 2] >= band[0]) & (points[:, 2] <= band[1])]
    new = occupied_cells(points, known, band) & (known.cells == Cell.FREE)
    labels = _connected(new)
    cells = np.floor((points[:, :2] - np.array(known.origin)) / known.resolution).astype(np.int64)
    inside = ((cells >= 0) & (cells < np.array(known.shape))).all(axis=1)
    places, names = points[inside, :2], labels[cells[inside, 0], cells[inside, 1]]
    order = np.argsort(names, kind="stable")
    groups = np.split(places[order], np.flatnonzero(np.diff(names[order], prepend=0)))[1:]
    things = [_cluster(group, origin) for group in groups if len(group) >= _MIN_POINTS]
    return tuple(sorted(things, key=lambda thing: distance(thing.position, origin))[:_MAX_CLUSTERS])


def _cluster(points: FloatArray, origin: Vec2) -> Cluster:
    """Return the cluster of points, ordered from left to right as the camera sees them."""
    away = points - np.array(origin)
    ahead = away.mean(axis=0)
    bearing = elementwise(
        atan2,
        ahead[0] * away[:, 1] - ahead[1] * away[:, 0],
        ahead[0] * away[:, 0] + ahead[1] * away[:, 1],
    )
    return cluster_of(points[np.argsort(bearing, kind="stable")], origin)


def _connected(marked: NDArray[np.bool_]) -> NDArray[np.int64]:
    """Return the group number of each marked cell, from 1 on; 0 elsewhere."""
    labels = np.zeros(marked.shape, dtype=np.int64)
    left = {(int(i), int(j)) for i, j in np.argwhere(marked)}
    number = 0
    for first in sorted(left):
        if labels[first]:
            continue
        number += 1
        labels[first], waiting = number, [first]
        while waiting:
            for cell in _around(waiting.pop()):
                if cell in left and not labels[cell]:
                    labels[cell] = number
                    waiting.append(cell)
    return labels


def _around(cell: tuple[int, int]) -> Iterable[tuple[int, int]]:
    i, j = cell
    return ((i + di, j + dj) for di in _NEAR for dj in _NEAR)


_NEAR = range(-_GAP_CELLS, _GAP_CELLS + 1)
