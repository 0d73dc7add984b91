"""Holds tracked motion against how the drone leans: a mirrored tracking frame shows it.

A drone that tells its own speed is asked for that (``estimation.track_windows``). One that does not
still tells how it leans, and that is an acceleration. Where tracking shows the opposite of it along
some direction, our setpoints drive the drone away from where it should be.

Both are high-passed velocities in the map frame, so that wind and drag, which act slowly, cancel.
In a gust tracked is what the lean does plus the gust; that is the opposite of the lean only until
this has caught up. In a mirrored frame it always is.
"""

from __future__ import annotations

from math import cos, exp, pi, sin

from housefly.geometry import GRAVITY, Vec2

HIGH_PASS_TIME = 1.0
"""Time constant of the high-passed velocities [s]."""
MEMORY_TIME = 3.0
"""Time constant with which they are forgotten [s]."""
LEAN_ENERGY_MIN = 0.06
"""So much must the lean have done along a direction [m^2/s]: 0.35 m/s for half a second. With less
a gust that begins looks mirrored until the lean has caught up with it.
"""
MIRRORED_SHARE = 0.35
"""Tracked plus lean leaves less than this share of it in a mirrored frame; four times it else."""
_DIRECTIONS = tuple((cos(k * pi / 4.0), sin(k * pi / 4.0)) for k in range(4))


class LeanConsistency:
    """Remembers what the lean did and what tracking showed of it; fed once a step."""

    def __init__(self) -> None:
        self._before: Vec2 | None = None
        self._lean: Vec2 = (0.0, 0.0)
        self._tracked: Vec2 = (0.0, 0.0)
        self._lean_energy = [0.0] * len(_DIRECTIONS)
        self._left_over = [0.0] * len(_DIRECTIONS)

    def is_mirrored(self, dt: float, velocity: Vec2, yaw: float, theta: float, phi: float) -> bool:
        """Return whether tracking shows the opposite of what the lean does.

        Args:
            dt: since the step before [s].
            velocity: tracked, in the map frame [m/s].
            yaw: tracked [rad].
            theta: pitch that the drone reports [rad].
            phi: roll that it reports [rad].
        """
        vx, vy = velocity
        before_x, before_y = self._before or velocity
        self._before = velocity
        c, s = cos(yaw), sin(yaw)
        ahead, left = GRAVITY * dt * sin(theta), -GRAVITY * dt * sin(phi)
        keep, forget = exp(-dt / HIGH_PASS_TIME), exp(-dt / MEMORY_TIME)
        lx, ly = self._lean
        lx, ly = self._lean = keep * lx + c * ahead - s * left, keep * ly + s * ahead + c * left
        tx, ty = self._tracked
        tx, ty = self._tracked = keep * tx + vx - before_x, keep * ty + vy - before_y
        for number, (ux, uy) in enumerate(_DIRECTIONS):
            lean, tracked = ux * lx + uy * ly, ux * tx + uy * ty
            self._lean_energy[number] = forget * self._lean_energy[number] + lean**2 * dt
            left_over = (lean + tracked) ** 2 * dt
            self._left_over[number] = forget * self._left_over[number] + left_over
        return any(
            energy > LEAN_ENERGY_MIN and left_over < MIRRORED_SHARE * energy
            for energy, left_over in zip(self._lean_energy, self._left_over, strict=True)
        )
