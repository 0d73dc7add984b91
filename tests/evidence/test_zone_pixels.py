"""Zones in rendered pictures, pixel by pixel: what is in a zone is blank, little else is."""

from __future__ import annotations

from functools import cache
from itertools import product
from math import radians, tan

import numpy as np
import pytest
from depth_views import HEIGHT, WIDTH, depth_views
from matplotlib.path import Path as Outline
from numpy.typing import NDArray
from PIL import Image, ImageFilter

from housefly.config.house_mode import HouseMode
from housefly.config.site import Site
from housefly.config.tasks import PrivacyZone
from housefly.evidence.camera_pose import CameraPose
from housefly.evidence.frame_blanker import BLANK, blanked_picture
from housefly.evidence.zone_projection import ZoneProjector, private_zones
from housefly.geometry import Quaternion, Vec3, quaternion_from_euler, quaternion_product, rotate
from housefly.messages import Pose
from housefly.room.level_camera import LevelCamera

FRONT_CAMERA = LevelCamera.of(Site().drone.airframe.capabilities.camera)

BED = PrivacyZone(
    name="bed", polygon=((9.2, 1.9), (11.2, 1.9), (11.2, 3.5), (9.2, 3.5)), z_min=0.0, z_max=1.2
)
CORNER = PrivacyZone(
    name="corner",
    polygon=((11.0, 5.0), (11.0, 6.2), (14.6, 6.2), (14.6, 3.4), (13.4, 3.4), (13.4, 5.0)),
    z_min=0.0,
    z_max=2.4,
)
POSES = 16
MARGIN, STEP = 0.1, 8


def random_poses(seed: int) -> list[Pose]:
    """Return poses in the living room; most look at a zone."""
    rng = np.random.default_rng(seed)
    poses = []
    for n in range(POSES):
        x, y, z = rng.uniform((5.2, 1.0, 0.5), (14.0, 5.8, 1.9))
        aim = ((10.2, 2.7), (13.5, 5.5))[n % 2]
        yaw = np.arctan2(aim[1] - y, aim[0] - x) + rng.uniform(-0.8, 0.8)
        tilt = rng.uniform(-0.2, 0.2, 2)
        poses.append(Pose((x, y, z), quaternion_from_euler(tilt[0], tilt[1], float(yaw))))
    # Beside a zone and along it: part of it is behind the camera.
    poses += [
        Pose((x, y, z), quaternion_from_euler(0.0, tilt, turn))
        for x, y, z, turn, tilt in ((10.0, 3.8, 0.9, 0.3, 0.2), (11.6, 4.65, 2.1, 0.1, 0.0))
    ]
    return poses


@cache
def views() -> tuple[list[Pose], NDArray[np.uint8], NDArray[np.float32]]:
    poses = random_poses(1)
    return (poses, *depth_views(poses))


