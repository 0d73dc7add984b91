"""A flight in numbers.

All errors are measured in the horizontal plane. Those of the simulated room are scored on where the
drone really was; those called ``tracked`` on where the tracking system saw it, which may lie; none
on where the filter believed it to be. A number that could not be measured is None.
"""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass, replace
from math import hypot
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from housefly.config.site import Site
from housefly.geometry import Vec2
from housefly.messages import DroneStatus, Event, Phase
from housefly.messages.sensing import AIRBORNE_STATUSES
from housefly.record.places import (
    Places,
    arrival_error,
    finite_number,
    largest,
    path_errors,
    root_mean_square,
    tracked_places,
    true_places,
)
from housefly.record.series import SAFETY_MODES, STATUSES, FlightSeries
from housefly.record.truth import ContactRecord, TrueFlight, judged_outcome
from housefly.room.grid import OccupancyGrid
from housefly.room.model import Room

_AIRBORNE = [n for n, status in enumerate(STATUSES) if status in AIRBORNE_STATUSES]
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
        rms_error_m, max_error_m: true distance from the planned path while flying to the goal and
            back; None without the truth, as with real hardware.
        arrival_error_m: mean true distance from the goal's viewpoint while looking.
        min_clearance_m: smallest true distance of the hull in the air from walls and things.
        min_clearance_people_m: the same from people; None where there was nobody, too.
        mocap_rate_hz: sightings of the drone per second of the recording.
        video_frames: pictures received.
        landed_error_m: true distance from the middle of the home pad, when the drone flew and is
            down.
        behavior_switches_per_s: changes of the acceptor's state per second of the errand.
        battery_used: charge at the start less charge at the end.
        safety_modes: decisions of the last gate that occurred, mildest first.
        steps, missing_steps: steps recorded, and gaps between them.
        events: everything that was reported.
        problems: what went wrong with the recording itself.
        contacts: what the drone touched; None without the truth.
        faults: what was made to fail, as the site says it.
        tracked_rms_error_m, tracked_max_error_m, tracked_arrival_error_m, tracked_landed_error_m:
            the same errors by the tracking system's word.
        tracked_min_clearance_m: smallest distance of a sighting in the air from an obstacle of the
            map at the flight height, less half the hull's diagonal; exact to half a cell.
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
    min_clearance_people_m: float | None = None
    contacts: tuple[ContactRecord, ...] | None = None
    faults: tuple[str, ...] = ()
    tracked_rms_error_m: float | None = None
    tracked_max_error_m: float | None = None
    tracked_arrival_error_m: float | None = None
    tracked_min_clearance_m: float | None = None
    tracked_landed_error_m: float | None = None

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
    truth: TrueFlight | None = None,
    video_frames: int = 0,
    problems: tuple[str, ...] = (),
) -> Summary:
    """Return the summary of a recorded flight; its outcome names what the drone touched."""
    tracked, true = tracked_places(flight), true_places(flight, truth)
    tracked_errors, true_errors = path_errors(flight, tracked), path_errors(flight, true)
    duration = _duration(flight)
    contacts = None if truth is None else _contacts(truth, flight)
    landed_error = _landed_error(flight, room.home, true)
    return Summary(
        outcome=judged_outcome(outcome, contacts or (), landed_error),
        mode=site.mode,
        seed=site.twin.seed if site.twin.enabled else None,
        duration_s=duration,
        path_length_m=_path_length(flight),
        flown_length_m=_flown_length(flight),
        rms_error_m=root_mean_square(true_errors),
        max_error_m=largest(true_errors),
        arrival_error_m=arrival_error(flight, true, room),
        min_clearance_m=_smallest(truth, "solid"),
        mocap_rate_hz=_mocap_rate(flight),
        video_frames=video_frames,
        landed_error_m=landed_error,
        behavior_switches_per_s=_switch_rate(flight, duration),
        battery_used=_battery_used(flight),
        safety_modes=tuple(SAFETY_MODES[number].value for number in np.unique(flight.safety)),
        steps=flight.time.size,
        missing_steps=flight.missing_steps,
        events=tuple(_event(event, flight) for event in flight.events),
        problems=problems,
        min_clearance_people_m=_smallest(truth, "person"),
        contacts=contacts,
        faults=tuple(entry.fault for entry in site.faults),
        tracked_rms_error_m=root_mean_square(tracked_errors),
        tracked_max_error_m=largest(tracked_errors),
        tracked_arrival_error_m=arrival_error(flight, tracked, room),
        tracked_min_clearance_m=_tracked_min_clearance(flight, site, grid),
        tracked_landed_error_m=_landed_error(flight, room.home, tracked),
    )


