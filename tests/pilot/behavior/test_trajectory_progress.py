"""The moving reference on a trajectory in space."""

from __future__ import annotations

from math import nan

import numpy as np
import pytest
from straight_motion import straight

from housefly.pilot.behavior.path_profile import PathProfile
from housefly.pilot.behavior.path_progress import LAG_MAX, TrajectorySetpoint
from housefly.pilot.behavior.trajectory_profile import trajectory_profile
from housefly.pilot.behavior.trajectory_progress import (
    TRAJECTORY_START,
    trajectory_advanced,
    trajectory_setpoint,
)
from housefly.pilot.planning.trajectory.time_scale import TimeScale, stopping_rows
from housefly.pilot.planning.trajectory.timing import TICK

DT = 0.01


def flown(
    profile: PathProfile, wanted: float, off: float = 0.0, seconds: float = 20.0
) -> list[TrajectorySetpoint]:
    """Return the references at each tick for a drone that is off by so much."""
    targets: list[TrajectorySetpoint] = []
    scale, leg = TRAJECTORY_START, 0
    for _ in range(round(seconds / DT)):
        at = trajectory_setpoint(scale, leg, profile)
        here = (at.x, at.y, at.z + off)
        scale, leg = trajectory_advanced(scale, leg, profile, wanted, *here, DT)
        targets.append(trajectory_setpoint(scale, leg, profile))
    return targets


def test_it_comes_to_the_end_waypoint_by_waypoint_and_stands_there() -> None:
    profile = trajectory_profile(straight(3.0, 5.0, 0.4), 0.0, nan)
    targets = flown(profile, 1.0, seconds=6.0)
    numbers = [target.waypoint for target in targets]
    assert numbers == sorted(numbers) and numbers[0] == 1
    assert numbers[-1] == len(profile.points) - 1
    last = targets[-1]
    assert last.finished and not targets[480].finished
    assert (last.x, last.y, last.z) == pytest.approx((3.0, 0.0, 1.5))
    assert (last.vx, last.vz, last.ax, last.az) == (0.0,) * 4


def test_it_goes_as_slowly_as_asked_and_waits_for_a_drone_that_is_off() -> None:
    profile = trajectory_profile(straight(3.0, 5.0), 0.0, nan)
    assert flown(profile, 0.5, seconds=6.0)[-1].x < 2.5
    assert flown(profile, 0.5)[-1].finished
    assert flown(profile, 1.0, off=LAG_MAX - 0.01)[-1].finished
    stopped = flown(profile, 1.0, off=LAG_MAX + 0.01)[-1]
    assert stopped.x < 0.1 and stopped.vx == 0.0


def test_a_stop_ends_on_the_curve_at_rest_without_a_jump() -> None:
    profile = trajectory_profile(straight(4.0, 5.0, 0.3), 0.0, nan)
    rows = stopping_rows(TimeScale(2.5, 1.0, 0.0), profile.motion, TICK, 1.0)
    assert rows.shape[1] == 9 and not rows[-1, 3:].any()
    assert rows[0, :6] == pytest.approx(profile.motion[125, :6])
    steps = np.linalg.norm(np.diff(rows[:, :3], axis=0), axis=1)
    speeds = np.linalg.norm(rows[:, 3:6], axis=1)
    assert np.abs(steps / TICK - 0.5 * (speeds[1:] + speeds[:-1])).max() < 0.02
    assert np.abs(np.diff(speeds)).max() / TICK < 1.0 + np.abs(profile.motion[:, 6:9]).max()
    assert all(np.linalg.norm(profile.motion[:, :3] - row[:3], axis=1).min() < 0.02 for row in rows)
