from __future__ import annotations

from math import atan2, pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.site import Site
from housefly.geometry import GRAVITY
from housefly.pilot.control.steering import (
    ControlOutput,
    ControlReference,
    Gains,
    control_output,
    paper_control_output,
)
from housefly.pilot.estimation.estimator import ControlState
from housefly.pilot.safety.limits import limited, too_old
from housefly.pilot.site_parameters import gains_of

GAINS = gains_of(Site())
pairs = st.tuples(st.floats(-0.4, 0.4), st.floats(-0.4, 0.4))
aims = st.builds(ControlReference, pairs, pairs, pairs, st.floats(0.5, 2.0), st.floats(-pi, pi))
wheres = st.builds(ControlState, pairs, pairs, pairs, st.floats(0.5, 2.0), st.floats(-pi, pi))


def twin(aim: ControlReference, where: ControlState, g: Gains) -> ControlOutput:
    """The law of mode default with vectors and a rotation matrix."""
    error = np.array(aim.position) + g.delay * np.array(aim.velocity) - where.position
    rate = np.array(aim.velocity) - where.velocity
    a = (
        g.beta * error
        + g.alpha * rate
        + np.array(aim.acceleration)
        + g.drag * np.array(aim.velocity)
        - where.disturbance
    )
    c, s = np.cos(where.yaw), np.sin(where.yaw)
    forward, left = np.array([[c, s], [-s, c]]) @ a
    theta = np.arctan(forward / GRAVITY)
    angles = np.array([theta, -np.arctan(np.cos(theta) * left / GRAVITY)]) / g.gain
    wish = float(np.linalg.norm(angles))
    angles = angles * min(1.0, g.tilt_max / max(wish, 1e-12))
    turn = np.angle(np.exp(1j * (aim.yaw - where.yaw)))
    climb = np.clip(g.height * (aim.height - where.height), -g.climb_max, g.climb_max)
    spin = float(np.clip(g.yaw * turn, -g.turn_max, g.turn_max))
    return ControlOutput(float(angles[0]), float(angles[1]), float(climb), spin, wish)


@given(aims, wheres, st.floats(0.5, 1.5))
def test_mode_default_matches_its_vector_twin(
    aim: ControlReference, where: ControlState, gain: float
) -> None:
    gains = GAINS._replace(gain=gain)
    expected = twin(aim, where, gains)
    if abs(abs(np.angle(np.exp(1j * (aim.yaw - where.yaw)))) - pi) < 1e-6:
        return
    assert tuple(control_output(aim, where, gains)) == pytest.approx(tuple(expected), abs=1e-12)


@given(aims, wheres, st.sampled_from([0.0, pi]))
def test_mode_paper_commands_the_axis_of_its_state_alone(
    aim: ControlReference, where: ControlState, heading: float
) -> None:
    aim = aim._replace(yaw=heading)
    whole = twin(
        aim._replace(velocity=(0.0, 0.0), acceleration=(0.0, 0.0)),
        where._replace(disturbance=(0.0, 0.0)),
        GAINS,
    )
    assert paper_control_output(0, aim, where, GAINS) == ControlOutput(0.0, 0.0, 0.0, 0.0, 0.0)
    assert tuple(paper_control_output(1, aim, where, GAINS)) == pytest.approx(
        (0.0, 0.0, whole.vz, 0.0, 0.0), abs=1e-12
    )
    yaw_only = paper_control_output(2, aim, where, GAINS)
    assert yaw_only[:3] == (0.0, 0.0, 0.0) and abs(yaw_only.yaw_rate) == pytest.approx(
        abs(whole.yaw_rate), abs=1e-9
    )
    e = np.array(aim.position) - where.position
    a = GAINS.beta * e - GAINS.alpha * np.array(where.velocity)
    sign = 1.0 if heading == 0.0 else -1.0
    theta = atan2(sign * a[0], GRAVITY)
    phi = -atan2(np.cos(theta) * sign * a[1], GRAVITY)
    path = paper_control_output(3, aim, where, GAINS)
    assert path[:2] == pytest.approx(
        (np.clip(theta, -0.21, 0.21), np.clip(phi, -0.21, 0.21)), abs=1e-12
    )
    assert path[2:4] == (0.0, 0.0) and path.wish == pytest.approx(max(abs(theta), abs(phi)))


def test_without_the_wrap_the_heading_error_at_the_cut_is_a_full_turn() -> None:
    aim = ControlReference((0.0, 0.0), (0.0, 0.0), (0.0, 0.0), 1.0, pi)
    where = ControlState((0.0, 0.0), (0.0, 0.0), (0.0, 0.0), 1.0, -pi + 0.01)
    assert paper_control_output(2, aim, where, GAINS).yaw_rate == pytest.approx(-0.01 * GAINS.yaw)
    assert (
        paper_control_output(2, aim, where, GAINS._replace(wraps=False)).yaw_rate == GAINS.turn_max
    )


@given(st.tuples(*[st.floats(-5.0, 5.0)] * 4))
def test_limits_make_smaller_and_never_larger(asked: tuple[float, float, float, float]) -> None:
    passed = limited(*asked, 0.21, 0.7, 1.75)
    assert passed == pytest.approx(
        tuple(np.clip(asked, [-0.21, -0.21, -0.7, -1.75], [0.21, 0.21, 0.7, 1.75]))
    )


def test_an_age_that_is_no_number_is_too_old() -> None:
    assert too_old(float("nan"), 1.0) and too_old(1.1, 1.0) and not too_old(1.0, 1.0)
