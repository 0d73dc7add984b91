from __future__ import annotations

import os
import sys
import threading

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.config.site import Site, changed
from housefly.errors import ConfigError
from housefly.lab.experiments import engine
from housefly.lab.experiments.cases import PARAMETERS, cases
from housefly.lab.experiments.engine import fly_many, fly_recorded, fly_traced
from housefly.lab.experiments.flight_plan import FlightPlan, Task
from housefly.lab.experiments.trace import TRACE
from housefly.pilot.control.forms import FormCode

PATH = FlightPlan(Task.PATH, ((0.0, 0.0), (1.5, 0.0), (1.5, 1.0)), 12.0)
STEP = FlightPlan(Task.STEP, ((0.0, 0.0), (0.5, 0.3)), 15.0)
HOLD = FlightPlan(Task.HOLD, ((0.0, 0.0),), 8.0)


def fleet(count: int) -> np.ndarray:
    """Drones of both modes and all estimators that see badly, each in its own way."""
    random = np.random.default_rng(2)
    return cases(
        Site(),
        count,
        mode=np.arange(count) % 2,
        estimator=np.arange(count) // 2 % 4,
        mocap_rate_hz=random.uniform(10.0, 100.0, count),
        mocap_jitter=random.uniform(0.0, 0.02, count),
        mocap_dropout=random.uniform(0.0, 0.4, count),
        delay=random.uniform(0.0, 0.1, count),
        gust=random.uniform(0.0, 0.2, count),
        seed=np.arange(count),
    )


@pytest.mark.parametrize("mission", [PATH, STEP, HOLD], ids=["path", "step", "hold"])
def test_a_result_depends_on_its_own_row_alone(
    mission: FlightPlan, monkeypatch: pytest.MonkeyPatch
) -> None:
    drones = fleet(150)
    alone = fly_many(drones, mission, threads=1).tobytes()
    for threads in (2, 4):
        assert fly_many(drones, mission, threads=threads).tobytes() == alone
    monkeypatch.setattr(engine, "CHUNK", 7)
    assert fly_many(drones, mission, threads=3).tobytes() == alone
    order = np.random.default_rng(3).permutation(len(drones))
    shuffled = fly_many(drones[order], mission, threads=2)
    assert shuffled[np.argsort(order)].tobytes() == alone
    assert fly_many(drones[40:41], mission).tobytes() == fly_many(drones, mission)[40:41].tobytes()


def test_another_seed_gives_another_flight() -> None:
    outcomes = fly_many(cases(Site(), 20, seed=np.arange(20)), PATH)
    assert len(np.unique(outcomes["rms_error"])) == 20


def test_progress_counts_every_drone_once_and_an_error_in_it_ends_the_flights() -> None:
    told, before = list[int](), threading.active_count()
    fly_many(fleet(130), HOLD, threads=2, on_progress=told.append)
    assert sum(told) == 130

    def stop(landed: int) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        fly_many(fleet(130), HOLD, threads=2, on_progress=stop)
    assert threading.active_count() <= before


def test_no_drone_gives_no_row() -> None:
    assert len(fly_many(fleet(0), HOLD)) == 0


