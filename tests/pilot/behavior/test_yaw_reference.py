from __future__ import annotations

from math import inf, nan, pi

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from housefly.pilot.behavior.yaw_reference import (
    YAW_REFERENCE_RATE,
    YawReference,
    yaw_reference_advanced,
)

angles = st.floats(-pi, pi)


@given(angles, angles, angles, st.floats(0.0, 0.1))
@example(0.0, -pi, 0.0, 0.0625)
def test_the_heading_turns_the_short_way_no_faster_than_allowed(
    reference: float, wish: float, yaw: float, dt: float
) -> None:
    found = yaw_reference_advanced(YawReference(0.0, reference), wish, yaw, YAW_REFERENCE_RATE * dt)
    turned = np.angle(np.exp(1j * (found.reference - reference)))
    left = np.angle(np.exp(1j * (wish - reference)))
    assert abs(turned) == pytest.approx(min(abs(left), YAW_REFERENCE_RATE * dt), abs=1e-9)
    assert -pi < found.reference <= pi
    assert turned * left >= -1e-12 or abs(left) > pi - 1e-9, (
        "half a turn is as short one way as the other"
    )


def test_without_a_wish_the_last_target_stays_or_the_present_heading() -> None:
    assert yaw_reference_advanced(YawReference(0.0, nan), nan, 0.7, 0.01) == YawReference(0.7, 0.7)
    assert yaw_reference_advanced(YawReference(0.4, 0.1), nan, 0.7, 9.0) == YawReference(0.4, 0.4)


def test_the_heading_of_mode_paper_jumps() -> None:
    found = yaw_reference_advanced(YawReference(0.0, 0.0), pi, 0.1, inf)
    assert found == YawReference(pi, pi)
