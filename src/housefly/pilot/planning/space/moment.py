"""The voxels of one moment, with what moves in them, and ways through them."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from housefly.geometry import Vec3
from housefly.numeric import FloatArray
from housefly.pilot.planning.space.any_angle import in_metres, in_voxel_edges, taut
from housefly.pilot.planning.space.clearance import hull_clearances
from housefly.pilot.planning.space.search import CellSearch, SearchScratch
from housefly.pilot.planning.space.voxels import CLEARANCE_CAP, VoxelIndex, VoxelMap, VoxelMask


@dataclass(frozen=True, slots=True, eq=False)
class SpaceMoment:
    """A map at one time, for one distance from people.

    Attributes:
        voxels: the map.
        free: its free voxels, shape (nx, ny, nz).
        weights: of the search, the same shape.
        rows: everything in the room, shape (n, 11).
        standing: what is not of the room, where it is now and as large as it is, shape (m, 11).
        scratch: of the searches of all moments.
    """

    voxels: VoxelMap
    free: VoxelMask
    weights: FloatArray
    rows: FloatArray
    standing: FloatArray
    scratch: SearchScratch = field(default_factory=SearchScratch)
    _searches: list[CellSearch] = field(default_factory=list)

    @property
    def search(self) -> CellSearch:
        """The search over the free voxels; made when it is used, because a way out needs none."""
        if not self._searches:
            self._searches.append(CellSearch(self.free, self.weights, self.scratch))
        return self._searches[0]

    def is_free(self, place: FloatArray) -> bool:
        """Return whether the middle of the hull may be in the voxel of a place [m]."""
        voxel = voxel_at(self.voxels, place)
        return self.voxels.contains(voxel) and bool(self.free[voxel])

    def clearance(self, place: FloatArray) -> float:
        """Return the distance of the hull around a place from everything [m]."""
        hull = self.voxels.hull
        return float(hull_clearances(self.rows, place[None, :], hull, CLEARANCE_CAP)[0])

    def kept(self, goal: Vec3) -> FloatArray:
        """Return the goal; the middle of its voxel where only that is far enough from things."""
        place = np.array(goal)
        if self.clearance(place) >= self.voxels.keep:
            return place
        return np.array(self.voxels.middle_of(self.voxels.voxel_of(goal)))

    def corners(self, start: FloatArray, goal: FloatArray) -> FloatArray | None:
        """Return the corners of a straightened way from start to goal [m], shape (n, 3)."""
        return corners_of(self.voxels, self.search, start, goal)


def corners_of(
    voxels: VoxelMap, search: CellSearch, start: FloatArray, goal: FloatArray
) -> FloatArray | None:
    """Return the same through the cells of a search with weights."""
    cells = np.array(search.path(voxel_at(voxels, start), voxel_at(voxels, goal)).cells)
    return None if not len(cells) else straightened_cells(voxels, search, cells, start, goal)


def straightened_cells(
    voxels: VoxelMap, search: CellSearch, cells: FloatArray, start: FloatArray, goal: FloatArray
) -> FloatArray:
    """Return the corners of the straightened way through voxels [m], shape (m, 3).

    Args:
        voxels: the map.
        search: over voxels that are all free and weighed where the way leads.
        cells: of the way, shape (n, 3).
        start: in the first of them [m].
        goal: in the last of them [m].
    """
    ends = in_voxel_edges(voxels, np.stack((start, goal)))
    points = np.vstack((ends[:1], cells[1:-1] + 0.5, ends[1:]))
    weights = search.weights
    assert weights is not None
    corners = np.array(in_metres(voxels, taut(search.free, points, weights)))
    return corners if len(corners) > 1 else np.stack((start, goal))


def voxel_at(voxels: VoxelMap, place: FloatArray) -> VoxelIndex:
    """Return the voxel of a place [m], shape (3,)."""
    x, y, z = place.tolist()
    return voxels.voxel_of((x, y, z))
