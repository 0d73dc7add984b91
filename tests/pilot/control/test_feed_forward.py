"""What control is given on a trajectory in space, held against the drone of the model."""

from __future__ import annotations

from math import dist, nan

import pytest
from straight_motion import straight

from housefly.config.site import Site
from housefly.geometry import GRAVITY
from housefly.pilot.behavior.path_progress import TrajectorySetpoint
from housefly.pilot.behavior.trajectory_profile import trajectory_profile
from housefly.pilot.behavior.trajectory_progress import (
    TRAJECTORY_START,
    trajectory_advanced,
    trajectory_setpoint,
)
from housefly.pilot.control.feed_forward import feed_forward_reference
from housefly.pilot.control.model import Constants, DroneState, drone_step
from housefly.pilot.control.steering import control_output
from housefly.pilot.estimation.estimator_state import ControlState
from housefly.pilot.planning.trajectory.time_scale import TimeScale
from housefly.pilot.planning.trajectory.timing import TICK
from housefly.pilot.site_parameters import gains_of

SITE = Site()
GAINS = gains_of(SITE.drone, SITE.control, SITE.limits)
DT = 0.01


def followed(lead: bool) -> float:
    """Return how far the model drone comes off a trajectory that it knows all about [m]."""
    profile = trajectory_profile(straight(4.0, 4.5, 0.5), 0.0, 1.5)
    pending: list[tuple[float, float, float, float]] = [(0.0,) * 4] * round(GAINS.delay / DT)
    body, scale, leg, off = DroneState(z=1.1), TRAJECTORY_START, 0, 0.0
    constants = Constants(climb_lag=SITE.drone.climb_lag, yaw_lag=SITE.drone.yaw_lag)
    for _ in range(500):
        at = trajectory_setpoint(scale, leg, profile)
        off = max(off, dist((body.x, body.y, body.z), (at.x, at.y, at.z)))
        ahead = feed_forward_reference(scale, profile, at, at.yaw, GAINS, GAINS.delay)
        if not lead:
            ahead = ahead._replace(acceleration=(at.ax, at.ay), climb=0.0, turn=0.0, lead=0.0)
        # What the estimator gives: where the drone is when the command acts.
        there = body
        for waiting in pending:
            there = drone_step(there, *waiting, (0.0, 0.0), constants, DT)
        where = ControlState((there.x, there.y), (there.vx, there.vy), (0.0, 0.0), body.z, body.psi)
        asked = control_output(ahead, where, GAINS)
        pending.append((asked.theta, asked.phi, asked.vz, asked.yaw_rate))
        body = drone_step(body, *pending.pop(0), (0.0, 0.0), constants, DT)
        scale, leg = trajectory_advanced(scale, leg, profile, 1.0, body.x, body.y, body.z, DT)
    return off


def test_with_its_lags_inverted_the_drone_stays_on_a_trajectory_that_climbs_and_turns() -> None:
    assert followed(lead=True) < 0.03 < 0.1 < followed(lead=False)


def test_after_the_end_control_is_told_nothing_but_the_place() -> None:
    profile = trajectory_profile(straight(2.0, 3.0), 0.0, 1.5)
    end = TimeScale(TICK * (len(profile.motion) - 1), 1.0, 0.0)
    target: TrajectorySetpoint = trajectory_setpoint(end, 3, profile)
    aim = feed_forward_reference(end, profile, target, target.yaw, GAINS, GAINS.delay)
    assert aim.velocity == aim.acceleration == (0.0, 0.0) and aim.climb == aim.turn == 0.0
    assert aim.position == pytest.approx((2.0, 0.0)) and aim.height == pytest.approx(1.1)


def test_in_the_middle_of_a_level_motion_only_the_air_is_to_be_overcome() -> None:
    rows = straight(4.0, 6.0)
    profile = trajectory_profile(rows, 0.0, nan)
    middle = TimeScale(3.0 - GAINS.delay, 1.0, 0.0)
    aim = feed_forward_reference(
        middle,
        profile,
        trajectory_setpoint(middle, 7, profile),
        0.0,
        GAINS._replace(lag=1e9),
        GAINS.delay,
    )
    assert aim.acceleration[0] == pytest.approx(0.0, abs=1e-6)
    where = ControlState((2.0, 0.0), (rows[150, 3], 0.0), (0.0, 0.0), 1.1, 0.0)
    tilt = control_output(aim, where, GAINS).theta
    assert tilt == pytest.approx(GAINS.drag * rows[150, 3] / GRAVITY, abs=1e-3)
