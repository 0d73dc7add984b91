"""The tracking frame against the map: found exactly, and every doubt told."""

from __future__ import annotations

from math import cos, hypot, pi, sin

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from housefly.config.tracking import TrackingConfig
from housefly.errors import ConfigError
from housefly.messages import Pose, Sighting
from housefly.numeric import wrapped
from housefly.room.draft.alignment import fit_words, rigid_fit
from housefly.room.draft.model import FramePoint
from housefly.tracking.map_frame import MapFrame

metres = st.floats(-20.0, 20.0)
THREE = ((1.0, 2.0), (5.0, 2.0), (1.0, 4.0))


def points_seen(
    places: tuple[tuple[float, float], ...],
    shift: tuple[float, float, float] = (0.0, 0.0, 0.0),
    turn: float = 0.0,
    scale: float = 1.0,
    mirror: float = 1.0,
) -> tuple[FramePoint, ...]:
    """Return points as a tracking system sees them whose origin is at shift, turned by turn."""
    points = []
    for x, y in places:
        dx, dy = x - shift[0], y - shift[1]
        a, b = cos(turn) * dx + sin(turn) * dy, -sin(turn) * dx + cos(turn) * dy
        seen = (scale * a, mirror * scale * b, scale * (0.05 - shift[2]))
        points.append(FramePoint(f"({x:g}, {y:g})", (x, y, 0.05), seen))
    return tuple(points)


@given(st.lists(st.tuples(metres, metres), min_size=2, max_size=6), metres, metres,
       st.floats(-3.0, 3.0), st.floats(-pi, pi))  # fmt: skip
def test_any_turn_and_shift_is_found_and_the_pilot_then_sees_the_map(
    places: list[tuple[float, float]], x: float, y: float, z: float, turn: float
) -> None:
    assume(hypot(*(max(p[k] for p in places) - min(p[k] for p in places) for k in (0, 1))) > 1.0)
    points = points_seen(tuple(places), (x, y, z), turn)
    try:
        fit = rigid_fit(points)
    except ConfigError:
        # Seen turned, their extents along the axes may be below the least distance.
        return
    assert abs(wrapped(fit.yaw - turn)) < 1e-3
    assert max(fit.residuals) < 1e-3
    frame = MapFrame(TrackingConfig(x=fit.x, y=fit.y, z=fit.z, yaw=fit.yaw))
    for point in points:
        seen = frame.on_map(Sighting("ardrone", Pose(point.seen), 0.0, 0.0))
        assert seen.pose.position == pytest.approx(point.on_map, abs=5e-3)


def test_three_good_points_leave_nothing_to_say() -> None:
    points = points_seen(THREE, (2.0, -1.0, 0.3), -pi / 2)
    fit = rigid_fit(points)
    assert fit.is_trusted
    assert len(fit_words(fit, points)) == 2
    assert "-90.0 deg" in fit_words(fit, points)[0]


def test_a_point_that_was_put_wrongly_is_named() -> None:
    good = points_seen((*THREE, (5.0, 4.0)), (2.0, -1.0, 0.0), 0.4)
    x, y, z = good[1].seen
    bad = (good[0], FramePoint(good[1].name, good[1].on_map, (x + 0.4, y, z)), *good[2:])
    fit = rigid_fit(bad)
    assert not fit.is_trusted
    assert f"{bad[1].name} worst" in " ".join(fit_words(fit, bad))


def test_a_mirrored_frame_is_told_and_not_taken_for_a_turn() -> None:
    points = points_seen(THREE, turn=0.3, mirror=-1.0)
    fit = rigid_fit(points)
    assert fit.is_mirrored and not fit.is_trusted
    assert "mirror" in " ".join(fit_words(fit, points))


def test_millimetres_are_told() -> None:
    points = points_seen(THREE, turn=0.3, scale=1000.0)
    fit = rigid_fit(points)
    assert not fit.is_trusted
    assert "a metre as 1000 m" in " ".join(fit_words(fit, points))


def test_a_small_error_of_scale_is_told_though_near_points_leave_little() -> None:
    points = points_seen(((1.0, 1.0), (1.6, 1.0), (1.0, 1.6)), scale=1.07)
    fit = rigid_fit(points)
    assert max(fit.residuals) < 0.05
    assert not fit.is_trusted


def test_points_that_are_nearly_on_one_line_are_not_called_mirrored_for_their_noise() -> None:
    points = points_seen(((1.0, 1.0), (3.0, 1.03), (5.0, 1.0)), mirror=-1.0)
    fit = rigid_fit(points)
    assert not fit.is_mirrored
    assert "one line" in " ".join(fit_words(fit, points))


def test_a_mirrored_axis_shows_though_the_points_leave_little() -> None:
    points = points_seen(((1.0, 1.0), (4.0, 1.0), (1.0, 1.6)), mirror=-1.0)
    assert rigid_fit(points).is_mirrored


def test_two_points_ask_for_a_third_and_one_is_refused() -> None:
    points = points_seen(THREE[:2])
    assert "third" in fit_words(rigid_fit(points), points)[-1]
    with pytest.raises(ConfigError, match="two points are needed"):
        rigid_fit(points[:1])


def test_points_that_lie_together_are_refused_with_what_to_do() -> None:
    with pytest.raises(ConfigError, match="several metres"):
        rigid_fit(points_seen(((1.0, 1.0), (1.1, 1.0), (1.0, 1.2))))


def test_points_on_one_line_cannot_show_a_mirrored_axis_and_that_is_told() -> None:
    points = points_seen(((1.0, 1.0), (2.0, 1.0), (4.0, 1.0)))
    assert "one line" in " ".join(fit_words(rigid_fit(points), points))