def test_flights_from_several_threads_do_not_disturb_each_other() -> None:
    drones, results = fleet(40), {}

    def fly(name: int) -> None:
        results[name] = fly_many(drones, PATH, threads=1).tobytes()

    workers = [threading.Thread(target=fly, args=(name,)) for name in range(3)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert len(set(results.values())) == 1


@settings(max_examples=15, deadline=None)
@given(
    st.floats(-2.0, 2.0),
    st.floats(-2.0, 2.0),
    st.sampled_from([20.0, 40.0, 100.0]),
    st.floats(0.0, 0.08),
    st.floats(0.0, 0.12),
    st.floats(3.0, 15.0),
)
def test_without_noise_and_with_the_right_model_the_estimate_is_right_and_the_drone_arrives(
    x: float, y: float, rate: float, latency: float, delay: float, lag: float
) -> None:
    perfect = {
        "mocap_noise": 0.0,
        "mocap_jitter": 0.0,
        "delay": delay,
        "model_delay": delay,
        "lag": lag,
        "model_lag": lag,
    }
    drone = cases(Site(), 1, mocap_rate_hz=rate, mocap_latency=latency, **perfect)
    outcome = fly_many(drone, FlightPlan(Task.STEP, ((0.0, 0.0), (x, y)), 20.0))[0]
    assert outcome["estimate_rms"] < 2e-3
    assert outcome["arrival_error"] < 2e-3 and outcome["residual"] < 2e-3
    assert outcome["stable"] == 1.0 and outcome["switches_per_s"] < 0.5


@settings(max_examples=10, deadline=None)
@given(st.sampled_from(["default", "paper"]), st.floats(0.3, 2.0), st.floats(-1.5, 1.5))
def test_a_mirrored_path_is_flown_mirrored(mode: str, x: float, y: float) -> None:
    drone = cases(changed(Site(), mode=mode), 1, mocap_noise=0.0)
    there = fly_traced(drone, FlightPlan(Task.PATH, ((0.0, 0.0), (x, 0.0), (x, y)), 10.0))
    back = fly_traced(drone, FlightPlan(Task.PATH, ((0.0, 0.0), (x, 0.0), (x, -y)), 10.0))
    for name in ("x", "z", "vx", "theta", "est_x", "ref_x", "cmd_theta", "behavior", "pose_age"):
        assert there[name] == pytest.approx(back[name], abs=1e-9)
    for name in ("y", "vy", "phi", "est_y", "ref_y", "cmd_phi", "cmd_yaw_rate"):
        assert there[name] == pytest.approx(-back[name], abs=1e-9)


@settings(max_examples=10, deadline=None)
@given(st.floats(-50.0, 50.0), st.floats(-50.0, 50.0), st.sampled_from(["default", "paper"]))
def test_where_the_room_lies_does_not_matter(x: float, y: float, mode: str) -> None:
    drone = cases(changed(Site(), mode=mode), 1)
    here = fly_many(drone, PATH)[0]
    moved = tuple((x + a, y + b) for a, b in PATH.waypoints)
    there = fly_many(drone, FlightPlan(Task.PATH, moved, 12.0))[0]
    for name in ("rms_error", "estimate_rms", "arrival_time"):
        assert there[name] == pytest.approx(
            here[name], rel=1e-3, abs=0.021 if name == "arrival_time" else 1e-6
        )


def test_the_paths_wish_for_a_heading_at_the_end_is_met() -> None:
    trace = fly_traced(
        cases(Site(), 1), FlightPlan(Task.PATH, PATH.waypoints, 20.0, arrival_yaw=-2.0)
    )
    assert trace["psi"][-1] == pytest.approx(-2.0, abs=0.02)


def test_the_gates_limits_hold_in_every_tick() -> None:
    drone = cases(
        Site(), 1, alpha=20.0, beta=100.0, yaw_gain=10.0, height_gain=10.0, mocap_noise=0.02
    )
    trace = fly_traced(drone, FlightPlan(Task.STEP, ((0.0, 0.0), (2.0, 2.0)), 10.0, yaw=3.0))
    assert np.hypot(trace["cmd_theta"], trace["cmd_phi"]).max() <= 0.21 + 1e-12
    assert np.abs(trace["cmd_vz"]).max() <= drone["climb_command_max"][0]
    assert np.abs(trace["cmd_yaw_rate"]).max() <= 1.75


def test_the_literal_readings_of_the_paper_fail_and_the_mended_ones_do_not() -> None:
    paper = changed(Site(), mode="paper")
    step = FlightPlan(Task.STEP, ((0.0, 0.0), (0.5, 0.0)), 20.0)
    literal = {"epsilon_yaw": 3.0, "alpha": -3.6, "beta": -3.24}
    assert fly_many(cases(paper, 1, **literal), step)[0]["stable"] == 0.0
    assert fly_many(cases(paper, 1, epsilon_yaw=3.0), step)[0]["stable"] == 1.0
    turn = FlightPlan(Task.HOLD, ((0.0, 0.0),), 20.0, yaw=3.1415)
    spins = [
        np.abs(np.diff(np.unwrap(fly_traced(cases(paper, 1, wrap_yaw=w), turn)["psi"]))).sum()
        for w in (1.0, 0.0)
    ]
    assert spins[1] > 6.0 > 2.0 * spins[0]


LATENT = {
    "mode",
    "estimator",
    "wrap_yaw",
    "tilt_max",
    "vertical_speed_max",
    "yaw_rate_max",
    "dwell",
    "epsilon_height",
    "model_climb_lag",
    "model_sink_gain",
    "climb_command_max",
    "climb_noise",
    "mistrust",
}
"""Columns that a calm flight does not notice; each has a test of its own, here, in
``test_estimated_in_flight`` or against the live pilot.
"""


OF_PLACES = {
    "pull": 4.0,
    "model_pull": 4.0,
    "stiffness": 4.0,
    "model_stiffness": 4.0,
    "form_speed_max": 0.3,
}
"""Columns of a drone that flies to places by itself, and what one is like."""


@pytest.mark.parametrize(
    "name", [parameter.name for parameter in PARAMETERS if parameter.name not in LATENT]
)
def test_every_column_has_an_effect(name: str) -> None:
    bad = {
        "gust": 0.05,
        "mocap_dropout": 0.1,
        "mocap_rate_hz": 8.0,
        "pose_age_land": 0.5,
        "seed": np.arange(8),
    }
    if name == "form" or name in OF_PLACES:
        bad |= OF_PLACES | {"form": FormCode.POSITION}
    drones = cases(Site(), 8, **bad)
    others = drones.copy()
    others[name] = FormCode.VELOCITY if name == "form" else others[name] * 1.07 + 0.013
    assert fly_many(drones, PATH).tobytes() != fly_many(others, PATH).tobytes()


def test_a_trace_has_a_row_for_every_tick_and_every_sighting_is_listed() -> None:
    trace, seen = fly_recorded(cases(Site(), 1, mocap_rate_hz=200.0), HOLD)
    assert trace.dtype == TRACE and np.diff(trace["t"]) == pytest.approx(np.full(800, 0.01))
    assert trace["sightings"].sum() == len(seen)
    assert np.array_equal(np.bincount(seen["tick"], minlength=801), trace["sightings"])


def test_a_column_that_does_not_exist_or_lies_outside_its_range_is_named() -> None:
    with pytest.raises(ConfigError, match="wnid_x"):
        cases(Site(), 1, wnid_x=1.0)
    with pytest.raises(ConfigError, match="mocap_dropout"):
        cases(Site(), 1, mocap_dropout=1.5)


@pytest.mark.skipif(
    sys.platform != "linux", reason="elsewhere niceness belongs to the whole process"
)
def test_the_threads_that_fly_simulated_drones_let_a_real_flight_go_first(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    flying, seen = engine.fly_rows, set[int]()

    def noted(*arguments: object) -> None:
        seen.add(os.getpriority(os.PRIO_PROCESS, threading.get_native_id()))
        flying(*arguments)

    monkeypatch.setattr(engine, "fly_rows", noted)
    before = os.getpriority(os.PRIO_PROCESS, threading.get_native_id())
    fly_many(fleet(3), HOLD, threads=1)
    assert seen == {max(before, engine.NICENESS)}
    assert os.getpriority(os.PRIO_PROCESS, threading.get_native_id()) == before
