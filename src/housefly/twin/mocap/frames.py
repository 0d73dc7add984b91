"""The frames of the simulated motion capture system: when they are taken, how late, how noisy."""

from __future__ import annotations

from collections import deque

import numpy as np

from housefly.config.site import Site
from housefly.geometry import normalized
from housefly.messages import Pose
from housefly.twin.contracts import MocapFrame

_JITTER = 0.0005
"""Mean of the extra, exponentially distributed delay of a frame [s]."""
LEVER_ARM = 0.15
"""Distance of the markers from their centre [m]; position noise over it is attitude noise [rad]."""


class FrameMaker:
    """Turns true poses into frames with rate, latency, jitter, noise and dropouts."""

    def __init__(self, site: Site, rng: np.random.Generator) -> None:
        twin = site.twin
        self._period = 1.0 / twin.mocap_rate_hz
        self._latency, self._noise, self._dropout = (
            twin.mocap_latency,
            twin.mocap_noise,
            twin.mocap_dropout,
        )
        self._rng = rng
        self._number = 0
        self._waiting: deque[MocapFrame] = deque()
        self._due = 0.0

    def is_due(self, now: float) -> bool:
        """Return whether the next exposure is due."""
        return now >= self._number * self._period - 1e-9

    def expose(self, now: float, bodies: tuple[tuple[str, Pose | None], ...]) -> None:
        """Take one frame; the noise drawn is the same whether or not the frame is lost."""
        lost = self._rng.random() < self._dropout
        jitter = self._rng.exponential(_JITTER)
        noise = (self._noise * self._rng.standard_normal((len(bodies), 6))).tolist()
        noisy = tuple(
            (name, None if pose is None else _blurred(pose, numbers))
            for (name, pose), numbers in zip(bodies, noise, strict=True)
        )
        self._due = max(self._due, now + self._latency + jitter)
        if not lost:
            self._waiting.append(MocapFrame(self._number, now, self._due, noisy))
        self._number += 1

    def due_frames(self, now: float) -> tuple[MocapFrame, ...]:
        """Return the frames that have become due since the last call, oldest first."""
        ready = []
        while self._waiting and self._waiting[0].due_at <= now:
            ready.append(self._waiting.popleft())
        return tuple(ready)


def _blurred(pose: Pose, noise: list[float]) -> Pose:
    """Return a pose with noise of its place and, over the lever arm, of its attitude [m]."""
    x, y, z, *turn = noise
    half = [angle / LEVER_ARM / 2 for angle in turn]
    px, py, pz = pose.position
    return Pose((px + x, py + y, pz + z), _turned(pose, half))


def _turned(pose: Pose, half: list[float]) -> tuple[float, float, float, float]:
    """Return the orientation after a small rotation, given as half angles about body axes [rad]."""
    w, x, y, z = pose.orientation
    a, b, c = half
    return normalized(
        (
            w - x * a - y * b - z * c,
            x + w * a + y * c - z * b,
            y + w * b + z * a - x * c,
            z + w * c + x * b - y * a,
        )
    )
