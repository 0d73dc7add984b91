"""The simulated range finder measures what a ray through the whole room would hit."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from housefly.config.laser import LaserConfig
from housefly.config.site import Site, changed
from housefly.numeric import FloatArray
from housefly.room.model import Room, Solid
from housefly.twin.movable import Movable
from housefly.twin.mujoco_engine import mujoco
from housefly.twin.physics import Physics
from housefly.twin.sensors.scanner import VISIBLE_GROUPS, Scanner
from housefly.wires.scip.parameters import MODELS, NO_ECHO

LASER = LaserConfig(name="laser", x=0.4, y=0.4, z=0.3, yaw=0.8)
EXACT = changed(Site(), twin__laser_noise=0.0, twin__laser_dropout=0.0)
coordinate = st.floats(0.5, 4.5)


def cast_at_all(physics: Physics) -> FloatArray:
    """Return the distance of each beam to whatever is there [mm], infinite without anything."""
    known = MODELS[LASER.model]
    angles = LASER.yaw + known.first_angle + np.arange(known.beams) * known.step
    rays = np.stack([np.cos(angles), np.sin(angles), np.zeros(known.beams)], axis=1).ravel()
    geoms, reached = np.zeros(known.beams, np.int32), np.zeros(known.beams)
    origin: Any = np.array([LASER.x, LASER.y, LASER.z])
    mujoco.mj_multiRay(
        physics.model, physics.data, origin, rays, VISIBLE_GROUPS, 1, -1, geoms, reached, None,
        known.beams, known.longest / 1000.0,
    )  # fmt: skip
    return np.where(reached < 0.0, np.inf, 1000.0 * reached)


@settings(
    max_examples=20, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(coordinate, coordinate, coordinate, coordinate)
def test_it_measures_walls_and_what_moves_as_one_room(
    make_room: Callable[..., Room], wall: Solid, x: float, y: float, drone_x: float, drone_y: float
) -> None:
    physics = Physics(EXACT, make_room((wall,)), movables=(Movable("stool", 0.18, 0.45),))
    scanner = Scanner(LASER, EXACT.twin, 0, physics)
    physics.put("stool", (x, y), 0.3)
    physics.drones[0].place((drone_x, drone_y, 0.3), (1.0, 0.0, 0.0, 0.0))
    mujoco.mj_forward(physics.model, physics.data)
    seen, there = np.array(scanner.scan()), cast_at_all(physics)
    known = MODELS[LASER.model]
    measurable = (there >= known.shortest) & (there <= known.longest)
    assume(measurable.any())  # unless something stands right before its window
    assert (seen[measurable] == np.rint(there[measurable])).all()
    assert (seen[~measurable] == NO_ECHO[LASER.model]).all()
