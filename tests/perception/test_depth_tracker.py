"""Depth images rendered from modelled rooms with something in them that no map shows."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import lru_cache
from math import cos, hypot, inf, nan, pi, sin
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from housefly.config.depth import DepthCameraConfig
from housefly.geometry import quaternion_from_euler, rotate
from housefly.messages import DepthImage, Pose
from housefly.numeric import FloatArray
from housefly.perception.depth_checks import FROZEN_IMAGES
from housefly.perception.depth_tracker import MAX_SAMPLED_PIXELS, DepthTracker, depth_view
from housefly.perception.laser_tracker import OwnFootprint, TrackingResult
from housefly.perception.tracker import BIRTH_HITS, DEATH_MISSES
from housefly.room.files import load_room
from housefly.room.model import Room, Shape, Solid

BAND = (0.85, 1.35)
CAMERA = DepthCameraConfig(name="depth-1", rate_hz=10.0)
BOX = Solid("box", "box", Shape.BOX, (4.0, 2.5, 0.75), (0.5, 0.4, 1.5), 0.3)
ONCE = settings(
    max_examples=30, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)


def looking(yaw: float, down: float = 0.0) -> tuple[float, float, float, float]:
    """Orientation of a camera that looks along a heading and down [rad]: z forward, x right, y
    down.
    """
    a, b, c, d = quaternion_from_euler(0.0, down, yaw)
    w, x, y, z = 0.5, -0.5, 0.5, -0.5
    return (
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    )


def entry(solid: Solid, start: FloatArray, ways: FloatArray) -> FloatArray:
    """How far along each ray it meets a solid, shape (n,); infinite when it does not."""
    c, s = cos(solid.yaw), sin(solid.yaw)
    turn = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
    o, d = turn @ (start - np.array(solid.position)), ways @ turn.T
    with np.errstate(divide="ignore", invalid="ignore"):
        a, b = (-np.array(solid.size) / 2 - o) / d, (np.array(solid.size) / 2 - o) / d
        near, far = np.minimum(a, b), np.maximum(a, b)
        if solid.shape is Shape.CYLINDER:
            p, q = (d[:, :2] ** 2).sum(axis=1), d[:, :2] @ o[:2]
            root = np.sqrt(q * q - p * (o[:2] @ o[:2] - (solid.size[0] / 2) ** 2))
            near = np.stack([(-q - root) / p, near[:, 2]], axis=1)
            far = np.stack([(-q + root) / p, far[:, 2]], axis=1)
        enters, leaves = near.max(axis=1), far.min(axis=1)
    return np.where((enters > 0.0) & (leaves > enters), enters, inf)


@lru_cache(maxsize=16)  # a scene that stands still is looked at again and again
def render(room: Room, pose: Pose, size: tuple[int, int], focal: float) -> FloatArray:
    """The depth image [m] of a room with floor and ceiling, shape (height, width)."""
    v, u = np.mgrid[: size[1], : size[0]].reshape(2, -1)
    local = np.stack(
        [(u - size[0] / 2) / focal, (v - size[1] / 2) / focal, np.ones(u.size)], axis=1
    )
    axes = np.array(
        [
            rotate(pose.orientation, axis)
            for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
        ]
    )
    start, ways = np.array(pose.position), local @ axes
    with np.errstate(divide="ignore", invalid="ignore"):
        floor = np.where(
            ways[:, 2] < 0.0, -start[2] / ways[:, 2], (room.height - start[2]) / ways[:, 2]
        )
    depth = np.where(np.isfinite(floor), floor, inf)
    for solid in room.solids:
        depth = np.minimum(depth, entry(solid, start, ways))
    return depth.reshape(size[1], size[0])


@dataclass
class Scene:
    """A camera in a room, and what the tracker makes of its noisy images."""

    room: Room
    pose: Pose
    things: tuple[Solid, ...] = ()
    noise: float = 0.008
    size: tuple[int, int] = (160, 120)
    now: float = 10.0
    own: tuple[OwnFootprint, ...] = ()
    seen: TrackingResult = field(default_factory=TrackingResult)

    def __post_init__(self) -> None:
        self.random = np.random.default_rng(1)
        self.tracker = DepthTracker(self.room, (CAMERA,), BAND)

    def image(self) -> DepthImage:
        focal = 0.8 * self.size[0]
        depth = render(
            replace(self.room, solids=self.room.solids + self.things), self.pose, self.size, focal
        )
        depth = depth + self.random.normal(0.0, self.noise, depth.shape)
        depth[self.random.random(depth.shape) < 0.02] = 0.0
        data = (
            np.where(np.isfinite(depth), np.clip(1000.0 * depth, 0.0, 65535.0), 0.0)
            .astype("<u2")
            .tobytes()
        )
        middle = (self.size[0] / 2, self.size[1] / 2)
        return DepthImage(
            "depth-1", self.now - 0.03, *self.size, data, focal, focal, *middle, self.pose
        )

    def look(self, images: int = 1) -> TrackingResult:
        for _ in range(images):
            self.now += 0.1
            self.seen = self.tracker.update(self.image(), self.now, self.own)
        return self.seen


@pytest.fixture
def scene(make_hall: Callable[..., Any]) -> Scene:
    return Scene(make_hall().room, Pose((0.6, 1.0, 2.2), looking(0.4, 0.3)))


def test_a_box_that_no_map_shows_is_one_obstacle_at_its_place(scene: Scene) -> None:
    scene.things = (BOX,)
    (box,) = scene.look(8).obstacles
    assert hypot(box.position[0] - 4.0, box.position[1] - 2.5) < 0.12
    assert 0.2 < box.radius < 0.4
    assert (
        box.velocity == (0.0, 0.0)
        and box.confidence == 1.0
        and box.source == "depth"
        and box.id == "track-depth-1-1"
    )


def test_an_empty_room_has_no_ghosts(scene: Scene) -> None:
    for _ in range(40):
        assert scene.look() == TrackingResult()


@pytest.mark.parametrize("yaw", [0.0, 0.5 * pi, pi, -0.5 * pi])
@pytest.mark.parametrize("x", [3.0, 9.0])
def test_the_empty_b_sen_has_no_ghosts_wherever_the_camera_looks(x: float, yaw: float) -> None:
    room = load_room("bsen")
    empty = Scene(room, Pose((x, 3.0, 1.6), looking(yaw, 0.15)))
    for _ in range(5):
        assert empty.look() == TrackingResult()


@ONCE
@given(x=st.floats(2.5, 5.0), y=st.floats(1.5, 3.5), turn=st.floats(-pi, pi))
def test_a_box_is_found_wherever_the_camera_can_see_it(
    scene: Scene, x: float, y: float, turn: float
) -> None:
    here = Scene(scene.room, scene.pose, (replace(BOX, position=(x, y, 0.75), yaw=turn),))
    (box,) = here.look(6).obstacles
    assert hypot(box.position[0] - x, box.position[1] - y) < 0.2


def test_a_box_is_believed_after_three_images_and_told_gone_after_three_more_without_it(
    scene: Scene,
) -> None:
    scene.things = (BOX,)
    assert [len(scene.look().obstacles) for _ in range(BIRTH_HITS)] == [0] * (BIRTH_HITS - 1) + [1]
    scene.look(5)
    scene.things = ()
    told = [scene.look().obstacles for _ in range(DEATH_MISSES + 1)]
    assert [[o.confidence > 0.0 for o in obstacles] for obstacles in told] == [[True]] * (
        DEATH_MISSES - 1
    ) + [[False], []]


def test_what_lies_lower_than_the_drone_flies_is_no_obstacle(scene: Scene) -> None:
    scene.things = (replace(BOX, position=(4.0, 2.5, 0.3), size=(0.5, 0.4, 0.6)),)
    assert not scene.look(8).obstacles


def test_the_drone_itself_is_no_obstacle(scene: Scene) -> None:
    scene.things = (BOX,)
    scene.own = (OwnFootprint((4.0, 2.5), 0.6),)
    assert not scene.look(8).obstacles


def test_a_large_image_is_thinned_out_and_shows_the_same(scene: Scene) -> None:
    large = Scene(scene.room, scene.pose, (BOX,), size=(640, 480))
    assert depth_view(large.image()).depth.size <= MAX_SAMPLED_PIXELS
    (box,) = large.look(6).obstacles
    assert hypot(box.position[0] - 4.0, box.position[1] - 2.5) < 0.12


def test_images_that_cannot_be_are_refused_in_words_and_change_nothing(scene: Scene) -> None:
    scene.things = (BOX,)
    scene.look(6)
    scene.now += 0.5
    good, now = scene.image(), scene.now
    bad = {
        "not a depth camera": replace(good, source="stranger"),
        "future": replace(good, captured_at=now + 1.0),
        "s late": replace(good, captured_at=now - 5.0),
        "not newer": replace(good, captured_at=now - 0.6),
        "images a second": replace(good, captured_at=now - 0.49),
        "finite": replace(good, fx=nan),
        "two bytes": replace(good, data=good.data[:-1]),
        "no pixels": replace(good, width=0, data=b""),
        "intrinsics": replace(good, fy=0.0),
        "pose": replace(good, pose=Pose((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0))),
    }
    for words, image in bad.items():
        refused = scene.tracker.update(image, now)
        assert words in refused.problem and not refused.obstacles
    after = scene.tracker.update(good, now)
    assert not after.problem and len(after.obstacles) == 1


def test_a_camera_that_stands_still_or_is_covered_is_told_and_shows_nothing(scene: Scene) -> None:
    scene.things = (BOX,)
    frozen = scene.image()
    answers = [
        scene.tracker.update(replace(frozen, captured_at=10.0 + 0.1 * n), 10.0 + 0.1 * n)
        for n in range(7)
    ]
    assert [bool(answer.problem) for answer in answers] == [False] * FROZEN_IMAGES + [True] * (
        7 - FROZEN_IMAGES
    )
    assert "stands still" in answers[-1].problem and not answers[-1].obstacles
    covered = scene.tracker.update(
        replace(frozen, captured_at=12.0, data=bytes(len(frozen.data))), 12.0
    )
    assert "cover" in covered.problem and not covered.obstacles


NUMBERS = st.floats() | st.floats(0.0, 50.0)
IMAGES = st.builds(
    DepthImage,
    source=st.sampled_from(["depth-1", "x"]),
    captured_at=st.floats() | st.floats(9.0, 11.0),
    width=st.integers(-1, 12),
    height=st.integers(-1, 12) | st.just(2**31 - 1),
    data=st.binary(max_size=288) | st.just(b"\x10\x08" * 64),
    fx=NUMBERS,
    fy=NUMBERS,
    cx=NUMBERS,
    cy=NUMBERS,
    pose=st.builds(
        Pose,
        st.tuples(NUMBERS, NUMBERS, NUMBERS),
        st.sampled_from([looking(0.3), (1.0, 0.0, 0.0, 0.0), (nan,) * 4]),
    ),
)
NOISE = st.builds(
    lambda at, seed: DepthImage(
        "depth-1",
        at,
        80,
        60,
        np.random.default_rng(seed).integers(0, 9000, 4800).astype("<u2").tobytes(),
        *(60.0, 60.0, 40.0, 30.0),
        Pose((3.0, 3.0, 1.1), looking(0.3)),
    ),
    st.floats(9.0, 10.0),
    st.integers(0, 9),
)


@ONCE
@given(st.lists(IMAGES | NOISE, max_size=6))
def test_any_images_are_survived_and_what_comes_out_is_finite(
    scene: Scene, garbage: list[DepthImage]
) -> None:
    for image in garbage:
        for o in scene.tracker.update(image, 10.0, (OwnFootprint((1.0, 1.0), 0.5),)).obstacles:
            assert all(np.isfinite([*o.position, o.radius, *o.size, *o.velocity]))


def test_the_same_images_give_the_same_obstacles(make_hall: Callable[..., Any]) -> None:
    one, two = (
        Scene(make_hall().room, Pose((0.6, 1.0, 2.2), looking(0.4, 0.3)), (BOX,)) for _ in range(2)
    )
    assert [one.look() for _ in range(5)] == [two.look() for _ in range(5)]