def _errand(flight: FlightSeries) -> NDArray[np.int64]:
    return np.flatnonzero(~flight.during(Phase.IDLE))


def _duration(flight: FlightSeries) -> float | None:
    steps = _errand(flight)
    return finite_number(flight.time[steps[-1]] - flight.time[steps[0]]) if steps.size else None


def _path_length(flight: FlightSeries) -> float | None:
    used = flight.path[flight.during(Phase.OUTBOUND) & (flight.path >= 0)]
    return finite_number(flight.paths[used[0]].length) if used.size else None


def _flown_length(flight: FlightSeries) -> float | None:
    known = np.isin(flight.status, _AIRBORNE) & np.isfinite(flight.estimate[:, :3]).all(axis=1)
    _, sparse = np.unique(np.floor(flight.time[known] / _TRACK_PERIOD), return_index=True)
    track = flight.estimate[known][sparse, :3]
    return (
        finite_number(np.linalg.norm(np.diff(track, axis=0), axis=1).sum())
        if len(track) > 1
        else None
    )


def _tracked_min_clearance(flight: FlightSeries, site: Site, grid: OccupancyGrid) -> float | None:
    airborne = np.isin(flight.status[flight.sighting_step], _AIRBORNE)
    cells = np.floor((flight.sighting[airborne, :2] - np.array(grid.origin)) / grid.resolution)
    # Only what is on the map is a cell: a pose that is no number, or far away, is none.
    cells = cells[np.all((cells >= 0) & (cells < grid.cells.shape), axis=1)].astype(np.int64)
    if not cells.size:
        return None
    hull = hypot(site.drone.hull_length, site.drone.hull_width) / 2.0
    return finite_number(grid.clearance[tuple(cells.T)].min() - hull)


def _mocap_rate(flight: FlightSeries) -> float | None:
    captured = np.unique(flight.sighting_time)
    return (
        finite_number((captured.size - 1) / (captured[-1] - captured[0]))
        if captured.size > 1
        else None
    )


def _landed_error(flight: FlightSeries, home: Vec2, places: Places) -> float | None:
    flew = np.isin(flight.status, _AIRBORNE).any()
    if not flew or STATUSES[flight.status[-1]] is not DroneStatus.LANDED or not len(places.point):
        return None
    return finite_number(np.linalg.norm(places.point[-1] - np.array(home)))


def _smallest(truth: TrueFlight | None, of: Literal["solid", "person"]) -> float | None:
    """Return the smallest true clearance in the air [m]."""
    if truth is None:
        return None
    distances = (truth.solid if of == "solid" else truth.person)[truth.airborne]
    known = distances[np.isfinite(distances)]
    return finite_number(known.min()) if known.size else None


def _contacts(truth: TrueFlight, flight: FlightSeries) -> tuple[ContactRecord, ...]:
    start = float(flight.time[0]) if flight.time.size else 0.0
    return tuple(
        replace(contact, at_s=round(contact.at_s - start, 3)) for contact in truth.contacts
    )


def _switch_rate(flight: FlightSeries, duration: float | None) -> float | None:
    steps = _errand(flight)
    return (
        finite_number(np.count_nonzero(np.diff(flight.behavior[steps])) / duration)
        if duration
        else None
    )


def _battery_used(flight: FlightSeries) -> float | None:
    known = flight.battery[np.isfinite(flight.battery)]
    return finite_number(known[0] - known[-1]) if known.size else None


def _event(event: Event, flight: FlightSeries) -> EventRecord:
    return EventRecord(
        round(event.at - float(flight.time[0]), 3), event.severity.value, event.code, event.text
    )
