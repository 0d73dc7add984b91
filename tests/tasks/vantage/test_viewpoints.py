"""Viewpoints in B-sen: free, reachable, in sight, in the picture, and away from people."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from math import pi, tan

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.config.site import Site
from housefly.errors import TaskError
from housefly.geometry import Vec2, Vec3, distance, heading_to
from housefly.messages import Obstacle, ObstacleKind
from housefly.pilot.assembly import make_pilot
from housefly.pilot.planning.column import StaticColumns
from housefly.room.coverage import seen_by
from housefly.room.distance import half_diagonal
from housefly.room.level_camera import LevelCamera
from housefly.room.sight import hiding_rows, in_sight
from housefly.room.tracked import solids_of
from housefly.sites.loaded_site import LoadedSite, load_site
from housefly.tasks.vantage.subject import (
    Subject,
    furniture_subject,
    person_subject,
    pieces_of,
    place_subject,
    small_subject,
)
from housefly.tasks.vantage.viewing_room import ViewingRoom
from housefly.tasks.vantage.viewpoint import Viewpoint
from housefly.tasks.vantage.viewpoints import find_viewpoint
from housefly.twin.quadrotor.body import FRONT_FIELD_OF_VIEW, PICTURE_SIZE

FRONT_CAMERA = LevelCamera.of(Site().drone.airframe.capabilities.camera)

THINGS = ("refrigerator", "smart shelf", "tv", "bed", "work desk", "sofa table", "tree")


@cache
def site() -> LoadedSite:
    return load_site("bsen")


@cache
def viewing() -> ViewingRoom:
    return ViewingRoom(site().site, site().room, site().grid)


def subjects() -> Iterator[Subject]:
    room = site().room
    yield from (place_subject(place.name, place.look_at) for place in room.places)
    for name in THINGS:
        yield furniture_subject(name, pieces_of(solids_of(room, name))[0], room)
    yield small_subject("cup", (12.85, 2.2, 0.47), room)
    assert room.visitor is not None
    yield person_subject("the visitor", (*room.visitor, 0.0), room, facing=room.visitor_yaw)
    yield person_subject("who lies in bed", (10.35, 2.7, 0.0), room, "lying")


def is_seen(view: Viewpoint, subject: Subject) -> bool:
    """Return whether the point that is faced is in the picture and nothing else is before it."""
    here = np.array([[*view.position, site().site.map.flight_height]])
    target = np.array([view.look_at])
    eye = FRONT_CAMERA.eyes(here, target[0])
    solids = [solid for solid in site().room.solids if solid.name not in subject.own]
    rise = abs(eye[0, 2] - target[0, 2]) / distance(tuple(eye[0, :2]), view.look_at[:2])
    return bool(in_sight(hiding_rows(solids), eye, target)[0, 0]) and rise < tan(0.37)


def test_the_camera_is_the_one_of_the_simulated_drone() -> None:
    across, up = (tan(angle / 2) for angle in (FRONT_CAMERA.width, FRONT_CAMERA.height))
    camera = Site().drone.airframe.capabilities.camera
    assert camera is not None and FRONT_CAMERA.ahead == camera.ahead
    assert FRONT_CAMERA.width == camera.field_of_view
    assert FRONT_CAMERA.height == camera.field_of_view_up
    assert FRONT_CAMERA.width == pytest.approx(FRONT_FIELD_OF_VIEW)
    assert up / across == pytest.approx(PICTURE_SIZE[1] / PICTURE_SIZE[0], rel=0.001)


@pytest.mark.parametrize("subject", list(subjects()), ids=lambda one: one.name)
def test_a_viewpoint_is_free_tracked_in_sight_and_can_be_flown_to(subject: Subject) -> None:
    view = find_viewpoint(viewing(), subject)
    loaded = site()
    assert loaded.plan(view.position).path is not None
    assert is_seen(view, subject)
    place = np.array([[*view.position, loaded.site.map.flight_height]])
    assert seen_by(loaded.room, place).sum() >= 2
    assert view.look_at == subject.look_at
    assert distance(view.position, view.look_at[:2]) < 5.0


def test_the_visitor_is_faced_and_not_the_door() -> None:
    room = site().room
    assert room.visitor is not None
    subject = person_subject("the visitor", (*room.visitor, 0.0), room, facing=room.visitor_yaw)
    view = find_viewpoint(viewing(), subject)
    assert view.look_at[:2] == room.visitor and view.look_at[2] == pytest.approx(1.5)
    away = heading_to(room.visitor, view.position) - room.visitor_yaw
    assert abs(away) < pi / 6


def test_a_thing_in_a_shelf_is_looked_at_from_the_open_side() -> None:
    subject = small_subject("book", (11.5, 4.2, 0.6), site().room)
    view = find_viewpoint(viewing(), subject)
    assert subject.own >= {"smart shelf board 0"} or any("smart shelf" in n for n in subject.own)
    assert view.position[0] > 11.5


_spots = st.tuples(st.floats(5.0, 14.0), st.floats(1.0, 4.5))


@settings(max_examples=25)
@given(_spots, st.lists(_spots, max_size=3))
def test_nobody_is_come_too_near_and_the_pilot_has_a_way(whom: Vec2, others: list[Vec2]) -> None:
    loaded = site()
    config = loaded.site.people
    everybody = tuple(
        Obstacle(f"p{n}", place, config.body_radius, kind=ObstacleKind.PERSON)
        for n, place in enumerate([whom, *others])
    )
    try:
        view = find_viewpoint(
            viewing(), person_subject("p0", (*whom, 0.0), loaded.room), obstacles=everybody
        )
    except TaskError as error:
        assert error.code in ("no_view", "no_way") and str(error).count(".") <= 1
        return
    hull = half_diagonal(loaded.site.drone.hull_length, loaded.site.drone.hull_width)
    for one in everybody:
        apart = distance(view.position, one.position) - hull - config.body_radius
        assert apart >= config.min_distance - 0.15
    cell = loaded.grid.cell_of(view.position)
    assert loaded.grid.is_free(cell)


def test_somebody_in_between_hides_the_subject_and_another_side_is_taken() -> None:
    subject = furniture_subject(
        "refrigerator", pieces_of(solids_of(site().room, "refrigerator"))[0], site().room
    )
    alone = find_viewpoint(viewing(), subject)
    middle = tuple((a + b) / 2 for a, b in zip(alone.position, subject.look_at[:2], strict=True))
    person = Obstacle("p", (middle[0], middle[1]), 0.25, kind=ObstacleKind.PERSON)
    view = find_viewpoint(viewing(), subject, obstacles=(person,))
    assert distance(view.position, alone.position) > 0.5
    hiding = viewing().hiding(subject.own, (person,), subject.look_at[:2], 0.4)
    eye = FRONT_CAMERA.eyes(np.array([[*view.position, 1.1]]), np.array(subject.look_at))
    assert in_sight(hiding, eye, np.array([subject.look_at]))[0, 0]


def test_of_two_sides_the_one_nearer_to_the_drone_is_taken() -> None:
    subject = place_subject("middle", (9.0, 3.4, 1.1))
    west = find_viewpoint(viewing(), subject, (7.0, 3.0, 1.1))
    east = find_viewpoint(viewing(), subject, (13.5, 3.0, 1.1))
    assert west.position[0] < east.position[0]


def closed(at: Vec3) -> str:
    with pytest.raises(TaskError) as refused:
        find_viewpoint(viewing(), place_subject("that", at))
    assert refused.value.code == "no_view"
    return str(refused.value)


def test_why_there_is_no_view_is_said_in_one_sentence() -> None:
    assert "tracking sees it" in closed((30.0, 30.0, 1.0))
    assert "something stands in between" in closed((6.5, 7.5, 1.0))
    assert "nowhere in the picture" in closed((9.0, 3.5, 9.0))


def test_a_drone_in_a_blocked_cell_starts_from_the_next_free_one() -> None:
    loaded = site()
    blocked = (10.0, 2.0)
    assert not loaded.grid.is_free(loaded.grid.cell_of(blocked))
    view = find_viewpoint(viewing(), place_subject("kitchen", (9.03, 5.8, 0.95)), (*blocked, 1.1))
    assert loaded.grid.is_free(loaded.grid.cell_of(view.position))
    assert make_pilot(loaded.site, loaded.room, loaded.grid).plan(view.position).path is not None


def test_what_could_be_seen_but_not_flown_to_is_told_apart() -> None:
    boxes = tuple(Obstacle(f"box-{n}", (4.2, 3.5 + 0.35 * n), 0.25, top=1.6) for n in range(5))
    with pytest.raises(TaskError) as refused:
        find_viewpoint(viewing(), place_subject("door", (0.85, 4.2, 1.35)), obstacles=boxes)
    assert refused.value.code == "no_way"


def test_who_stands_in_the_only_way_is_named() -> None:
    def person(name: str, x: float, y: float) -> Obstacle:
        return Obstacle(name, (x, y), 0.25, kind=ObstacleKind.PERSON)

    others = (person("p1", 5.7, 2.28), person("p3", 9.0, 3.5))
    with pytest.raises(TaskError) as refused:
        find_viewpoint(
            viewing(),
            place_subject("entrance", (0.85, 4.2, 1.5)),
            obstacles=(*others, person("p2", 5.28, 4.21)),
        )
    assert refused.value.code == "no_way"
    assert str(refused.value).endswith("can be seen from: p2 is in the way")


def test_where_there_is_room_the_comfort_distance_is_kept() -> None:
    loaded, subject = site(), place_subject("kitchen", (9.03, 5.8, 0.95))
    alone = find_viewpoint(viewing(), subject).position
    config = loaded.site.people
    person = Obstacle("p", (alone[0] + 1.0, alone[1]), config.body_radius, kind=ObstacleKind.PERSON)
    view = find_viewpoint(viewing(), subject, obstacles=(person,))
    hull = half_diagonal(loaded.site.drone.hull_length, loaded.site.drone.hull_width)
    apart = distance(view.position, person.position) - hull - config.body_radius
    assert apart > config.comfort_distance


def test_nobody_hovers_where_tracking_does_not_see_the_drone() -> None:
    loaded, found = site(), 0
    cameras = tuple(loaded.room.cameras[number] for number in (8, 9, 10, 11, 12))
    room = replace(loaded.room, cameras=cameras)
    few = ViewingRoom(loaded.site, room, loaded.grid)
    for place in room.places:
        try:
            view = find_viewpoint(few, place_subject(place.name, place.look_at))
        except TaskError:
            continue
        found += 1
        assert seen_by(room, np.array([[*view.position, few.height]])).sum() >= 2, place.name
    assert 0 < found < len(room.places)


@pytest.mark.parametrize("subject", tuple(subjects()), ids=lambda one: one.name)
def test_the_drone_looks_from_above_clear_floor_where_it_can(subject: Subject) -> None:
    columns = StaticColumns(site().room, 1.5)
    place = find_viewpoint(viewing(), subject).position
    assert columns.clearance(place) > half_diagonal(0.52, 0.52)
