"""A flight in numbers."""

from __future__ import annotations

import json
from dataclasses import replace
from itertools import pairwise
from math import hypot, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.site import Site, changed
from housefly.messages import DroneStatus, Inputs, Path, Phase, PilotStep, SafetyMode
from housefly.record.places import distances_to_path
from housefly.record.series import collect
from housefly.record.summary import Summary, summarize_flight
from housefly.record.truth import ContactRecord, TrueFlight, judged_outcome
from housefly.room.grid import OccupancyGrid
from housefly.room.model import Room

COORDINATE = st.floats(-20.0, 20.0)
POINT = st.tuples(COORDINATE, COORDINATE)
PATH = st.lists(POINT, min_size=1, max_size=6).map(lambda points: Path(tuple(points), 0.0, 0.0))


@pytest.fixture
def summary(site: Site, room: Room, grid: OccupancyGrid, flight: tuple[PilotStep, ...]) -> Summary:
    return summarize_flight(
        collect(flight, "ardrone"), "completed", site, room, grid, video_frames=7
    )


def test_a_drone_that_flies_beside_its_path_has_that_error(summary: Summary) -> None:
    assert summary.tracked_max_error_m == pytest.approx(0.05)
    # On the leg along y, a third of the way, the offset lies on the path itself, except beyond its
    # end.
    assert summary.tracked_rms_error_m == pytest.approx(0.05 * sqrt(2 / 3), rel=0.02)
    assert summary.tracked_arrival_error_m == pytest.approx(0.05)
    assert summary.tracked_landed_error_m == pytest.approx(0.05)


def test_lengths_times_and_rates_are_those_of_the_flight(summary: Summary) -> None:
    assert summary.path_length_m == 6.0
    assert summary.flown_length_m == pytest.approx(2 * 6.0 + 2 * 0.9, rel=0.02)
    assert summary.duration_s == pytest.approx(23.0, abs=0.03)
    assert summary.mocap_rate_hz == pytest.approx(50.0)
    assert summary.battery_used == pytest.approx(0.004 * 25.0, abs=1e-3)
    assert summary.behavior_switches_per_s == pytest.approx(4 / 23.0, rel=0.01)
    assert (summary.video_frames, summary.steps, summary.missing_steps) == (7, 1250, 0)
    assert summary.safety_modes == (SafetyMode.NOMINAL.value, SafetyMode.HOLD.value)


def test_clearance_is_that_of_the_map_less_half_the_hull(
    summary: Summary, site: Site, grid: OccupancyGrid, flight: tuple[PilotStep, ...]
) -> None:
    flying = [
        step
        for step in flight
        if step.inputs.telemetry and step.inputs.telemetry.status is not DroneStatus.LANDED
    ]
    seen = [step.inputs.sightings[0].pose.position for step in flying]
    nearest = min(grid.clearance_at((x, y)) for x, y, _ in seen)
    assert summary.tracked_min_clearance_m == pytest.approx(
        nearest - hypot(site.drone.hull_length, site.drone.hull_width) / 2
    )


def test_events_carry_the_time_since_the_start(summary: Summary) -> None:
    (event,) = summary.events
    assert (event.at_s, event.severity, event.code) == (1.0, "info", "order_accepted")


def test_the_json_holds_every_key_that_was_promised(summary: Summary) -> None:
    promised = """outcome mode seed duration_s path_length_m rms_error_m max_error_m arrival_error_m
    min_clearance_m mocap_rate_hz video_frames landed_error_m events contacts faults
    min_clearance_people_m tracked_rms_error_m tracked_max_error_m tracked_arrival_error_m
    tracked_min_clearance_m tracked_landed_error_m"""
    assert set(promised.split()) <= set(json.loads(summary.to_json()))


def test_what_was_not_measured_is_none(
    site: Site, room: Room, grid: OccupancyGrid, flight: tuple[PilotStep, ...]
) -> None:
    blind = tuple(
        replace(step, inputs=Inputs(), outputs=replace(step.outputs, estimate=None, path=None))
        for step in flight
    )
    summary = summarize_flight(collect(blind, "ardrone"), "lost", site, room, grid)
    measured = [
        summary.tracked_rms_error_m,
        summary.tracked_max_error_m,
        summary.tracked_arrival_error_m,
        summary.tracked_landed_error_m,
        summary.battery_used,
    ]
    measured += [
        summary.tracked_min_clearance_m,
        summary.mocap_rate_hz,
        summary.path_length_m,
        summary.flown_length_m,
    ]
    assert measured == [None] * 9
    assert summary.duration_s == pytest.approx(23.0, abs=0.03)


@pytest.mark.filterwarnings("error::RuntimeWarning")
@pytest.mark.parametrize("lie", [float("nan"), float("inf"), 1e300])
def test_poses_that_are_no_numbers_take_no_number_away_and_warn_of_nothing(
    site: Site, room: Room, grid: OccupancyGrid, flight: tuple[PilotStep, ...], summary: Summary,
    lie: float,
) -> None:  # fmt: skip
    def lied(step: PilotStep) -> PilotStep:
        seen, *others = step.inputs.sightings
        lied = replace(seen, pose=replace(seen.pose, position=(lie, lie, lie)))
        return replace(step, inputs=replace(step.inputs, sightings=(lied, *others)))

    half = [lied(one) if one.inputs.sightings and number % 4 == 0 else one
            for number, one in enumerate(flight)]  # fmt: skip
    told = summarize_flight(collect(half, "ardrone"), "completed", site, room, grid)
    assert told.tracked_min_clearance_m == pytest.approx(summary.tracked_min_clearance_m, abs=0.05)
    assert told.tracked_max_error_m == pytest.approx(summary.tracked_max_error_m)


