"""The simulated room on its real wires in this process, so that a test sees the truth."""

from __future__ import annotations

import asyncio
import contextlib
from dataclasses import dataclass, field
from math import hypot
from typing import Self

from housefly.clock import RealClock
from housefly.geometry import euler_from_quaternion
from housefly.sites.loaded_site import LoadedSite
from housefly.twin.drone_servers import server_of
from housefly.twin.link_filters import UNFILTERED, LinkFilters
from housefly.twin.mocap.tracking_servers import tracking_servers
from housefly.twin.real_time import RealTimeRunner
from housefly.twin.world import SimulatedWorld


@dataclass(frozen=True, slots=True)
class Moment:
    """The truth at one time of the world: x, y, height [m], speed over ground [m/s], lean [rad]."""

    at: float
    x: float
    y: float
    height: float
    speed: float
    lean: float


@dataclass
class RoomHere:
    """Serves drone and tracking of a site; an asynchronous context manager.

    Attributes:
        world: the simulated room.
        filters: what stands between the driver and the drone.
        is_tracked: whether tracking is heard of.
        moments: the truth so far, 200 a second.
    """

    loaded: LoadedSite
    filters: LinkFilters = UNFILTERED
    is_tracked: bool = True
    moments: list[Moment] = field(default_factory=list)

    async def __aenter__(self) -> Self:
        site = self.loaded.site
        self.world = SimulatedWorld(site, self.loaded.room)
        self._time = RealTimeRunner(self.world, RealClock())
        drone = server_of(
            site.drone.kind,
            self.world,
            site.drone.address,
            beyond_loopback=False,
            filters=self.filters,
        )
        self._trackers = tuple(tracking_servers(site))
        self._servers = (drone, *self._trackers)
        for server in self._servers:
            await server.start()
        self._running = asyncio.create_task(self._time.run(self._after_step))
        return self

    async def __aexit__(self, *_: object) -> None:
        self._running.cancel()
        with contextlib.suppress(asyncio.CancelledError):
            await self._running
        for server in self._servers:
            await server.stop()

    @property
    def now(self) -> Moment:
        """The newest moment."""
        return self.moments[-1]

    async def until(self, holds: object, seconds: float = 20.0) -> None:
        """Wait until something holds, for at most so long in the world's time."""
        assert callable(holds)
        end = self.world.now + seconds
        while not holds():
            assert self.world.now < end, f"not within {seconds} s: {self.now}"
            await asyncio.sleep(0.005)

    def way_since(self, start: Moment) -> float:
        """Return the largest distance from where the drone was then [m]."""
        return max(
            hypot(moment.x - start.x, moment.y - start.y)
            for moment in self.moments
            if moment.at >= start.at
        )

    def _after_step(self) -> None:
        for frame in self.world.mocap_frames():
            for server in self._trackers if self.is_tracked else ():
                server.publish(frame)
        truth = self.world.truth()
        (x, y, height), (vx, vy, _) = truth.pose.position, truth.velocity
        phi, theta, _ = euler_from_quaternion(truth.pose.orientation)
        moment = Moment(self.world.now, x, y, height, hypot(vx, vy), hypot(phi, theta))
        self.moments.append(moment)
