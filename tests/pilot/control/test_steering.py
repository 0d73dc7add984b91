from __future__ import annotations

from math import atan2, hypot, inf, pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.site import Site
from housefly.geometry import GRAVITY
from housefly.pilot.behavior.acceptor import AcceptorState
from housefly.pilot.control.steering import (
    ControlOutput,
    ControlReference,
    Gains,
    control_output,
    paper_control_output,
)
from housefly.pilot.estimation.estimator_state import ControlState
from housefly.pilot.site_parameters import gains_of

SITE = Site()
GAINS = gains_of(SITE.drone, SITE.control, SITE.limits)
HERE = ControlState((1.0, 2.0), (0.0, 0.0), (0.0, 0.0), 1.1, 0.0)
AT_REST = ControlReference((1.0, 2.0), (0.0, 0.0), (0.0, 0.0), 1.1, 0.0)
pair = st.tuples(st.floats(-5.0, 5.0), st.floats(-5.0, 5.0))
pairs = st.tuples(st.floats(-0.4, 0.4), st.floats(-0.4, 0.4))
aims = st.builds(
    ControlReference,
    *(pairs, pairs, pairs),
    *(st.floats(0.5, 2.0), st.floats(-pi, pi)),
    *(st.floats(-1.0, 1.0), st.floats(-1.0, 1.0), st.floats(0.0, 0.5)),
)
wheres = st.builds(
    ControlState,
    pairs,
    pairs,
    pairs,
    st.floats(0.5, 2.0),
    st.floats(-pi, pi),
    climb=st.just(0.0),
    lift=st.just(0.0),
    delay_change=st.just(0.0),
    bandwidth=st.just(inf),
)


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
    turn = np.angle(np.exp(1j * (aim.yaw - where.yaw)))
    spin = float(np.clip(g.yaw * turn + aim.turn, -g.turn_max, g.turn_max))
    heading = where.yaw + aim.lead * spin
    c, s = np.cos(heading), np.sin(heading)
    forward, left = np.array([[c, s], [-s, c]]) @ a
    theta = np.arctan(forward / GRAVITY)
    angles = np.array([theta, -np.arctan(np.cos(theta) * left / GRAVITY)]) / g.gain
    wish = float(np.linalg.norm(angles))
    angles = angles * min(1.0, g.tilt_max / max(wish, 1e-12))
    climb = g.height * (aim.height - where.height) + aim.climb
    climb = np.clip(climb, -g.climb_max, g.climb_max)
    tilt = float(angles[0]), float(angles[1])
    return ControlOutput(*tilt, float(climb), spin, wish, float(a[0]), float(a[1]))