def test_a_drone_that_is_still_in_the_air_has_no_landing_error(
    site: Site, room: Room, grid: OccupancyGrid, flight: tuple[PilotStep, ...]
) -> None:
    in_the_air = [step for step in flight if step.outputs.phase is not Phase.IDLE][:-10]
    assert (
        summarize_flight(
            collect(in_the_air, "ardrone"), "cut off", site, room, grid
        ).tracked_landed_error_m
        is None
    )


def test_real_hardware_has_no_seed(site: Site, room: Room, grid: OccupancyGrid) -> None:
    hardware = changed(site, twin__enabled=False)
    assert (
        summarize_flight(collect((), "ardrone"), "nothing flown", hardware, room, grid).seed is None
    )


def test_only_the_drone_itself_counts(
    site: Site, room: Room, grid: OccupancyGrid, flight: tuple[PilotStep, ...]
) -> None:
    assert (
        summarize_flight(
            collect(flight, "somebody else"), "completed", site, room, grid
        ).mocap_rate_hz
        is None
    )


WALL = ContactRecord(104.0, "room", "wall", 0.42, 1.1, 0.2, motors_turned=True)


def truth_of(flight: tuple[PilotStep, ...], aside: float, *contacts: ContactRecord) -> TrueFlight:
    """Return the truth of a drone that really is this far aside of where tracking saw it [m]."""
    seen = [step for step in flight if step.inputs.sightings]
    position = np.array([step.inputs.sightings[0].pose.position for step in seen])
    telemetry = [step.inputs.telemetry for step in seen]
    return TrueFlight(
        time=np.array([step.now for step in seen]),
        position=position + np.array((0.0, aside, 0.0)),
        airborne=np.array([t is not None and t.status is DroneStatus.FLYING for t in telemetry]),
        solid=np.linspace(1.0, 0.3, len(seen)),
        person=np.full(len(seen), np.nan),
        contacts=contacts,
    )


@pytest.mark.parametrize("aside", [0.0, 0.5])
def test_errors_are_scored_on_the_truth_and_told_by_tracking_under_another_name(
    site: Site, room: Room, grid: OccupancyGrid, flight: tuple[PilotStep, ...], summary: Summary,
    aside: float,
) -> None:  # fmt: skip
    true = summarize_flight(
        collect(flight, "ardrone"), "completed", site, room, grid, truth=truth_of(flight, aside)
    )
    assert true.tracked_rms_error_m == summary.tracked_rms_error_m
    assert true.tracked_arrival_error_m == summary.tracked_arrival_error_m
    assert true.max_error_m is not None and true.tracked_max_error_m is not None
    assert true.max_error_m > true.tracked_max_error_m - 1e-6 + 0.8 * aside
    assert true.landed_error_m == pytest.approx(hypot(0.05, aside), abs=0.06)
    assert true.contacts == ()
    assert true.min_clearance_people_m is None
    assert true.min_clearance_m is not None and 0.3 <= true.min_clearance_m < 0.5


def test_without_the_truth_what_it_would_say_is_not_measured(summary: Summary) -> None:
    measured = (
        summary.rms_error_m, summary.max_error_m, summary.arrival_error_m, summary.contacts,
        summary.landed_error_m, summary.min_clearance_m, summary.min_clearance_people_m,
    )  # fmt: skip
    assert measured == (None,) * 7


def test_a_service_with_a_contact_is_not_completed(
    site: Site, room: Room, grid: OccupancyGrid, flight: tuple[PilotStep, ...]
) -> None:
    summary = summarize_flight(
        collect(flight, "ardrone"), "completed", site, room, grid,
        truth=truth_of(flight, 0.0, replace(WALL, at_s=flight[0].now + 4.0)),
    )  # fmt: skip
    assert summary.outcome == "completed with contact: wall (at up to 0.42 m/s)"
    assert summary.contacts is not None and summary.contacts[0].at_s == pytest.approx(4.0)
    assert json.loads(summary.to_json())["contacts"][0]["name"] == "wall"


def test_the_outcome_is_judged_on_the_truth() -> None:
    assert judged_outcome("completed", ()) == "completed"
    assert judged_outcome("completed", (replace(WALL, motors_turned=False),)) == "completed"
    assert judged_outcome("no tracking", (WALL,)).startswith("no tracking; with contact: wall")
    once = judged_outcome("completed", (WALL,))
    assert judged_outcome(once, (WALL,)) == once != "completed"
    assert judged_outcome("completed", (), 0.9) == "completed"
    assert judged_outcome("completed", (), 1.3) == "landed 1.3 m from the pad in truth"


@given(PATH, st.lists(POINT, min_size=1, max_size=5))
def test_the_distance_to_a_path_is_the_smallest_over_its_points(
    path: Path, points: list[tuple[float, float]]
) -> None:
    corners = np.array(path.waypoints)
    shares = np.linspace(0.0, 1.0, 400)[:, None]
    legs = list(pairwise(corners)) or [(corners[0], corners[0])]
    dense = np.concatenate([start + shares * (end - start) for start, end in legs])
    brute = np.linalg.norm(np.array(points)[:, None] - dense, axis=2).min(axis=1)
    # The dense points of a leg of at most 57 m lie 0.15 m apart.
    found = distances_to_path(np.array(points), path.waypoints)
    assert np.all(found <= brute + 1e-9)
    assert np.all(found >= brute - 0.08)


@given(PATH)
def test_corners_lie_on_their_path(path: Path) -> None:
    assert np.allclose(distances_to_path(np.array(path.waypoints), path.waypoints), 0.0, atol=1e-9)
