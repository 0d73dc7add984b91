from __future__ import annotations

from math import isnan

import pytest

from housefly.config.site import Site, changed
from housefly.lab.experiments.cases import cases
from housefly.lab.experiments.flight_plan import FlightPlan, Task
from housefly.lab.experiments.guidance import guided, parameters_of_case, task_created
from housefly.lab.experiments.route import route_of
from housefly.pilot.estimation.estimator_state import PoseEstimate
from housefly.pilot.site_parameters import pilot_parameters
from housefly.pilot.step import INITIAL_STEP, Guidance

HERE = PoseEstimate(0.1, 0.2, 1.1, 0.0, 0.0, 0.0, 0.3)
POINTS = ((0.0, 0.0), (1.0, 0.0), (1.0, 2.0))
OWN: dict[str, float] = {
    "drone__attitude_lag": 6.5,
    "drone__attitude_gain": 0.9,
    "drone__drag": 0.31,
    "drone__command_delay": 0.07,
    "control__alpha": 3.1,
    "control__beta": 2.9,
    "control__height_gain": 1.3,
    "control__yaw_gain": 1.6,
    "control__epsilon_height": 0.21,
    "control__epsilon_yaw": 0.36,
    "control__epsilon_position": 0.16,
    "control__dwell": 0.37,
    "control__acceleration_noise": 0.41,
    "control__position_noise": 0.004,
    "limits__tilt_max": 0.19,
    "limits__vertical_speed_max": 0.61,
    "limits__yaw_rate_max": 1.71,
    "limits__speed": 0.47,
}
"""No two alike: a mix-up of any two would show."""


@pytest.mark.parametrize("mode", ["default", "paper"])
@pytest.mark.parametrize("values", [{}, OWN], ids=["shipped", "all different"])
def test_the_batch_and_the_live_pilot_have_the_same_parameters_of_a_site(
    mode: str, values: dict[str, float]
) -> None:
    assert len(set(values.values())) == len(values)
    site = changed(Site(), mode=mode, **values)
    live = pilot_parameters(mode == "paper", site.drone, site.control, site.limits, site.estimation)
    assert parameters_of_case(cases(site)[0]) == live


def track(task: Task, active: bool, now: float) -> Guidance:
    """Return what a drone found at ``HERE`` tracks at a time [s], the task beginning after 2 s."""
    site = Site()
    params = pilot_parameters(False, site.drone, site.control, site.limits)
    route = route_of(FlightPlan(task, POINTS, 20.0, yaw=0.5))
    state, guidance = task_created(route), None
    for at in (0.0, now):
        state, progress, guidance = guided(state, INITIAL_STEP, route, params, HERE, active, at)
        assert progress.s == 0.0 and isnan(progress.yaw)
    assert guidance is not None and state.begun == (active and now >= 2.0)
    return guidance


def test_before_anything_is_seen_there_is_nothing_to_track() -> None:
    for task in Task:
        assert not track(task, False, 9.0).active


def test_on_a_path_it_waits_where_it_was_found_then_follows() -> None:
    wait, fly = track(Task.PATH, True, 1.9), track(Task.PATH, True, 2.0)
    assert wait[:5] == (True, False, HERE.x, HERE.y, HERE.yaw)
    assert fly.following and fly.height == 1.1 and isnan(fly.arrival_yaw)


def test_a_step_waits_at_the_first_waypoint_then_stands_at_the_last() -> None:
    assert track(Task.STEP, True, 1.9)[:5] == (True, False, *POINTS[0], 0.5)
    assert track(Task.STEP, True, 2.0)[:5] == (True, False, *POINTS[-1], 0.5)


def test_hold_stands_at_the_first_waypoint() -> None:
    for now in (1.9, 2.0):
        assert track(Task.HOLD, True, now)[:5] == (True, False, *POINTS[0], 0.5)
