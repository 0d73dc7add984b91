"""Where a drone is kept that is held, and what its driver is told."""

from __future__ import annotations

from math import atan, hypot, pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.geometry import GRAVITY
from housefly.messages.sensing import Estimate
from housefly.messages.steering import KnownMotion
from housefly.pilot.estimation.estimator_state import PoseEstimate
from housefly.pilot.kept_place import HOVER_PUSH_MAX, KeptPlace, known_motion, sinking
from housefly.pilot.step import Guidance

FOLLOWING = Guidance(True, True, 9.0, 9.0, 0.0, 1.0, 1.1, 1.0)
ESTIMATE = Estimate(1.0, (2.0, 3.0, 1.4), (0.5, -0.2, 0.1), 0.7, 0.01, 0.001)


def test_a_drone_that_is_held_on_its_way_is_kept_where_it_comes_to_rest() -> None:
    kept = KeptPlace.of(ESTIMATE, 0.4).guidance(FOLLOWING)
    assert (kept.x, kept.y) == (2.0 + 0.4 * 0.5, 3.0 - 0.4 * 0.2)
    assert (kept.height, kept.yaw, kept.kept) == (1.4, 0.7, True)
    assert kept.following and kept.speed_factor == 0.0, "the reference comes to rest meanwhile"


def test_without_a_place_it_brakes_and_sinks_where_it_seems_to_be() -> None:
    guidance = sinking(ESTIMATE)
    assert (guidance.x, guidance.y) == (2.0, 3.0) and guidance.height < 1.4
    assert guidance.active and not guidance.following


@given(st.floats(-pi, pi), st.floats(-1.0, 1.0), st.floats(-1.0, 1.0))
def test_the_driver_is_told_the_velocity_in_the_body(yaw: float, vx: float, vy: float) -> None:
    here = PoseEstimate(0.0, 0.0, 1.0, vx, vy, 0.0, yaw)
    motion = known_motion(here, (0.0, 0.0), True, True)
    assert motion.forward is not None and motion.left is not None
    assert hypot(motion.forward, motion.left) == pytest.approx(hypot(vx, vy))
    ahead = known_motion(here._replace(yaw=0.0), (0.0, 0.0), True, True)
    assert (ahead.forward, ahead.left) == (vx, vy)


def test_the_driver_is_told_how_to_lean_against_a_push() -> None:
    here = PoseEstimate(0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.5 * pi)
    weak = known_motion(here, (0.0, 0.3), True, True)
    assert weak.theta == pytest.approx(-atan(0.3 / GRAVITY)) and weak.phi == pytest.approx(0.0)
    assert weak.hovers and not known_motion(here, (0.0, HOVER_PUSH_MAX), True, True).hovers


@pytest.mark.parametrize("knows_speed", [True, False])
def test_a_place_that_is_not_believed_is_not_told(knows_speed: bool) -> None:
    here = PoseEstimate(0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0)
    assert known_motion(here, (1.0, 1.0), False, knows_speed) == KnownMotion(hovers=knows_speed)