def rays(
    pose: Pose, beside: int = 0, step: int = 1
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the camera's place, and the direction of each pixel for a depth of one metre.

    Args:
        pose: of the drone.
        beside: further pixels on every side of the picture.
        step: only every so many.
    """
    focal = WIDTH / 2 / tan(radians(69.0) / 2)
    across, down = np.meshgrid(
        np.arange(-beside, WIDTH + beside, step) + step / 2,
        np.arange(-beside, HEIGHT + beside, step) + step / 2,
    )
    body = np.stack(
        (np.ones_like(across), (WIDTH / 2 - across) / focal, (HEIGHT / 2 - down) / focal), axis=-1
    )
    axes = np.array([rotate(pose.orientation, axis) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))])
    return np.array(pose.position) + 0.21 * axes[0], body @ axes


def in_zone(points: NDArray[np.float64], zone: PrivacyZone) -> NDArray[np.bool_]:
    """Return which points are at least a millimetre in a zone."""
    flat = Outline(zone.polygon).contains_points(points[..., :2].reshape(-1, 2))
    height = points[..., 2]
    return (
        flat.reshape(points.shape[:-1])
        & (height > zone.z_min + 1e-3)
        & (height < zone.z_max - 1e-3)
    )


def shows_zone(pose: Pose, depth: NDArray[np.float32], zone: PrivacyZone) -> NDArray[np.bool_]:
    """Return which pixels show something that lies in a zone."""
    eye, directions = rays(pose)
    return in_zone(eye + depth[..., None] * directions, zone)


def looks_through(
    pose: Pose, zone: PrivacyZone, grown: float, beside: int = 0
) -> NDArray[np.bool_]:
    """Return which of every eighth pixel look through a zone, grown on every side [m].

    Args:
        pose: of the drone.
        zone: one of them.
        grown: by which it is larger [m].
        beside: further pixels on every side of the picture.
    """
    eye, directions = rays(pose, beside, STEP)
    outline = Outline(zone.polygon)
    met = np.zeros(directions.shape[:2], dtype=bool)
    for depth in np.geomspace(0.05, 12.0, 80):
        points = eye + depth * directions
        height = points[..., 2]
        for shift in product({grown, -grown}, repeat=2):
            flat = outline.contains_points(points[..., :2].reshape(-1, 2) + shift)
            met |= (
                flat.reshape(met.shape)
                & (height > zone.z_min - grown)
                & (height < zone.z_max + grown)
            )
    return met


def may_be_blank(pose: Pose, zone: PrivacyZone) -> NDArray[np.bool_]:
    """Return which pixels look through a zone grown by 0.16 m, or past it by 40 pixels."""
    beside = 6 * STEP
    met = looks_through(pose, zone, 1.6 * MARGIN, beside)
    image = Image.fromarray(met.astype(np.uint8) * 255).filter(ImageFilter.MaxFilter(11))
    wide = np.asarray(image.resize((image.width * STEP, image.height * STEP), 0)) > 0
    return wide[beside : beside + HEIGHT, beside : beside + WIDTH]


def believed(
    pose: Pose, shift: Vec3 = (0, 0, 0), twist: Vec3 = (0, 0, 0), **more: float
) -> CameraPose:
    """Return what the drone believes: a pose that is shifted [m] and twisted [rad]."""
    position = tuple(a + b for a, b in zip(pose.position, shift, strict=True))
    turned: Quaternion = quaternion_product(pose.orientation, quaternion_from_euler(*twist))
    return CameraPose(0.0, (position[0], position[1], position[2]), turned, **more)


@pytest.mark.parametrize("zone", [BED, CORNER], ids=lambda zone: zone.name)
def test_every_pixel_that_shows_a_zone_is_blank_and_nothing_far_beside_it(
    zone: PrivacyZone,
) -> None:
    poses, colours, depths = views()
    projector = ZoneProjector((zone,), FRONT_CAMERA, MARGIN)
    seen = whole = 0
    for pose, colour, depth in zip(poses, colours, depths, strict=True):
        cover = projector.mask((believed(pose),), WIDTH, HEIGHT)
        blank = cover.pixels(WIDTH, HEIGHT)
        shown = shows_zone(pose, depth, zone)
        seen += bool(shown.any())
        whole += cover.is_whole
        assert not (shown & ~blank).any(), f"{pose}: {(shown & ~blank).sum()} pixels show the zone"
        picture = blanked_picture(colour, cover)
        assert (picture[shown] == BLANK).all()
        if not cover.is_whole:
            assert (picture[~blank] == colour[~blank]).all()
            outline = looks_through(pose, zone, 0.0)
            assert not (outline & ~blank[STEP // 2 :: STEP, STEP // 2 :: STEP]).any()
            assert not (blank & ~may_be_blank(pose, zone)).any()
    assert seen > POSES / 3 and whole < POSES / 4


@pytest.mark.parametrize(
    ("shift", "twist", "margin"), [(0.25, 0.0, 0.1), (0.0, 1.98, 0.0), (0.25, 1.98, 0.1)]
)
def test_a_pose_that_is_wrong_within_its_bounds_shows_no_pixel_of_a_zone(
    shift: float, twist: float, margin: float
) -> None:
    """The position is off by margin and three deviations [m], the attitude by two degrees."""
    poses, _, depths = views()
    rng = np.random.default_rng(5)
    projector = ZoneProjector((BED, CORNER), FRONT_CAMERA, margin)
    std = (shift - margin) / 3 if shift else 0.0
    for pose, depth in zip(poses, depths, strict=True):
        shown = shows_zone(pose, depth, BED) | shows_zone(pose, depth, CORNER)
        for _ in range(4):
            way, axis = rng.normal(size=(2, 3))
            pose_believed = believed(
                pose,
                tuple(shift * way / np.linalg.norm(way)),
                tuple(radians(twist) * axis / np.linalg.norm(axis)),
                position_std=std,
            )
            blank = projector.mask((pose_believed,), WIDTH, HEIGHT).pixels(WIDTH, HEIGHT)
            assert not (shown & ~blank).any()


def test_a_picture_late_by_any_part_of_the_latency_shows_no_pixel_of_a_zone() -> None:
    """The drone turns by a radian and moves by half a metre while the picture is on its way."""
    poses, _, depths = views()
    rng = np.random.default_rng(6)
    projector = ZoneProjector((BED, CORNER), FRONT_CAMERA, MARGIN)
    for pose, depth in zip(poses, depths, strict=True):
        shown = shows_zone(pose, depth, BED) | shows_zone(pose, depth, CORNER)
        way, turning, real = rng.uniform(-0.5, 0.5, 3), rng.uniform(-1, 1), rng.uniform(0, 1)
        track = tuple(
            believed(pose, tuple((part - real) * way), (0, 0, (part - real) * turning))
            for part in np.linspace(0, 1, 11)
        )
        blank = projector.mask(track, WIDTH, HEIGHT).pixels(WIDTH, HEIGHT)
        assert not (shown & ~blank).any()


def test_without_a_pose_or_from_inside_a_zone_everything_is_blank() -> None:
    projector = ZoneProjector((BED,), FRONT_CAMERA, MARGIN)
    assert projector.mask((), WIDTH, HEIGHT).pixels(WIDTH, HEIGHT).all()
    inside = CameraPose(0.0, (10.0, 2.5, 1.0), (1.0, 0.0, 0.0, 0.0))
    assert projector.mask((inside,), WIDTH, HEIGHT).is_whole
    beside = CameraPose(0.0, (10.0, 2.5, 2.0), (1.0, 0.0, 0.0, 0.0))
    assert not projector.mask((beside,), WIDTH, HEIGHT).is_whole
    assert ZoneProjector((), FRONT_CAMERA).mask((), WIDTH, HEIGHT).is_empty


def test_the_camera_of_the_zones_is_that_of_the_twin() -> None:
    from housefly.twin.quadrotor.body import FRONT_FIELD_OF_VIEW, PICTURE_SIZE

    assert (WIDTH, HEIGHT) == PICTURE_SIZE
    assert FRONT_CAMERA.width == pytest.approx(FRONT_FIELD_OF_VIEW)
    assert FRONT_CAMERA.ahead == pytest.approx(0.21)


def test_the_lens_of_another_drone_shows_zones_that_a_narrow_one_does_not() -> None:
    narrow, wide = (LevelCamera(lens, 0.6 * lens, 0.1, 640) for lens in (0.6, 2.0))
    aside = CameraPose(0.0, (9.0, 6.0, 1.0), (1.0, 0.0, 0.0, 0.0))
    covers = [ZoneProjector((BED,), lens).mask((aside,), WIDTH, HEIGHT) for lens in (narrow, wide)]
    assert [cover.pixels(WIDTH, HEIGHT).any() for cover in covers] == [False, True]


def test_a_zone_is_private_always_or_in_the_modes_that_it_names() -> None:
    corners = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0))
    bath = PrivacyZone(name="bath", polygon=corners)
    bed = PrivacyZone(name="bed", polygon=corners, modes=("home", "night"))
    assert private_zones(HouseMode.NIGHT, (bath, bed)) == (bath, bed)
    assert private_zones(HouseMode.AWAY, (bath, bed)) == (bath,)