@given(aims, wheres, st.floats(0.5, 1.5))
def test_mode_default_matches_its_vector_twin(
    aim: ControlReference, where: ControlState, gain: float
) -> None:
    gains = GAINS._replace(gain=gain)
    expected = twin(aim, where, gains)
    turn = aim.yaw - where.yaw
    if abs(abs(np.angle(np.exp(1j * turn))) - pi) < 1e-6:
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
    still = paper_control_output(AcceptorState.HOVER, aim, where, GAINS)
    assert still == ControlOutput(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    climb = paper_control_output(AcceptorState.ALTITUDE_CONTROL, aim, where, GAINS)
    assert tuple(climb) == pytest.approx((0.0, 0.0, whole.vz, 0.0, 0.0, 0.0, 0.0), abs=1e-12)
    turn = paper_control_output(AcceptorState.YAW_CONTROL, aim, where, GAINS)
    assert turn[:3] == (0.0, 0.0, 0.0)
    assert abs(turn.yaw_rate) == pytest.approx(abs(whole.yaw_rate), abs=1e-9)
    e = np.array(aim.position) - where.position
    a = GAINS.beta * e - GAINS.alpha * np.array(where.velocity)
    sign = 1.0 if heading == 0.0 else -1.0
    theta = atan2(sign * a[0], GRAVITY)
    phi = -atan2(np.cos(theta) * sign * a[1], GRAVITY)
    path = paper_control_output(AcceptorState.PATH_TRACKING, aim, where, GAINS)
    assert path[:2] == pytest.approx(
        (np.clip(theta, -0.21, 0.21), np.clip(phi, -0.21, 0.21)), abs=1e-12
    )
    assert path[2:4] == (0.0, 0.0) and path.wish == pytest.approx(max(abs(theta), abs(phi)))
    assert (path.ax, path.ay) == pytest.approx(tuple(a))


def test_without_the_wrap_the_heading_error_at_the_cut_is_a_full_turn() -> None:
    aim = ControlReference((0.0, 0.0), (0.0, 0.0), (0.0, 0.0), 1.0, pi)
    where = ControlState((0.0, 0.0), (0.0, 0.0), (0.0, 0.0), 1.0, -pi + 0.01)
    asked = paper_control_output(AcceptorState.YAW_CONTROL, aim, where, GAINS)
    assert asked.yaw_rate == pytest.approx(-0.01 * GAINS.yaw)
    literal = GAINS._replace(wraps=False)
    unwrapped = paper_control_output(AcceptorState.YAW_CONTROL, aim, where, literal)
    assert unwrapped.yaw_rate == GAINS.turn_max


def test_a_drone_that_is_where_it_should_be_is_told_nothing() -> None:
    s = control_output(AT_REST, HERE, GAINS)
    assert tuple(s) == pytest.approx((0.0,) * 7)


def test_a_drone_that_moves_with_its_reference_is_only_told_to_overcome_drag() -> None:
    delay = SITE.drone.command_delay
    aim = ControlReference((1.0, 2.0), (0.5, 0.0), (0.0, 0.0), 1.1, 0.0)
    where = ControlState((1.0 + 0.5 * delay, 2.0), (0.5, 0.0), (0.0, 0.0), 1.1, 0.0)
    leaned = SITE.drone.drag * 0.5 / GRAVITY
    assert control_output(aim, where, GAINS).theta == pytest.approx(leaned, abs=1e-3)


@pytest.mark.parametrize("mode", ["default", "paper"])
def test_the_demanded_acceleration_is_known_beyond_what_the_tilt_limit_leaves(mode: str) -> None:
    aim = ControlReference((6.0, 2.0), (0.0, 0.0), (0.0, 0.0), 1.1, 0.0)
    asked = (
        paper_control_output(AcceptorState.PATH_TRACKING, aim, HERE, GAINS)
        if mode == "paper"
        else control_output(aim, HERE, GAINS)
    )
    assert asked.theta == pytest.approx(GAINS.tilt_max)
    assert (asked.ax, asked.ay) == pytest.approx((5.0 * GAINS.beta, 0.0))


def test_a_disturbance_is_leaned_against() -> None:
    pushed = ControlState((1.0, 2.0), (0.0, 0.0), (0.2, -0.1), 1.1, 0.0)
    s = control_output(AT_REST, pushed, GAINS)
    assert s.theta < 0.0 and s.phi < 0.0


@given(pair, pair, st.floats(-pi, pi))
def test_mode_default_never_tilts_further_than_allowed_in_any_direction(
    place: tuple[float, float], v: tuple[float, float], yaw: float
) -> None:
    s = control_output(AT_REST, ControlState(place, v, (0.0, 0.0), 0.0, yaw), GAINS)
    assert hypot(s.theta, s.phi) <= SITE.limits.tilt_max + 1e-12
    assert (
        abs(s.vz) <= SITE.limits.vertical_speed_max and abs(s.yaw_rate) <= SITE.limits.yaw_rate_max
    )


@pytest.mark.parametrize("yaw", [0.0, pi])
def test_mode_paper_pushes_towards_the_waypoint_at_both_of_its_headings(yaw: float) -> None:
    aim = ControlReference((1.5, 2.0), (0.0, 0.0), (0.0, 0.0), 1.1, yaw)
    where = HERE._replace(yaw=yaw)
    asked = paper_control_output(AcceptorState.PATH_TRACKING, aim, where, GAINS)
    assert (asked.theta > 0.0) == (yaw == 0.0)


def test_mode_paper_clips_each_axis_by_itself() -> None:
    far = ControlReference((9.0, 2.3), (0.0, 0.0), (0.0, 0.0), 1.1, 0.0)
    s = paper_control_output(AcceptorState.PATH_TRACKING, far, HERE, GAINS)
    assert s.theta == SITE.limits.tilt_max and 0.0 < -s.phi < SITE.limits.tilt_max


COMPENSATED = GAINS._replace(climb_lag=1.4, inverts_climb=True, sink_gain=2.0)


def test_a_load_is_carried_by_a_commanded_climb_and_an_updraught_by_half_the_sinking() -> None:
    loaded, lifted = HERE._replace(lift=-0.49), HERE._replace(lift=0.49)
    assert control_output(AT_REST, loaded, COMPENSATED).vz == pytest.approx(0.35)
    assert control_output(AT_REST, lifted, COMPENSATED).vz == pytest.approx(-0.175)
    assert control_output(AT_REST, loaded, GAINS).vz == 0.0


def test_however_heavy_the_load_the_climb_stays_within_its_limit() -> None:
    heavy = HERE._replace(lift=-1.5, height=0.2)
    assert control_output(AT_REST, heavy, COMPENSATED).vz == GAINS.climb_max


@given(aims, wheres, st.floats(0.2, 1.7))
def test_little_bandwidth_softens_the_loop_and_keeps_its_damping(
    aim: ControlReference, where: ControlState, bandwidth: float
) -> None:
    share = bandwidth / GAINS.beta**0.5
    soft = GAINS._replace(alpha=share * GAINS.alpha, beta=share * share * GAINS.beta)
    limited = control_output(aim, where._replace(bandwidth=bandwidth), GAINS)
    assert tuple(limited) == pytest.approx(tuple(control_output(aim, where, soft)), abs=1e-9)


@given(aims, wheres)
def test_without_feed_forward_the_reference_only_stands_still(
    aim: ControlReference, where: ControlState
) -> None:
    still = aim._replace(velocity=(0.0, 0.0), acceleration=(0.0, 0.0))
    unled = control_output(aim, where, GAINS._replace(feed_forward=0.0))
    assert tuple(unled) == pytest.approx(tuple(control_output(still, where, GAINS)), abs=1e-12)


@given(aims, wheres, st.floats(-0.05, 0.1))
def test_a_delay_found_in_flight_counts_as_one_of_the_site(
    aim: ControlReference, where: ControlState, change: float
) -> None:
    found = control_output(aim, where._replace(delay_change=change), GAINS)
    known = control_output(aim, where, GAINS._replace(delay=GAINS.delay + change))
    assert tuple(found) == pytest.approx(tuple(known), abs=1e-9)
