"""How fast the simulated people move: their bodies are placed, not pushed."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.geometry import Vec3

_STILL: Vec3 = (0.0, 0.0, 0.0)
_STANDS_AFTER = 0.2
"""Somebody who was not placed anew for this long [s] stands still."""
_SPEED_MAX = 5.0
"""Whoever would be faster than this [m/s] was put somewhere else."""


@dataclass(frozen=True, slots=True)
class _Placed:
    position: Vec3
    at: float
    velocity: Vec3


class PersonMotion:
    """Velocities from the places where people were put one after the other."""

    def __init__(self) -> None:
        self._placed: dict[str, _Placed] = {}

    def placed(self, name: str, position: Vec3, at: float) -> None:
        """Record where a body is from a time [s] on."""
        last = self._placed.get(name)
        if last is None or at <= last.at:
            velocity = _STILL if last is None else last.velocity
        else:
            vx, vy, vz = (
                (now - before) / (at - last.at)
                for now, before in zip(position, last.position, strict=True)
            )
            fast = vx * vx + vy * vy + vz * vz > _SPEED_MAX * _SPEED_MAX
            velocity = _STILL if fast else (vx, vy, vz)
        self._placed[name] = _Placed(position, at, velocity)

    def velocity(self, name: str, at: float) -> Vec3:
        """Return how fast a person moves [m/s]; still when nobody of this name was placed."""
        last = self._placed.get(name)
        return _STILL if last is None or at - last.at > _STANDS_AFTER else last.velocity
