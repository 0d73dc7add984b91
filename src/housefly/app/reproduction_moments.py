"""Moments of a service that are shown beside each other: the pilot's step, console and camera."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from pathlib import Path

import numpy as np

from housefly.app.console_camera import ConsoleCamera
from housefly.lab.reproduction.fig17_service import RgbImage
from housefly.messages import Phase, PilotStep

MOMENTS: tuple[tuple[str, Phase, float], ...] = (
    ("taking off", Phase.TAKING_OFF, 3.0),
    ("on the way", Phase.OUTBOUND, 8.0),
    ("at the entrance, looking at the visitor", Phase.LOOKING, 2.0),
    ("on the way back", Phase.RETURNING, 6.0),
    ("landing", Phase.LANDING, 1.0),
)
"""What the strip shows: words, phase, and how long the phase has lasted [s]."""


@dataclass(frozen=True, slots=True, eq=False)
class MomentShot:
    """The pilot's step at one moment, and the console as it was where there is a browser."""

    title: str
    step: PilotStep
    console: RgbImage | None


class MomentShots:
    """Keeps the pilot's step at each moment and photographs the console."""

    def __init__(self, camera: ConsoleCamera) -> None:
        self._camera = camera
        self._phase, self._since = Phase.IDLE, -inf
        self._steps: dict[str, PilotStep] = {}

    def update(self, step: PilotStep) -> None:
        """Add one step of the pilot."""
        if step.outputs.phase is not self._phase:
            self._phase, self._since = step.outputs.phase, step.now
        for title, phase, after in MOMENTS:
            if (
                title not in self._steps
                and phase is self._phase
                and step.now - self._since >= after
            ):
                self._steps[title] = step
                self._camera.shoot(title)

    def shots(self) -> tuple[MomentShot, ...]:
        """Return the moments that came."""
        pictures = self._camera.pictures()
        return tuple(
            MomentShot(title, step, pictures.get(title)) for title, step in self._steps.items()
        )


def video_pictures(folder: Path, ages: tuple[float, ...]) -> tuple[RgbImage | None, ...]:
    """Return the pictures of ``video.mp4`` that many seconds before its last one, or None."""
    import av

    path = folder / "video.mp4"
    found: list[RgbImage | None] = [None] * len(ages)
    if not path.is_file():
        return tuple(found)
    with av.open(str(path)) as movie:
        times = [
            float(packet.pts * packet.time_base)
            for packet in movie.demux(video=0)
            if packet.pts is not None
        ]
    if not times:
        return tuple(found)
    wanted = [times[-1] - age for age in ages]
    with av.open(str(path)) as movie:
        for frame in movie.decode(video=0):
            for index, at in enumerate(wanted):
                if frame.time is not None and frame.time <= at + 0.02 and frame.time > at - 0.5:
                    found[index] = np.asarray(frame.to_ndarray(format="rgb24"), dtype=np.uint8)
    return tuple(found)
