"""A patrol of the whole floor against brute force in small rooms."""

from __future__ import annotations

from itertools import combinations
from math import atan2, cos, hypot, pi, sin, tan

import numpy as np
from hypothesis import Phase, given, settings
from small_rooms import box, small_viewing_rooms, viewing_room

from housefly.config.site import Site
from housefly.geometry import Vec2, heading_to
from housefly.room.level_camera import LevelCamera
from housefly.room.model import Solid
from housefly.tasks.vantage.camera_views import HEADINGS, VIEW_RANGE, camera_views
from housefly.tasks.vantage.patrol import (
    WHOLE_MOST,
    floor_share,
    patrol_viewpoints,
    shown_share,
    visible_floor,
)
from housefly.tasks.vantage.viewing_room import ViewingRoom

FRONT_CAMERA = LevelCamera.of(Site().drone.airframe.capabilities.camera)

PHASES = (Phase.explicit, Phase.reuse, Phase.generate)
"""A failure is told as it was found: making it smaller takes minutes."""
SAMPLES = np.linspace(0.0, 0.999, 300)
GROWN = 0.05
"""What is so near to an edge, or in a surface, may count as seen or not [m]."""


def floor_points(viewing: ViewingRoom) -> np.ndarray:
    x1, y1 = viewing.room.bounds[2:]
    xs, ys = np.meshgrid(np.arange(0.2, x1, 0.2), np.arange(0.2, y1, 0.2))
    return np.column_stack([xs.ravel(), ys.ravel(), np.full(xs.size, 0.2)])


def is_hidden(eye: np.ndarray, point: np.ndarray, solids: tuple[Solid, ...], grown: float) -> bool:
    line = eye + SAMPLES[:, None] * (point - eye)
    for solid in solids:
        half = np.array(solid.size) / 2 + grown
        if np.any(np.all(np.abs(line - np.array(solid.position)) < half, axis=1)):
            return True
    return False


def is_seen(
    viewing: ViewingRoom, place: Vec2, heading: float, point: np.ndarray, grown: float
) -> bool:
    """Return whether a picture shows a point; ``grown`` makes all that hides larger [m]."""
    here = np.array([*place, viewing.height])
    eye = here + FRONT_CAMERA.ahead * np.array([cos(heading), sin(heading), 0.0])
    ray = point - eye
    depth = ray[0] * cos(heading) + ray[1] * sin(heading)
    aside = ray[1] * cos(heading) - ray[0] * sin(heading)
    slack = np.sign(grown) * 0.01
    return bool(
        depth > 0.0
        and abs(aside) <= depth * tan(FRONT_CAMERA.width / 2) - slack
        and abs(ray[2]) <= depth * tan(FRONT_CAMERA.height / 2) - slack
        and hypot(*(point - here)[:2]) <= VIEW_RANGE - slack
        and not is_hidden(here, point, viewing.room.solids, grown)
    )


@settings(max_examples=6, deadline=None, phases=PHASES)
@given(small_viewing_rooms)
def test_the_whole_floor_is_seen_as_far_as_any_view_sees_it(viewing: ViewingRoom) -> None:
    there = viewing.reachable(viewing.room.home, (), viewing.site.people.comfort_distance, 0.0)
    views = patrol_viewpoints(viewing, whole=True)
    assert len(views) <= WHOLE_MOST
    all_views = camera_views(viewing, there, floor_points(viewing))
    lattice = {tuple(place) for place in all_views.places.tolist()}
    assert bool(views) == bool(lattice)
    poses = [(view.position, heading_to(view.position, view.look_at[:2])) for view in views]
    turns = [2.0 * pi * n / HEADINGS for n in range(HEADINGS)]
    points, visible = visible_floor(viewing)
    for point, known in zip(points, visible, strict=True):
        surely = any(is_seen(viewing, p, turn, point, GROWN) for p in lattice for turn in turns)
        perhaps = any(is_seen(viewing, p, turn, point, -GROWN) for p in lattice for turn in turns)
        assert surely <= known <= perhaps
        if surely:
            assert any(is_seen(viewing, *pose, point, -GROWN) for pose in poses)
    if views:
        assert floor_share(views, viewing) == 1.0


@settings(max_examples=8, deadline=None, phases=PHASES)
@given(small_viewing_rooms)
def test_no_view_is_too_many_and_few_would_do_with_less(viewing: ViewingRoom) -> None:
    views = patrol_viewpoints(viewing, whole=True)
    for left_out in views:
        others = [view for view in views if view is not left_out]
        assert floor_share(others, viewing) < 1.0
    there = viewing.reachable(viewing.room.home, (), viewing.site.people.comfort_distance, 0.0)
    points, visible = visible_floor(viewing)
    shown = camera_views(viewing, there, points).shown
    shown = np.unique(shown[:, visible], axis=0)
    for count in (1, 2):
        if any(
            shown[list(rows)].any(axis=0).all() for rows in combinations(range(len(shown)), count)
        ):
            assert len(views) <= count * (np.log(max(1, visible.sum())) + 1.0)
            break


def test_behind_a_box_nothing_is_seen_and_no_picture_shows_nothing() -> None:
    viewing = viewing_room((3.4, 3.4), box("table", 1.7, 2.6, 0.8, 1.0))
    assert shown_share((), viewing) == 0.0
    ahead = shown_share((((1.0, 1.0), atan2(1.0, 1.0)),), viewing)
    away = shown_share((((1.0, 1.0), atan2(-1.0, -1.0)),), viewing)
    assert 0.0 <= away < ahead < 1.0
