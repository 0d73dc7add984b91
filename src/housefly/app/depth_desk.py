"""Depth images from the bus to obstacles on the bus; works on the bus's own thread, so that no scanner waits for a picture."""

from __future__ import annotations

from math import inf

from housefly.app.premises import Premises
from housefly.bus.bus import Bus
from housefly.bus.topics import DEPTH, OBSTACLE
from housefly.clock import Clock
from housefly.messages import DepthImage
from housefly.perception.depth_watcher import DepthWatcher
from housefly.perception.watcher import Own

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
        self._watcher = DepthWatcher(premises.room, site.depth_cameras, (height - half, height + half))
        names = [camera.name for camera in site.depth_cameras]
        self._heard_at = dict.fromkeys(names, -inf)
        self._refused = dict.fromkeys(["", *names], ("", -inf))
        self._subscription = bus.subscribe(DEPTH, self._on_image) if names else None

    @property
    def problems(self) -> tuple[str, ...]:
        """What is wrong with the cameras or what they send, in words."""
        now = self._clock.now()
        silent = (f"{name}: no depth images" for name, at in self._heard_at.items() if now - at > SILENT)
        return (*silent, *(words for words, at in self._refused.values() if now - at < TOLD_FOR))

    def close(self) -> None:
        """Stop listening."""
        if self._subscription is not None:
            self._subscription.close()

    def _on_image(self, image: DepthImage) -> None:
        now = self._clock.now()
        name = image.source if image.source in self._heard_at else ""
        if name:
            self._heard_at[name] = now
        seen = self._watcher.step(image, now, self.own)
        if seen.problem:
            self._refused[name] = seen.problem, now
        for obstacle in seen.obstacles:
            self._bus.publish(OBSTACLE, obstacle)
