"""What the modes do otherwise than the paper, or than one would think: docs/paper.md, section 5."""

from __future__ import annotations

from math import atan2, cos, hypot, pi, radians, sin, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.site import Site, changed
from housefly.geometry import GRAVITY, quaternion_from_euler, rotate
from housefly.lab.experiments.cases import cases
from housefly.lab.experiments.engine import fly_traced
from housefly.lab.experiments.flight_plan import SETTLE, FlightPlan, Task
from housefly.pilot.behavior.acceptor import AcceptorState
from housefly.pilot.control.laws import acceleration, saturated_jointly, tilt
from housefly.pilot.control.steering import ControlReference, control_output
from housefly.pilot.estimation.constant_velocity import ConstantVelocity, cv_predicted
from housefly.pilot.estimation.estimator_state import ControlState
from housefly.pilot.estimation.lagged_axis import (
    initial_covariance,
    predicted_covariance,
    transition,
)
from housefly.pilot.site_parameters import estimator_parameters, gains_of

SITE = Site()
PAPER = changed(SITE, mode="paper")
STEADY = {"mocap_noise": 1e-6, "mocap_dropout": 0.0, "gust": 0.0}
LEG = ((0.0, 0.0), (3.0, 0.0))


def test_in_mode_default_q3_and_q4_count_to_the_paths_end_and_not_to_the_reference() -> None:
    flown = fly_traced(cases(SITE, 1, **STEADY), FlightPlan(Task.PATH, LEG, 12.0))
    under_way = (flown["t"] > SETTLE + 1.0) & (np.abs(LEG[1][0] - flown["x"]) > 0.3)
    off = np.hypot(flown["x"] - flown["ref_x"], flown["y"] - flown["ref_y"])
    assert under_way.sum() > 300
    assert (off[under_way] < 0.5 * SITE.control.epsilon_position).mean() > 0.9
    assert (flown["behavior"][under_way] == AcceptorState.PATH_TRACKING).all()


def test_one_noise_is_a_deviation_in_mode_default_and_a_density_in_mode_paper() -> None:
    noise, tick = SITE.control.acceleration_noise, 0.01
    model = estimator_parameters(False, SITE.drone, SITE.control).model
    doubt, plain = initial_covariance(1.0, 0.0), ConstantVelocity(0.0, 0.0, 0.0, 0.0, 0.0)
    for _ in range(1000):
        doubt = predicted_covariance(doubt, transition(model, True, tick))
        plain = ConstantVelocity(*cv_predicted(plain, 0.0, noise, tick))
    assert sqrt(doubt.aa) == pytest.approx(noise, rel=1e-3)
    assert sqrt(plain.vv) == pytest.approx(noise * sqrt(10.0))


@pytest.mark.parametrize("gain", [0.8, 1.0, 1.2])
def test_the_papers_filter_is_told_the_acceleration_that_the_drone_reaches(gain: float) -> None:
    """At 0.8 it was told 25 % too much, because the angle on the wire is divided by c / lambda."""
    drone = {"gain": gain, "model_gain": gain, "lag": 50.0, "delay": 0.0, "drag": 0.0}
    stream = {"mocap_rate_hz": 10.0, "mocap_latency": 0.0, "mocap_jitter": 0.0, **STEADY}
    told = {"position_noise": 1.0, "acceleration_noise": 0.001}  # only the commands count
    held = {"epsilon_height": 2.0, "epsilon_yaw": 3.2, "epsilon_position": 0.001}
    case = cases(PAPER, 1, **drone, **stream, **told, **held)
    flown = fly_traced(case, FlightPlan(Task.STEP, ((0.0, 0.0), (1.0, 0.0)), SETTLE + 0.6))
    after = flown["t"] > SETTLE + 0.3
    assert flown["est_vx"][after] == pytest.approx(flown["vx"][after], rel=0.08)


@given(st.floats(0.0, 2.0), st.floats(-0.2, 0.2), st.floats(-pi, pi))
def test_a_climb_by_one_metre_per_second_squared_pushes_ten_percent_harder_than_asked(
    climb: float, theta: float, psi: float
) -> None:
    phi = 0.5 * theta
    thrust = (GRAVITY + climb) / (cos(theta) * cos(phi))
    pushed = rotate(quaternion_from_euler(phi, theta, psi), (0.0, 0.0, thrust))
    assert pushed[2] == pytest.approx(GRAVITY + climb)
    share = 1.0 + climb / GRAVITY
    still = acceleration(theta, phi, psi)
    assert pushed[:2] == pytest.approx((share * still[0], share * still[1]), abs=1e-9)
    assert share - 1.0 == pytest.approx(0.102 * climb, abs=1e-3)


@given(st.floats(0.0, 4.0), st.floats(-pi, pi))
def test_joint_saturation_bends_the_push_by_less_than_a_degree(size: float, way: float) -> None:
    assert abs(bend(size, way)) < radians(0.85)


def test_joint_saturation_bends_a_push_of_4_m_s2_by_0_8_deg() -> None:
    assert abs(bend(4.0, pi / 4)) == pytest.approx(radians(0.8), abs=radians(0.05))
    assert bend(1.5, pi / 4) == pytest.approx(0.0, abs=1e-12)


def bend(size: float, way: float) -> float:
    """Return by how much the push turns away from what was demanded [rad]."""
    theta, phi = tilt(size * cos(way), size * sin(way), 0.0, 1.0)
    ax, ay = acceleration(*saturated_jointly(theta, phi, SITE.limits.tilt_max), 0.0)
    turn = atan2(ay, ax) - way if hypot(ax, ay) > 1e-9 else 0.0
    return atan2(sin(turn), cos(turn))


def test_k1_and_k2_are_separate_gains() -> None:
    gains = gains_of(SITE.drone, SITE.control, SITE.limits)
    aim = ControlReference((0.0, 0.0), (0.0, 0.0), (0.0, 0.0), 1.2, 0.1)
    here = ControlState((0.0, 0.0), (0.0, 0.0), (0.0, 0.0), 1.0, 0.0)
    plain = control_output(aim, here, gains)
    assert (plain.vz, plain.yaw_rate) == pytest.approx((0.2 * gains.height, 0.1 * gains.yaw))
    k1 = control_output(aim, here, gains._replace(yaw=2.0 * gains.yaw))
    k2 = control_output(aim, here, gains._replace(height=2.0 * gains.height))
    assert (k1.vz, k2.yaw_rate) == (plain.vz, plain.yaw_rate)
    assert (k1.yaw_rate, k2.vz) == pytest.approx((2.0 * plain.yaw_rate, 2.0 * plain.vz))
