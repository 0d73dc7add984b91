"""What a planner in space answers: a trajectory, or in words why there is none."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import inf

import numpy as np

from housefly.geometry import Vec3
from housefly.messages.words import UNSAID, Words, figure
from housefly.pilot.planning.space.passage import Passage
from housefly.pilot.planning.space.reachability import reached_from_voxel
from housefly.pilot.planning.space.voxels import VoxelMap, VoxelMask
from housefly.pilot.planning.trajectory.trajectory import Trajectory


@dataclass(frozen=True, slots=True, eq=False)
class SpaceAnswer:
    """The answer to "how do I fly there?".

    Attributes:
        trajectory: None when there is none.
        reason: in words, why (UNSAID when there is one).
        suggestion: nearest place that could be flown to instead [m], when there is one.
        comfort: what it keeps from people [m].
        passage: how it gets past people who walk; None when it does not, or nobody walks.
        arrival: when it arrives, from now on [s]; infinite when people may keep it from that.
    """

    trajectory: Trajectory | None
    reason: Words = UNSAID
    suggestion: Vec3 | None = None
    comfort: float = 0.0
    passage: Passage | None = None
    arrival: float = inf


def arriving(answer: SpaceAnswer, comfort: float) -> SpaceAnswer:
    """Return an answer with its arrival where nobody walks, who are kept from by so much [m]."""
    if answer.trajectory is None:
        return answer
    return replace(answer, comfort=comfort, arrival=answer.trajectory.duration)


def cut_off(voxels: VoxelMap, free: VoxelMask, here: Vec3, goal: Vec3) -> SpaceAnswer:
    """Return that no free way leads from one place to another [m], and what could be reached."""
    reached = reached_from_voxel(free, voxels.voxel_of(here))
    why = Words(
        "there is no free way from {name} to {place}", name=in_words(here), place=in_words(goal)
    )
    return SpaceAnswer(None, why, nearest_free(voxels, reached, goal))


def too_fast(is_standing: bool) -> SpaceAnswer:
    """Return that no trajectory keeps the limits, for a drone that stands or flies."""
    if is_standing:
        return SpaceAnswer(None, Words("no way of flying there keeps the limits of the drone"))
    return SpaceAnswer(None, Words("the drone is too fast to turn there: let it stop first"))


def objection(voxels: VoxelMap, open_air: VoxelMask, end: Words, point: Vec3) -> Words:
    """Return why the middle of the hull may not be at a point [m], in words, or UNSAID.

    Args:
        voxels: the map.
        open_air: where no volume forbids it, shape (nx, ny, nz).
        end: which end of the way it is, ``START`` or ``GOAL``.
        point: [m].
    """
    voxel, place = voxels.voxel_of(point), in_words(point)
    if not voxels.contains(voxel):
        return Words("{end} {place} lies outside the map", end=end, place=place)
    clearance = float(voxels.clearance[voxel])
    if not open_air[voxel]:
        return Words("{end} {place} lies in a no-fly area", end=end, place=place)
    if clearance < voxels.keep:
        return Words(
            "{end} {place} is too close to an obstacle: {d} m from the hull, which keeps {m} m",
            end=end,
            place=place,
            d=figure(clearance, ".2f"),
            m=figure(voxels.keep, ".2f"),
        )
    if not voxels.allowed[voxel]:
        return Words("no way leads from home to {end} {place}", end=end, place=place)
    return UNSAID


def nearest_free(voxels: VoxelMap, free: VoxelMask, point: Vec3) -> Vec3 | None:
    """Return the middle of the free voxel nearest to a point [m]; the first among equals."""
    found = np.argwhere(free)
    if not len(found) or not np.isfinite(point).all():
        return None
    origin = np.array(voxels.origin)
    middles = origin + (found + 0.5) * voxels.resolution
    # The squares of what lies absurdly far away are no numbers.
    inside = np.clip(point, origin, origin + np.array(free.shape) * voxels.resolution)
    x, y, z = middles[((middles - inside) ** 2).sum(axis=1).argmin()].tolist()
    return x, y, z


def in_words(point: Vec3) -> str:
    """Return a point as people read it."""
    return "({:.2f}, {:.2f}, {:.2f}) m".format(*point)
