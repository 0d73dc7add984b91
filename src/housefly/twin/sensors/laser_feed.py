"""Serves the site's scanners and feeds them scans; one without a client is not simulated."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from housefly.config.laser import scip_lasers
from housefly.config.site import Site
from housefly.twin.address import check_address
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.faults.vocabulary import Injection
from housefly.twin.sensors.laser_server import LaserServer
from housefly.twin.world import SimulatedWorld
from housefly.wires.scip.parameters import MODELS


class LaserFeed:
    """The scanners of a site on their wires.

    Args:
        site: where they answer.
        world: what they look at.
        beyond_loopback: allow addresses that other machines can reach.
        faults: what befalls the scans; those of the site when not given.
        slipped: time that the world has lost to stalls [s]; a scanner's own clock runs on.

    Raises:
        ConfigError: an address that is not loopback, without ``beyond_loopback``.
    """

    def __init__(
        self,
        site: Site,
        world: SimulatedWorld,
        beyond_loopback: bool = False,
        faults: FaultInjector | None = None,
        slipped: Callable[[], float] = lambda: 0.0,
    ) -> None:
        lasers = scip_lasers(site.lasers)
        for laser in lasers:
            number = site.lasers.index(laser)
            check_address(f"lasers.{number}.address", laser.address, beyond_loopback)
        self._world, self._faults = world, faults or FaultInjector(site, Injection.WIRES)
        self._slipped = slipped
        self._periods = {laser.name: MODELS[laser.model].period for laser in lasers}
        self._due = dict.fromkeys(self._periods, 0.0)
        self._servers = {
            laser.name: LaserServer(MODELS[laser.model], laser.address, laser.port, f"H{number:07}")
            for number, laser in enumerate(lasers, start=1)
        }

    async def start(self) -> None:
        """Listen on every port; raises LinkError when one cannot be had."""
        for server in self._servers.values():
            await server.start()

    async def stop(self) -> None:
        """Close every port and connection."""
        for server in self._servers.values():
            await server.stop()

    def publish(self) -> None:
        """Take the scans that are due and pass them on."""
        now = self._world.now
        for name, server in self._servers.items():
            if now >= self._due[name]:
                self._due[name] = now + self._periods[name] - 1e-3
                if server.is_measuring:
                    take = partial(self._world.scan, name)
                    for taken_at, scan in self._faults.scan(name, take, now):
                        server.publish(scan, round(1000.0 * (taken_at + self._slipped())))
