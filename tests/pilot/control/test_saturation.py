"""At a limit: the tilt keeps its direction, and what the limit takes away teaches no filter."""

from __future__ import annotations

from math import atan2

import pytest
from climb_bench import ClimbBench
from hypothesis import given
from hypothesis import strategies as st

from housefly.numeric import clipped
from housefly.pilot.control.laws import climb_rate, compensated_climb_rate, saturated_jointly

TICK, POLE, GAIN, CLIMB_MAX = 0.01, 1.4, 1.2, 0.5
angles = st.floats(-1.0, 1.0).filter(lambda angle: abs(angle) > 1e-6)


@given(angles, angles, st.floats(0.05, 0.4))
def test_a_limited_tilt_keeps_its_direction_within_a_circle(
    theta: float, phi: float, bound: float
) -> None:
    x, y = saturated_jointly(theta, phi, bound)
    assert x * x + y * y <= bound * bound * (1.0 + 1e-12)
    assert atan2(y, x) == pytest.approx(atan2(phi, theta))


def held(seconds: float, gone_at: float, told_limits: bool) -> tuple[float, float, float]:
    """Hold 1 m under a load that is too heavy for the limit, until it is gone.

    Returns:
        lift believed when it goes, how far the drone then shoots up, where it is at the end.
    """
    bench, z, w = ClimbBench(0.06), 1.0, 0.0
    under_way = [0.0] * 7
    believed, highest = 0.0, 0.0
    for n in range(round(seconds / TICK)):
        at = n * TICK
        lift = -1.2 if at < gone_at else 0.0
        ahead = bench.look(at + 0.06)
        wanted = climb_rate(1.0, ahead.z, GAIN, 0.0, CLIMB_MAX)
        asked = compensated_climb_rate(wanted, ahead.w, ahead.d, GAIN, POLE)
        given_ = clipped(asked, CLIMB_MAX)
        given_ = given_ if given_ >= 0.0 else 0.5 * given_
        bench.give(at, given_ if told_limits else asked)
        under_way.append(given_)
        u = under_way[-7]
        w += TICK * (POLE * ((u if u >= 0.0 else 2.0 * u) - w) + lift)
        z += TICK * w
        if n > 1:
            bench.see(at + 0.5 * TICK, z)
        if at < gone_at:
            believed = bench.climb.axis.d
        else:
            highest = max(highest, z)
    return believed, highest - 1.0, z


def test_a_load_beyond_the_limit_is_known_for_what_it_is_and_leaves_nothing_behind() -> None:
    believed, overshoot, end = held(9.0, 3.0, told_limits=True)
    assert believed == pytest.approx(-1.2, abs=0.05)
    assert overshoot < 0.12
    assert end == pytest.approx(1.0, abs=0.01)


def test_a_filter_that_is_not_told_of_the_limit_winds_up() -> None:
    believed, _, _ = held(3.2, 3.0, told_limits=False)
    assert believed < -1.4
