"""Forces on the simulated drone that are not its own: air, a line, a load.

Air drags the drone along x and y as fast as drag brakes it; along z it changes the angle at which
the blades meet it, and so their thrust.
"""

from __future__ import annotations

from math import exp, hypot, sqrt
from typing import NamedTuple

import numpy as np

from housefly.geometry import GRAVITY, Vec3, rotate
from housefly.twin.disturbance import CeilingFan, Disturbances, Payload, Tether
from housefly.twin.simulated_body import CONTROL_PERIOD, BodyState

_SEED_KEY = 7741
"""Keeps the gusts apart from all other noise of the same seed."""
_LIFT_PER_AIR_SPEED = 0.35
"""Thrust [N] that rising air adds per m/s, falling air takes: about half of what blade elements say
of four rotors of 0.1 m at 36 m/s of tip speed, since the inflow answers."""
_VERTICAL_GUST = 0.5
_FAN_FADE = 1.5
"""Gusts along z over those along x; the fan's column ends at this many radii."""
_TETHER_DAMPING = 0.3
"""Share of critical damping of a taut line; without it the drone would bounce for long."""


class ExternalForce(NamedTuple):
    """Force in the world [N] at the centre of mass, and torque about the body axes [N m]."""

    force: Vec3
    torque: Vec3


class ExternalForces:
    """Gusts with a generator of their own, and everything that follows from where the drone is.

    Args:
        seed: of the site.
        drag: deceleration over air speed [1/s].
        mass: of the drone [kg].
    """

    def __init__(self, seed: int, drag: float, mass: float) -> None:
        self._random = np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(_SEED_KEY,)))
        self._drag, self._mass = drag * mass, mass
        self._gust = np.zeros(3)

    def step(self, disturbances: Disturbances, body: BodyState) -> ExternalForce:
        """Return what pushes for one control period."""
        wx, wy, wz = self._wind(disturbances, body)
        fx, fy, fz = self._drag * wx, self._drag * wy, _LIFT_PER_AIR_SPEED * wz
        torque = (0.0, 0.0, 0.0)
        if disturbances.tether is not None:
            px, py, pz = _pull(disturbances.tether, body, self._mass)
            fx, fy, fz = fx + px, fy + py, fz + pz
        if disturbances.payload is not None:
            torque = _load_torque(disturbances.payload, body)
        return ExternalForce((fx, fy, fz), torque)

    def _wind(self, disturbances: Disturbances, body: BodyState) -> Vec3:
        """Return the speed of the air where the drone is [m/s]."""
        x, y, z = disturbances.wind
        if disturbances.gust > 0.0:
            keep = exp(-CONTROL_PERIOD / disturbances.gust_time)
            self._gust = keep * self._gust + sqrt(1.0 - keep * keep) * (
                self._random.standard_normal(3)
            )
            gx, gy, gz = (disturbances.gust * self._gust).tolist()
            through = _share_along_z(disturbances.gust * disturbances.gust_time, body.position[2])
            x, y, z = x + gx, y + gy, z + _VERTICAL_GUST * through * gz
        if disturbances.fan is not None:
            z -= downwash_at(disturbances.fan, body.position)
        return x, y, z


def _share_along_z(eddy: float, height: float) -> float:
    """Return what is left of gusts along z: none at the floor, all above an eddy's size [m]."""
    return min(max(height, 0.0) / eddy, 1.0) if eddy > 0.0 else 1.0


def downwash_at(fan: CeilingFan, position: Vec3) -> float:
    """Return the speed of the air that falls at a position [m/s]."""
    away = hypot(position[0] - fan.place[0], position[1] - fan.place[1]) / fan.radius
    share = min(max((_FAN_FADE - away) / (_FAN_FADE - 1.0), 0.0), 1.0)
    return share * fan.downwash


def _pull(tether: Tether, body: BodyState, mass: float) -> Vec3:
    """Return the force of a line [N]; none while it is slack."""
    away = tuple(end - own for end, own in zip(tether.anchor, body.position, strict=True))
    reach = hypot(*away)
    if reach <= tether.length:
        return 0.0, 0.0, 0.0
    x, y, z = (part / reach for part in away)
    towards = x * body.velocity[0] + y * body.velocity[1] + z * body.velocity[2]
    damping = 2.0 * _TETHER_DAMPING * sqrt(tether.stiffness * mass)
    force = max(0.0, tether.stiffness * (reach - tether.length) - damping * towards)
    return force * x, force * y, force * z


def _load_torque(payload: Payload, body: BodyState) -> Vec3:
    """Return the torque of a load's weight about the body axes [N m]."""
    w, qx, qy, qz = body.orientation
    gx, gy, gz = rotate((w, -qx, -qy, -qz), (0.0, 0.0, -payload.mass * GRAVITY))
    x, y, z = payload.offset
    return y * gz - z * gy, z * gx - x * gz, x * gy - y * gx
