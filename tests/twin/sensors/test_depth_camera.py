"""The simulated depth camera, judged by the perception that reads it."""

from __future__ import annotations

from math import hypot, pi

import numpy as np
import pytest

from housefly.config.site import changed
from housefly.messages import Obstacle
from housefly.perception.depth import points_of
from housefly.perception.depth_tracker import DepthTracker, depth_view
from housefly.sites.loaded_site import open_site, read_site
from housefly.twin.movable import Movable
from housefly.twin.sensors.depth_camera import DEPTH_HEIGHT, DEPTH_WIDTH
from housefly.twin.world import SimulatedWorld

BAND = (0.9, 1.3)


def world_with(**camera: float) -> tuple[SimulatedWorld, DepthTracker]:
    site = changed(
        read_site("bsen"),
        depth_cameras=[{"name": "depth-1", **camera}],
        twin__visitor_present=False,
    )
    room = open_site(site).room
    return SimulatedWorld(site, room, movables=(Movable("chair"),)), DepthTracker(
        room, site.depth_cameras, BAND
    )


def watched(
    world: SimulatedWorld, tracker: DepthTracker, images: int = 8, begin: float = 100.0
) -> list[Obstacle]:
    seen: list[Obstacle] = []
    for number in range(images):
        now = begin + 0.1 * number
        found = tracker.update(world.depth_image("depth-1", now), now)
        assert not found.problem
        seen.extend(found.obstacles)
    return seen


def test_the_same_seed_sees_the_same_and_no_two_images_are_alike() -> None:
    (one, _), (other, _) = world_with(x=5.5, y=3.0), world_with(x=5.5, y=3.0)
    first, second = one.depth_image("depth-1", 1.0), one.depth_image("depth-1", 1.1)
    assert first == other.depth_image("depth-1", 1.0)
    assert first.data != second.data
    assert (first.width, first.height, len(first.data)) == (
        DEPTH_WIDTH,
        DEPTH_HEIGHT,
        2 * DEPTH_WIDTH * DEPTH_HEIGHT,
    )


@pytest.mark.parametrize("yaw", [0.0, pi / 2, -2.5])
@pytest.mark.parametrize("pitch", [0.0, 0.6])
def test_its_points_lie_inside_the_room_and_the_floor_is_flat(yaw: float, pitch: float) -> None:
    world, _ = world_with(x=6.0, y=3.0, z=1.8, yaw=yaw, pitch=pitch)
    view = depth_view(world.depth_image("depth-1", 1.0))
    points = points_of(view.depth, view.camera, view.pose)
    assert len(points) > 0.5 * DEPTH_WIDTH * DEPTH_HEIGHT
    assert points[:, 2].min() > -0.25
    if pitch:
        assert np.count_nonzero(np.abs(points[:, 2]) < 0.1) > 300


@pytest.mark.parametrize("yaw", [0.0, 1.5, 3.0, -1.5])
def test_a_room_as_modelled_has_no_ghosts(yaw: float) -> None:
    assert not watched(*world_with(x=6.0, y=3.0, z=1.1, yaw=yaw), images=30)


def test_a_chair_is_one_obstacle_at_its_place_and_is_gone_when_it_is_taken_away() -> None:
    world, tracker = world_with(x=4.0, y=4.2, z=1.1, yaw=3.1)
    world.put("chair", (2.0, 4.3))
    seen = watched(world, tracker)
    assert len({obstacle.id for obstacle in seen}) == 1
    assert hypot(seen[-1].position[0] - 2.0, seen[-1].position[1] - 4.3) < 0.3
    world.put("chair", None)
    assert watched(world, tracker, begin=101.0)[-1].confidence == 0.0
