from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.site import Site, changed
from housefly.lab.experiments.cases import cases
from housefly.lab.experiments.engine import fly_many, fly_traced
from housefly.lab.experiments.flight_plan import FlightPlan, Task
from housefly.lab.experiments.outcomes import OUTCOME
from housefly.lab.experiments.route import CURVE_TOLERANCE, off_line, off_line_near, route_of
from housefly.pilot.behavior.trajectory_profile import trajectory_profile
from housefly.pilot.planning.trajectory.kinematic_state import TICK
from housefly.pilot.safety.limits import SafetyModeCode

CORNER = ((1.0, 1.0), (1.5, 1.0), (2.0, 1.0), (3.0, 1.0), (3.0, 2.5))


def by_hand(
    trace: np.ndarray, mission: FlightPlan, eps3: float, tilt_max: float
) -> dict[str, float]:
    """The same measures from the whole record, with NumPy."""
    task = trace[trace["t"] >= mission.settle - 1e-9]
    looks = task[::2]
    points = np.array(mission.waypoints)
    off = np.min([from_leg(looks, a, b) for a, b in pairwise(points)], axis=0)
    goal = np.hypot(looks["x"] - points[-1, 0], looks["y"] - points[-1, 1])
    inside = goal < eps3
    outside = np.flatnonzero(~inside)
    entry = 0 if len(outside) == 0 else int(outside[-1]) + 1
    last = looks[looks["t"] >= mission.duration - 2.0 - 1e-9]
    leg = (points[-1] - points[-2]) / np.hypot(*(points[-1] - points[-2]))
    past = (looks["x"] - points[-1, 0]) * leg[0] + (looks["y"] - points[-1, 1]) * leg[1]
    first = int(np.argmax(inside))
    flight = trace["behavior"][trace["t"] >= mission.settle - 0.015]
    return {
        "rms_error": np.sqrt(np.mean(off[: entry + 1] ** 2)),
        "max_error": off[: entry + 1].max(),
        "reference_rms": np.sqrt(
            np.mean((looks["x"] - looks["ref_x"]) ** 2 + (looks["y"] - looks["ref_y"]) ** 2)
        ),
        "arrival_time": looks["t"][entry] - mission.settle,
        "arrival_error": goal[-len(last) :].mean(),
        "overshoot": max(0.0, past[first:].max()),
        "residual": max(np.abs(last[axis] - last[axis].mean()).max() for axis in ("x", "y")),
        "switches_per_s": np.count_nonzero(np.diff(flight)) / (mission.duration - mission.settle),
        "saturated": np.mean(task["ask_tilt"] > tilt_max),
        "height_error": np.abs(looks["z"] - mission.height).max(),
        "estimate_rms": np.sqrt(
            np.mean(sum((looks[f"est_{axis}"] - looks[axis]) ** 2 for axis in "xyz"))
        ),
        "levelled": np.mean(task["safety"] == SafetyModeCode.HOLD),
        "ended_at": trace["t"][-1],
    }


