from collections.abc import Callable
from itertools import combinations, pairwise
from math import pi, radians, tan

import mujoco
import numpy as np
import pytest

from housefly.config.site import Site, changed
from housefly.geometry import distance
from housefly.room.model import Room
from housefly.twin.physics import Physics
from housefly.twin.quadrotor.body import (
    DRONE_MARKERS,
    DRONE_MASS,
    FRONT_FIELD_OF_VIEW,
    HULL_GROUP,
    INERTIA,
    STANDING_HEIGHT,
    VISUAL_GROUP,
)


@pytest.fixture
def physics(make_room: Callable[..., Room]) -> Physics:
    return Physics(Site(), make_room())


def test_mass_and_inertia_are_the_measured_ones(physics: Physics) -> None:
    assert physics.model.body_mass[physics.drones[0].number] == pytest.approx(DRONE_MASS)
    assert sorted(physics.model.body_inertia[physics.drones[0].number]) == pytest.approx(
        sorted(INERTIA)
    )


@pytest.mark.parametrize(
    ("length", "width"), [(0.517, 0.451), (0.3, 0.3), (0.05, 0.05), (2.0, 0.5)]
)
def test_the_collision_hull_is_as_long_and_wide_as_configured(
    make_room: Callable[..., Room], length: float, width: float
) -> None:
    physics = Physics(
        changed(Site(), drone__hull_length=length, drone__hull_width=width), make_room()
    )
    model, data = physics.model, physics.data
    hull = [
        n
        for n in range(model.ngeom)
        if model.geom_bodyid[n] == physics.drones[0].number and model.geom_group[n] == HULL_GROUP
    ]
    extents = np.array([_half_extents(physics, n) for n in hull])
    centres = data.geom_xpos[hull] - data.xpos[physics.drones[0].number]
    low, high = (centres - extents).min(axis=0), (centres + extents).max(axis=0)
    assert (high - low)[:2] == pytest.approx((length, width), abs=1e-6)


def _half_extents(physics: Physics, geom: int) -> np.ndarray:
    turn, size = np.abs(physics.data.geom_xmat[geom].reshape(3, 3)), physics.model.geom_size[geom]
    if physics.model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_CAPSULE:
        return turn @ (0.0, 0.0, size[1]) + size[0]
    return turn @ size


def test_no_two_distances_between_markers_are_alike() -> None:
    between = sorted(distance(a, b) for a, b in combinations(DRONE_MARKERS, 2))
    assert min(later - earlier for earlier, later in pairwise(between)) > 0.002


def test_the_drone_stands_still_on_its_belly(physics: Physics) -> None:
    mujoco.mj_step(physics.model, physics.data, 800)
    state = physics.drones[0].state()
    assert state.position == pytest.approx((2.0, 2.5, STANDING_HEIGHT), abs=0.002)
    assert max(map(abs, state.velocity)) < 1e-3


def test_nothing_of_the_drone_stands_in_the_front_cameras_view(physics: Physics) -> None:
    camera = physics.model.camera("front")
    eye = physics.data.cam_xpos[camera.id]
    looks = np.array([group == VISUAL_GROUP for group in range(6)], np.uint8)
    geom = np.zeros(1, np.int32)
    for across in np.linspace(-1, 1, 15):
        for up in np.linspace(-1, 1, 9):
            ray = np.array(
                [
                    1.0,
                    across * tan(FRONT_FIELD_OF_VIEW / 2),
                    up * tan(FRONT_FIELD_OF_VIEW / 2) * 9 / 16,
                ]
            )
            assert mujoco.mj_ray(physics.model, physics.data, eye, ray, looks, 1, -1, geom) < 0, (
                across,
                up,
            )


def test_the_front_camera_is_69_degrees_wide(physics: Physics) -> None:
    height = radians(float(physics.model.camera("front").fovy[0]))
    assert tan(height / 2) * 16 / 9 == pytest.approx(tan(FRONT_FIELD_OF_VIEW / 2), rel=1e-4)
    assert 0 < height < pi / 2
