"""The delay of tracking against the drone's own heading."""

from __future__ import annotations

from math import pi, tanh

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.lab.frames.guide import tracking_lag
from housefly.lab.frames.samples import OnboardPoint, TrackedPoint
from housefly.numeric import wrapped


def heading(at: float) -> float:
    return (tanh(1.5 * (at - 5.0)) + 1.0) * pi / 4


def tracked(lag: float, sign: float = 1.0, offset: float = 0.0) -> tuple[TrackedPoint, ...]:
    times = [0.02 * n for n in range(500)]
    return tuple(
        TrackedPoint(at, (0.0, 0.0, 0.0), wrapped(sign * heading(at - lag) + offset))
        for at in times
    )


ONBOARD = tuple(OnboardPoint(n / 15.0, wrapped(heading(n / 15.0) + 3.0), 0.0) for n in range(150))


@settings(max_examples=30)
@given(st.floats(-0.6, 0.6), st.sampled_from((1.0, -1.0)), st.floats(-pi, pi))
def test_it_is_found_whatever_the_offset_and_when_mirrored(lag, sign, offset):
    assert tracking_lag(tracked(lag, sign, offset), ONBOARD) == pytest.approx(lag, abs=0.02)


def test_without_a_turn_without_a_report_and_across_a_hole_nothing_is_said() -> None:
    still = tuple(OnboardPoint(point.at, 1.0, 0.0) for point in ONBOARD)
    assert tracking_lag(tracked(0.1), still) is None
    assert tracking_lag(tracked(0.1), ()) is None
    holed = tuple(point for point in tracked(0.1) if not 4.5 < point.at < 5.5)
    assert tracking_lag(holed, ONBOARD) is None