def from_leg(rows: np.ndarray, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    share = np.clip(
        ((rows["x"] - a[0]) * (b - a)[0] + (rows["y"] - a[1]) * (b - a)[1]) / np.sum((b - a) ** 2),
        0.0,
        1.0,
    )
    off: np.ndarray = np.hypot(
        rows["x"] - a[0] - share * (b - a)[0], rows["y"] - a[1] - share * (b - a)[1]
    )
    return off


@pytest.mark.parametrize("mode", ["default", "paper"])
@pytest.mark.parametrize(
    "columns",
    [{}, {"mocap_rate_hz": 10.0, "mocap_dropout": 0.2, "mocap_noise": 0.004, "gust": 0.03}],
)
def test_measures_are_those_of_the_whole_record(mode: str, columns: dict[str, float]) -> None:
    drone = cases(changed(Site(), mode=mode), 1, seed=5, **columns)
    mission = FlightPlan(Task.PATH, CORNER, 20.0)
    outcome = fly_many(drone, mission)[0]
    expected = by_hand(
        fly_traced(drone, mission),
        mission,
        float(drone["epsilon_position"][0]),
        float(drone["tilt_max"][0]),
    )
    assert {name: outcome[name] for name in expected} == pytest.approx(expected, rel=1e-9, abs=1e-9)
    assert outcome["stable"] == 1.0


def test_distance_from_a_line_is_the_smallest_over_its_legs() -> None:
    route = route_of(FlightPlan(Task.PATH, CORNER, 1.0))
    assert route.line.tolist() == [[1.0, 1.0], [3.0, 1.0], [3.0, 2.5]]
    points = np.random.default_rng(1).uniform(-1.0, 5.0, (200, 2))
    rows = np.array([tuple(point) for point in points], dtype=[("x", "f8"), ("y", "f8")])
    legs = [from_leg(rows, a, b) for a, b in pairwise(route.line)]
    assert [off_line(route.line, x, y) for x, y in points] == pytest.approx(
        np.min(legs, axis=0).tolist(), abs=1e-12
    )


def curve(rows: int) -> FlightPlan:
    """A trajectory that leads a full circle and climbs by a metre meanwhile."""
    share = np.linspace(0.0, 1.0, rows)
    at = 2.0 * np.pi * share**3 * (10.0 - 15.0 * share + 6.0 * share**2)
    places = np.column_stack((np.cos(at), np.sin(at), 1.1 + at / (2.0 * np.pi)))
    velocities = np.gradient(places, TICK, axis=0)
    motion = np.column_stack((places, velocities, np.gradient(velocities, TICK, axis=0)))
    trajectory = trajectory_profile(motion, 0.0, 0.0)
    return FlightPlan(Task.PATH, ((1.0, 0.0), (1.0, 0.0)), 20.0, trajectory=trajectory)


def test_a_trajectory_is_measured_on_its_curve_and_by_its_heights() -> None:
    mission = curve(600)
    route = route_of(mission)
    assert 20 < len(route.line) < 200
    points = np.random.default_rng(1).uniform(-2.0, 2.0, (100, 2))
    for x, y in points:
        off = abs(np.hypot(x, y) - 1.0)
        assert off_line(route.line, x, y) == pytest.approx(off, abs=2.0 * CURVE_TOLERANCE)
    trace, outcome = fly_traced(cases(Site()), mission), fly_many(cases(Site()), mission)[0]
    late = trace[trace["t"] >= mission.settle]
    assert outcome["height_error"] == pytest.approx(
        np.abs(late["z"] - late["ref_z"]).max(), rel=0.1
    )
    assert trace["z"][-1] == pytest.approx(2.1, abs=0.02) and outcome["height_error"] < 0.1
    assert outcome["rms_error"] < 0.02 and outcome["max_error"] < 0.1


@given(
    st.lists(st.tuples(st.floats(-5.0, 5.0), st.floats(-5.0, 5.0)), min_size=2, max_size=40),
    st.floats(-6.0, 6.0),
    st.floats(-6.0, 6.0),
    st.floats(0.0, 3.0),
)
def test_what_is_skipped_of_a_line_is_never_the_nearest(
    corners: list[tuple[float, float]], x: float, y: float, reach: float
) -> None:
    route = route_of(FlightPlan(Task.PATH, tuple(corners), 1.0))
    found = off_line_near(route.line, route.marks, x, y, reach)
    assert found == off_line(route.line, x, y)


@pytest.mark.parametrize(
    "columns",
    [
        {"alpha": -3.6, "beta": -3.24},
        {"alpha": 0.5, "beta": 60.0},
        {"mocap_dropout": 1.0},
        {
            "mocap_rate_hz": 1.0,
            "pose_age_level": 99.0,
            "pose_age_land": 99.0,
            "beta": 100.0,
            "estimator": 3,
        },
        {"wind_x": 2.0, "wind_y": 2.0, "gust": 2.0, "tilt_max": 0.02},
    ],
)
def test_a_drone_that_is_lost_ends_unstable_with_finite_numbers(columns: dict[str, float]) -> None:
    outcome = fly_many(
        cases(Site(), 4, seed=np.arange(4), **columns),
        FlightPlan(Task.STEP, ((0.0, 0.0), (1.0, 0.0)), 60.0),
    )
    assert (outcome["stable"] == 0.0).all()
    for name in set(OUTCOME.names or ()) - {"arrival_time"}:
        assert np.isfinite(outcome[name]).all(), name


def test_a_drone_that_is_not_seen_holds_itself_then_lands_and_the_flight_ends() -> None:
    drone = cases(Site(), 1, mocap_dropout=1.0)
    trace = fly_traced(drone, FlightPlan(Task.HOLD, ((0.0, 0.0),), 30.0, settle=0.0))
    assert trace["safety"][20] == SafetyModeCode.NOMINAL
    assert (
        trace["safety"][100] == SafetyModeCode.HOLD and trace["safety"][-1] == SafetyModeCode.LAND
    )
    assert trace["t"][-1] == pytest.approx(2.01, abs=0.011)


@pytest.mark.parametrize("eps3", [0.001, 0.4])
def test_a_step_that_shoots_past_its_goal_is_measured_whether_or_not_it_passes_near(
    eps3: float,
) -> None:
    """A fast drone may lie within eps3 of its goal at no look at all and still overshoot."""
    mission = FlightPlan(Task.STEP, ((0.0, 0.0), (3.0, 0.0)), 14.0)
    drone = cases(
        changed(Site(), mode="paper"),
        1,
        alpha=2.0,
        beta=3.24,
        epsilon_height=2.0,
        epsilon_yaw=3.2,
        epsilon_position=eps3,
    )
    flown = fly_traced(drone, mission)
    past = float(flown["x"][flown["t"] >= mission.settle].max()) - 3.0
    assert past > 0.1
    assert fly_many(drone, mission)[0]["overshoot"] == pytest.approx(past, abs=0.002)
