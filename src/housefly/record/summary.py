"""A flight in numbers.

All errors are measured in the horizontal plane, and where the tracking system saw the drone, not
where the filter believed it to be. A number that could not be measured is None.
"""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from math import hypot, isfinite
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.config.site import Site
from housefly.geometry import Vec2
from housefly.messages import DroneStatus, Event, Phase
from housefly.numeric import FloatArray
from housefly.record.series import SAFETY_MODES, STATUSES, FlightSeries
from housefly.room.grid import OccupancyGrid
from housefly.room.model import Room

_AIRBORNE = [
    STATUSES.index(status)
    for status in (DroneStatus.TAKING_OFF, DroneStatus.FLYING, DroneStatus.LANDING)
]
_TRACK_PERIOD = 0.2
"""Sampling period of the flown length [s]; shorter ones would add up the noise."""


@dataclass(frozen=True, slots=True)
class EventRecord:
    """One event, with its time since the start of the recording [s]."""

    at_s: float
    severity: str
    code: str
    text: str


@dataclass(frozen=True, slots=True)
class Summary:
    """One flight in numbers; the keys of ``summary.json``.

    Attributes:
        outcome: "completed", or why not.
        mode: default or paper.
        seed: of the simulated room; None with real hardware.
        duration_s: from the first step of the errand to its last.
        path_length_m: planned length of the path to the goal.
        flown_length_m: length flown in the air, from the estimate.
        rms_error_m, max_error_m: distance of the sightings from the planned path while flying to
            the goal and back.
        arrival_error_m: mean distance of the sightings from the goal's viewpoint while looking.
        min_clearance_m: smallest distance of a sighting in the air from an obstacle at the flight
            height, less half the hull's diagonal; exact to half a cell of the grid.
        mocap_rate_hz: sightings of the drone per second of the recording.
        video_frames: pictures received.
        landed_error_m: distance of the last sighting from the middle of the home pad, when the
            drone flew and is down.
        behavior_switches_per_s: changes of the acceptor's state per second of the errand.
        battery_used: charge at the start less charge at the end.
        safety_modes: decisions of the last gate that occurred, mildest first.
        steps, missing_steps: steps recorded, and gaps between them.
        events: everything that was reported.
        problems: what went wrong with the recording itself.
    """

    outcome: str
    mode: str
    seed: int | None
    duration_s: float | None
    path_length_m: float | None
    flown_length_m: float | None
    rms_error_m: float | None
    max_error_m: float | None
    arrival_error_m: float | None
    min_clearance_m: float | None
    mocap_rate_hz: float | None
    video_frames: int
    landed_error_m: float | None
    behavior_switches_per_s: float | None
    battery_used: float | None
    safety_modes: tuple[str, ...]
    steps: int
    missing_steps: int
    events: tuple[EventRecord, ...]
    problems: tuple[str, ...] = ()

    def to_json(self) -> str:
        """Return the text of ``summary.json``."""
        return json.dumps(asdict(self), indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def summarize_flight(
    flight: FlightSeries,
    outcome: str,
    site: Site,
    room: Room,
    grid: OccupancyGrid,
    *,
    video_frames: int = 0,
    problems: tuple[str, ...] = (),
) -> Summary:
    """Return the summary of a recorded flight."""
    errors = _path_errors(flight)
    duration = _duration(flight)
    return Summary(
        outcome=outcome,
        mode=site.mode,
        seed=site.twin.seed if site.twin.enabled else None,
        duration_s=duration,
        path_length_m=_path_length(flight),
        flown_length_m=_flown_length(flight),
        rms_error_m=_number(np.sqrt(np.mean(errors**2))) if errors.size else None,
        max_error_m=_number(errors.max()) if errors.size else None,
        arrival_error_m=_arrival_error(flight, room),
        min_clearance_m=_min_clearance(flight, site, grid),
        mocap_rate_hz=_mocap_rate(flight),
        video_frames=video_frames,
        landed_error_m=_landed_error(flight, room.home),
        behavior_switches_per_s=_switch_rate(flight, duration),
        battery_used=_battery_used(flight),
        safety_modes=tuple(SAFETY_MODES[number].value for number in np.unique(flight.safety)),
        steps=flight.time.size,
        missing_steps=flight.missing_steps,
        events=tuple(_event(event, flight) for event in flight.events),
        problems=problems,
    )


def distance_to_path(points: FloatArray, waypoints: tuple[Vec2, ...]) -> FloatArray:
    """Return the distance [m] of each point, shape (n, 2), from a polyline, shape (n,)."""
    corners = np.array(waypoints, dtype=np.float64).reshape(-1, 2)
    starts, ends = (corners[:-1], corners[1:]) if len(corners) > 1 else (corners, corners)
    legs = ends - starts
    squared = np.maximum(np.einsum("ij,ij->i", legs, legs), np.finfo(float).tiny)
    along = np.clip(np.einsum("nij,ij->ni", points[:, None] - starts, legs) / squared, 0.0, 1.0)
    nearest = starts + along[..., None] * legs
    return np.asarray(np.min(np.linalg.norm(points[:, None] - nearest, axis=2), axis=1))


def _number(value: Any) -> float | None:
    return float(value) if isfinite(value) else None


def _errand(flight: FlightSeries) -> NDArray[np.int64]:
    return np.flatnonzero(~flight.during(Phase.IDLE))


def _duration(flight: FlightSeries) -> float | None:
    steps = _errand(flight)
    return _number(flight.time[steps[-1]] - flight.time[steps[0]]) if steps.size else None


def _path_length(flight: FlightSeries) -> float | None:
    used = flight.path[flight.during(Phase.OUTBOUND) & (flight.path >= 0)]
    return _number(flight.paths[used[0]].length) if used.size else None


def _flown_length(flight: FlightSeries) -> float | None:
    known = np.isin(flight.status, _AIRBORNE) & np.isfinite(flight.estimate[:, :3]).all(axis=1)
    _, sparse = np.unique(np.floor(flight.time[known] / _TRACK_PERIOD), return_index=True)
    track = flight.estimate[known][sparse, :3]
    return _number(np.linalg.norm(np.diff(track, axis=0), axis=1).sum()) if len(track) > 1 else None


def _path_errors(flight: FlightSeries) -> FloatArray:
    step = flight.sighting_step
    flying = flight.during(Phase.OUTBOUND, Phase.RETURNING)[step]
    errors = [
        distance_to_path(
            flight.sighting[flying & (flight.path[step] == number), :2], path.waypoints
        )
        for number, path in enumerate(flight.paths)
    ]
    return np.concatenate(errors) if errors else np.empty(0)


def _arrival_error(flight: FlightSeries, room: Room) -> float | None:
    looking = np.flatnonzero(flight.during(Phase.LOOKING))
    seen = flight.sighting[np.isin(flight.sighting_step, looking), :2]
    goal = _goal(flight, looking, room)
    if goal is None or not len(seen):
        return None
    return _number(np.linalg.norm(seen - np.array(goal), axis=1).mean())


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


def _min_clearance(flight: FlightSeries, site: Site, grid: OccupancyGrid) -> float | None:
    airborne = np.isin(flight.status[flight.sighting_step], _AIRBORNE)
    cells = np.floor(
        (flight.sighting[airborne, :2] - np.array(grid.origin)) / grid.resolution
    ).astype(np.int64)
    on_map = np.all((cells >= 0) & (cells < grid.cells.shape), axis=1)
    if not on_map.any():
        return None
    hull = hypot(site.drone.hull_length, site.drone.hull_width) / 2.0
    return _number(grid.clearance[tuple(cells[on_map].T)].min() - hull)


def _mocap_rate(flight: FlightSeries) -> float | None:
    captured = np.unique(flight.sighting_time)
    return (
        _number((captured.size - 1) / (captured[-1] - captured[0])) if captured.size > 1 else None
    )


def _landed_error(flight: FlightSeries, home: Vec2) -> float | None:
    flew = np.isin(flight.status, _AIRBORNE).any()
    if (
        not flew
        or STATUSES[flight.status[-1]] is not DroneStatus.LANDED
        or not len(flight.sighting)
    ):
        return None
    return _number(np.linalg.norm(flight.sighting[-1, :2] - np.array(home)))


def _switch_rate(flight: FlightSeries, duration: float | None) -> float | None:
    steps = _errand(flight)
    return (
        _number(np.count_nonzero(np.diff(flight.behavior[steps])) / duration) if duration else None
    )


def _battery_used(flight: FlightSeries) -> float | None:
    known = flight.battery[np.isfinite(flight.battery)]
    return _number(known[0] - known[-1]) if known.size else None


def _event(event: Event, flight: FlightSeries) -> EventRecord:
    return EventRecord(
        round(event.at - float(flight.time[0]), 3), event.severity.value, event.code, event.text
    )
