from __future__ import annotations

from math import hypot, pi

import pytest
from housefly.pilot.control.autopilot import Autopilot
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.site import Site
from housefly.messages import Action, Behavior
from housefly.pilot.control.steering import ControlReference
from housefly.pilot.estimation.estimator import ControlState

SITE = Site()
AUTOPILOT = Autopilot(SITE)
HERE = ControlState((1.0, 2.0), (0.0, 0.0), (0.0, 0.0), 1.1, 0.0)
AT_REST = ControlReference((1.0, 2.0), (0.0, 0.0), (0.0, 0.0), 1.1, 0.0)
pair = st.tuples(st.floats(-5.0, 5.0), st.floats(-5.0, 5.0))


def test_a_drone_that_is_where_it_should_be_is_told_nothing() -> None:
    s = AUTOPILOT.default(AT_REST, HERE).setpoint
    assert (s.theta, s.phi, s.vz, s.yaw_rate) == pytest.approx((0.0, 0.0, 0.0, 0.0))


def test_a_drone_that_moves_with_its_reference_is_only_told_to_overcome_drag() -> None:
    delay = SITE.drone.command_delay
    aim = ControlReference((1.0, 2.0), (0.5, 0.0), (0.0, 0.0), 1.1, 0.0)
    where = ControlState((1.0 + 0.5 * delay, 2.0), (0.5, 0.0), (0.0, 0.0), 1.1, 0.0)
    assert AUTOPILOT.default(aim, where).setpoint.theta == pytest.approx(
        SITE.drone.drag * 0.5 / 9.80665, abs=1e-3
    )


def test_a_disturbance_is_leaned_against() -> None:
    pushed = ControlState((1.0, 2.0), (0.0, 0.0), (0.2, -0.1), 1.1, 0.0)
    s = AUTOPILOT.default(AT_REST, pushed).setpoint
    assert s.theta < 0.0 and s.phi < 0.0


@given(pair, pair, st.floats(-pi, pi))
def test_mode_default_never_tilts_further_than_allowed_in_any_direction(
    place: tuple[float, float], v: tuple[float, float], yaw: float
) -> None:
    s = AUTOPILOT.default(AT_REST, ControlState(place, v, (0.0, 0.0), 0.0, yaw)).setpoint
    assert hypot(s.theta, s.phi) <= SITE.limits.tilt_max + 1e-12
    assert (
        abs(s.vz) <= SITE.limits.vertical_speed_max and abs(s.yaw_rate) <= SITE.limits.yaw_rate_max
    )


@pytest.mark.parametrize("yaw", [0.0, pi])
def test_mode_paper_pushes_towards_the_waypoint_at_both_of_its_headings(yaw: float) -> None:
    aim = ControlReference((1.5, 2.0), (0.0, 0.0), (0.0, 0.0), 1.1, yaw)
    command = AUTOPILOT.paper(
        Behavior.PATH_TRACKING, aim, ControlState((1.0, 2.0), (0.0, 0.0), (0.0, 0.0), 1.1, yaw)
    )
    assert (command.setpoint.theta > 0.0) == (yaw == 0.0)


def test_mode_paper_clips_each_axis_by_itself_and_hovers_by_the_drones_own_means() -> None:
    far = ControlReference((9.0, 2.3), (0.0, 0.0), (0.0, 0.0), 1.1, 0.0)
    s = AUTOPILOT.paper(Behavior.PATH_TRACKING, far, HERE).setpoint
    assert s.theta == SITE.limits.tilt_max and 0.0 < -s.phi < SITE.limits.tilt_max
    assert AUTOPILOT.paper(Behavior.HOVER, far, HERE).action is Action.HOVER
