"""The top of a piece of furniture: how far it is, and its nearest point."""

from __future__ import annotations

from math import cos, hypot, sin

from hypothesis import given
from hypothesis import strategies as st

from housefly.hub.things.surfaces import Surface

_METRES = st.floats(-5.0, 5.0)
_HALF = st.floats(0.1, 1.5)


@st.composite
def surfaces(draw: st.DrawFn) -> Surface:
    disc = draw(st.booleans())
    half = draw(_HALF)
    return Surface(
        "table",
        "table",
        (draw(_METRES), draw(_METRES)),
        (half, half if disc else draw(_HALF)),
        0.7,
        draw(st.floats(-3.0, 3.0)),
        disc,
    )


@given(surfaces(), _METRES, _METRES)
def test_the_nearest_point_lies_on_the_top_and_is_as_far_as_the_top(
    surface: Surface, x: float, y: float
) -> None:
    u, v, height = surface.nearest((x, y))
    assert height == surface.top
    assert surface.distance((u, v)) < 1e-6
    assert abs(surface.distance((x, y)) - hypot(x - u, y - v)) < 1e-9


@given(surfaces(), st.floats(-0.99, 0.99), st.floats(-0.99, 0.99))
def test_what_is_above_the_top_is_at_distance_zero(surface: Surface, a: float, b: float) -> None:
    along, across = a * surface.half[0], b * surface.half[1]
    if surface.disc and hypot(along, across) > surface.half[0]:
        return
    c, s = cos(surface.yaw), sin(surface.yaw)
    x = surface.centre[0] + along * c - across * s
    y = surface.centre[1] + along * s + across * c
    assert surface.distance((x, y)) < 1e-9
