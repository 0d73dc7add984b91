"""How well a flight kept to its plan, by where the drone was: seen by tracking, or in truth."""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.geometry import Vec2
from housefly.messages import Phase
from housefly.numeric import FloatArray
from housefly.record.series import FlightSeries
from housefly.record.truth import TrueFlight
from housefly.room.model import Room

_FARTHEST = 1e6
"""Nobody tracks a drone this far away [m]."""


@dataclass(frozen=True, slots=True, eq=False)
class Places:
    """Where the drone was.

    Attributes:
        point: world xy [m], shape (n, 2).
        step: step of the recording at which it was there, shape (n,).
    """

    point: FloatArray
    step: NDArray[np.int64]


def tracked_places(flight: FlightSeries) -> Places:
    """Return where the tracking system saw the drone; what is no number or no place is none."""
    seen = flight.sighting[:, :2]
    possible = (np.abs(seen) < _FARTHEST).all(axis=1)
    return Places(seen[possible], flight.sighting_step[possible])


def true_places(flight: FlightSeries, truth: TrueFlight | None) -> Places:
    """Return where the drone really was; nowhere without the truth."""
    if truth is None or not flight.time.size:
        return Places(np.empty((0, 2)), np.empty(0, np.int64))
    step = np.searchsorted(flight.time, truth.time, side="right") - 1
    inside = (step >= 0) & (truth.time <= flight.time[-1] + 1.0)
    return Places(truth.position[inside, :2], step[inside])


def path_errors(flight: FlightSeries, places: Places) -> FloatArray:
    """Return the distances from the planned paths on the way to the goal and back [m]."""
    flying = flight.during(Phase.OUTBOUND, Phase.RETURNING)[places.step]
    errors = [
        distances_to_path(
            places.point[flying & (flight.path[places.step] == number)], path.waypoints
        )
        for number, path in enumerate(flight.paths)
    ]
    return np.concatenate(errors) if errors else np.empty(0)


def arrival_error(flight: FlightSeries, places: Places, room: Room) -> float | None:
    """Return the mean distance from the goal's viewpoint while looking [m]."""
    looking = np.flatnonzero(flight.during(Phase.LOOKING))
    there = places.point[np.isin(places.step, looking)]
    goal = _goal(flight, looking, room)
    if goal is None or not len(there):
        return None
    return finite_number(np.linalg.norm(there - np.array(goal), axis=1).mean())


def distances_to_path(points: FloatArray, waypoints: tuple[Vec2, ...]) -> FloatArray:
    """Return the distance [m] of each point, shape (n, 2), from a polyline, shape (n,)."""
    corners = np.array(waypoints, dtype=np.float64).reshape(-1, 2)
    starts, ends = (corners[:-1], corners[1:]) if len(corners) > 1 else (corners, corners)
    legs = ends - starts
    squared = np.maximum(np.einsum("ij,ij->i", legs, legs), np.finfo(float).tiny)
    along = np.clip(np.einsum("nij,ij->ni", points[:, None] - starts, legs) / squared, 0.0, 1.0)
    nearest = starts + along[..., None] * legs
    return np.asarray(np.min(np.linalg.norm(points[:, None] - nearest, axis=2), axis=1))


def root_mean_square(values: FloatArray) -> float | None:
    """Return the root of the mean square; None of nothing."""
    return finite_number(np.sqrt(np.mean(values**2))) if values.size else None


def largest(values: FloatArray) -> float | None:
    """Return the largest value; None of nothing."""
    return finite_number(values.max()) if values.size else None


def finite_number(value: Any) -> float | None:
    """Return a number, or None for one that is not finite."""
    return float(value) if isfinite(value) else None


def _goal(flight: FlightSeries, looking: NDArray[np.int64], room: Room) -> Vec2 | None:
    """Return the goal's viewpoint: the named place's, or the end of the path that led there."""
    if not looking.size:
        return None
    try:
        return room.place(flight.goal_name[looking[0]]).viewpoint
    except KeyError:
        used = flight.path[: looking[0] + 1]
        used = used[used >= 0]
        return flight.paths[used[-1]].waypoints[-1] if used.size else None
