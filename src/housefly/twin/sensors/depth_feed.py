"""Sends the images of every depth camera of the site on the bus, as a real one's driver does."""

from __future__ import annotations

from functools import partial

from housefly.bus.bus import Bus
from housefly.bus.topics import DEPTH_TOPIC
from housefly.clock import Clock
from housefly.config.site import Site
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.faults.vocabulary import Injection
from housefly.twin.world import SimulatedWorld


class DepthFeed:
    """The depth cameras of a site.

    Args:
        site: which there are and how often each looks.
        world: what they look at.
        bus: where the images go.
        clock: the monotonic clock that stamps them.
        faults: what befalls the images; those of the site when not given.
    """

    def __init__(
        self,
        site: Site,
        world: SimulatedWorld,
        bus: Bus,
        clock: Clock,
        faults: FaultInjector | None = None,
    ) -> None:
        self._world, self._bus, self._clock = world, bus, clock
        self._faults = faults or FaultInjector(site, Injection.WIRES)
        self._periods = {camera.name: 1.0 / camera.rate_hz for camera in site.depth_cameras}
        self._due = dict.fromkeys(self._periods, 0.0)

    def publish(self) -> None:
        """Take and send the images that are due."""
        now = self._world.now
        for name, period in self._periods.items():
            if now >= self._due[name]:
                self._due[name] = now + period - 1e-3
                take = partial(self._world.depth_image, name, self._clock.now())
                for image in self._faults.depth_images(name, take, now):
                    self._bus.publish(DEPTH_TOPIC, image)
