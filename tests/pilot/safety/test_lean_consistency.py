"""What tracked motion and the reported lean say of each other, in true and in wrong frames."""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, pi, sin

from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.geometry import GRAVITY, Vec2
from housefly.pilot.safety.lean_consistency import LeanConsistency

DT = 0.01
leans = st.lists(st.tuples(st.floats(-0.2, 0.2), st.floats(-0.2, 0.2)), min_size=4, max_size=12)
"""Pitch and roll, each for half a second [rad]."""
headings = st.floats(-pi, pi)
gusts = st.lists(st.tuples(st.floats(-0.7, 0.7), st.floats(-0.7, 0.7)), min_size=8, max_size=8)
"""Acceleration by moving air, each for half a second [m/s^2]."""


def flown(leans: list[Vec2], yaw: float, drag: float = 0.5) -> Iterator[tuple[Vec2, float, float]]:
    """Yield the true velocity, pitch and roll, a hundred times a second."""
    vx = vy = 0.0
    for theta, phi in leans:
        for _ in range(50):
            ahead, left = GRAVITY * sin(theta), -GRAVITY * sin(phi)
            vx += DT * (cos(yaw) * ahead - sin(yaw) * left - drag * vx)
            vy += DT * (sin(yaw) * ahead + cos(yaw) * left - drag * vy)
            yield (vx, vy), theta, phi


@settings(max_examples=30)
@given(leans, headings)
def test_a_true_frame_is_never_called_mirrored(leans: list[Vec2], yaw: float) -> None:
    watch = LeanConsistency()
    assert not any(watch.is_mirrored(DT, v, yaw, *lean) for v, *lean in flown(leans, yaw))


@settings(max_examples=30)
@given(gusts, st.floats(2.0, 6.0), st.floats(1.5, 4.0), st.floats(0.05, 0.3))
def test_a_drone_that_holds_its_place_in_gusts_is_never_called_mirrored(
    gusts: list[Vec2], stiffness: float, damping: float, lag: float
) -> None:
    watch = LeanConsistency()
    assert not any(
        watch.is_mirrored(DT, v, 0.0, *lean) for v, *lean in held(gusts, stiffness, damping, lag)
    )


def held(
    gusts: list[Vec2], stiffness: float, damping: float, lag: float
) -> Iterator[tuple[Vec2, float, float]]:
    """Yield velocity, pitch and roll of a drone that leans against where gusts blow it."""
    place, velocity, lean = [0.0, 0.0], [0.0, 0.0], [0.0, 0.0]
    for gust in gusts:
        for _ in range(50):
            for axis in (0, 1):
                asked = -stiffness * place[axis] - damping * velocity[axis]
                asked = min(max(asked / GRAVITY, -0.25), 0.25)
                lean[axis] += DT / lag * (asked - lean[axis])
                velocity[axis] += DT * (GRAVITY * sin(lean[axis]) + gust[axis])
                place[axis] += DT * velocity[axis]
            yield (velocity[0], velocity[1]), lean[0], -lean[1]


@settings(max_examples=30)
@given(st.floats(0.08, 0.2), st.booleans(), headings)
def test_motion_along_a_mirrored_axis_is_found_within_two_seconds(
    tilt: float, is_back: bool, yaw: float
) -> None:
    watch, tilt = LeanConsistency(), -tilt if is_back else tilt
    flight = flown([(tilt * cos(yaw + pi / 2), tilt * sin(yaw + pi / 2))] * 4, yaw)
    assert any(watch.is_mirrored(DT, (vx, -vy), yaw, theta, phi) for (vx, vy), theta, phi in flight)


def test_a_frame_that_is_turned_by_half_a_turn_is_found() -> None:
    watch = LeanConsistency()
    flight = flown([(0.15, 0.0)] * 2 + [(-0.1, 0.05)] * 2, 0.3)
    assert any(watch.is_mirrored(DT, (-x, -y), 0.3, *lean) for (x, y), *lean in flight)


def test_a_hover_says_nothing() -> None:
    watch = LeanConsistency()
    flight = flown([(0.01, -0.01), (-0.01, 0.01)] * 10, 0.0)
    assert not any(watch.is_mirrored(DT, (-x, -y), 0.0, *lean) for (x, y), *lean in flight)
