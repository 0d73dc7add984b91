from __future__ import annotations

from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.numeric import clipped, wrapped


@given(st.floats(-50.0, 50.0))
def test_a_wrapped_angle_is_the_same_direction_in_one_turn(angle: float) -> None:
    assert -pi < wrapped(angle) <= pi
    assert np.exp(1j * wrapped(angle)) == pytest.approx(np.exp(1j * angle), abs=1e-9)
    assert wrapped(wrapped(angle)) == wrapped(angle)


@given(st.floats(-5.0, 5.0), st.floats(0.0, 3.0))
def test_a_clipped_value_is_the_nearest_within_the_bound(value: float, bound: float) -> None:
    assert clipped(value, bound) == float(np.clip(value, -bound, bound))
