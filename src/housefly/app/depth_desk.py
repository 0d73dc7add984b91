"""Depth images from the bus to obstacles on the bus; works on the bus's own thread, so that no
scanner waits for a picture.
"""

from __future__ import annotations

import threading
from math import inf

from housefly.app.premises import Premises
from housefly.bus.bus import Bus
from housefly.bus.topics import DEPTH, OBSTACLE
from housefly.clock import Clock
from housefly.messages import DepthImage, SensorReport
from housefly.perception.depth_watcher import DepthWatcher
from housefly.perception.watcher import Own
from housefly.room.tracked import untracked
from housefly.sensors.pulse import Pulse

SILENT = 2.0
"""A camera that sends nothing for this long is told [s]."""
TOLD_FOR = 5.0
"""A refusal of an image is told for this long [s]."""


class DepthDesk:
    """Takes in the images of a site's depth cameras, until closed.

    Attributes:
        own: where the drone is, None when it is not in the air or not known.
    """

    def __init__(self, premises: Premises, bus: Bus, clock: Clock) -> None:
        site = premises.site
        height, half = site.map.flight_height, site.map.half_band
        self.own: Own | None = None
        self._bus, self._clock = bus, clock
        self._watcher = DepthWatcher(
            untracked(premises.room, site), site.depth_cameras, (height - half, height + half)
        )
        names = [camera.name for camera in site.depth_cameras]
        self._lock = threading.Lock()
        self._pulses = {name: Pulse() for name in names}
        self._refused = dict.fromkeys(["", *names], ("", -inf))
        self._subscription = bus.subscribe(DEPTH, self._on_image) if names else None

    def reports(self) -> tuple[SensorReport, ...]:
        """Return how each camera does, and one more line when somebody who is no camera of this
        site sends images.
        """
        with self._lock:
            told = [
                self._report(name, pulse, self._clock.now()) for name, pulse in self._pulses.items()
            ]
            return (*told, *self._strangers(self._clock.now()))

    def _report(self, name: str, pulse: Pulse, now: float) -> SensorReport:
        age = pulse.age(now)
        is_heard = age <= SILENT
        problem = self._refusal(name, now) or ("" if is_heard else f"{name}: no depth images")
        return SensorReport(name, "depth camera", is_heard, pulse.rate_hz(now), age, problem)

    def _strangers(self, now: float) -> tuple[SensorReport, ...]:
        problem = self._refusal("", now)
        return (
            (SensorReport("other images", "depth camera", False, 0.0, inf, problem),)
            if problem
            else ()
        )

    def _refusal(self, name: str, now: float) -> str:
        words, at = self._refused[name]
        return words if now - at < TOLD_FOR else ""

    def close(self) -> None:
        """Stop listening."""
        if self._subscription is not None:
            self._subscription.close()

    def _on_image(self, image: DepthImage) -> None:
        now = self._clock.now()
        name = image.source if image.source in self._pulses else ""
        seen = self._watcher.step(image, now, self.own)
        with self._lock:
            if name:
                self._pulses[name].beat(now)
            if seen.problem:
                self._refused[name] = seen.problem, now
        for obstacle in seen.obstacles:
            self._bus.publish(OBSTACLE, obstacle)
