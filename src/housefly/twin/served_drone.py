"""One drone of the simulated room on its real ports: its camera, and the faults on its links."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Coroutine
from typing import Any

from housefly.bus.rate import Rate
from housefly.config.process_log import log_line
from housefly.room.model import Room
from housefly.twin.camera.process import CameraProcess
from housefly.twin.drone_servers import FilmingServer, server_of
from housefly.twin.drone_stands import DroneStand
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.faults.wire_link import faulty_links, faulty_pictures
from housefly.twin.link_counters import Counters
from housefly.twin.people.script import PersonScript
from housefly.twin.world import SimulatedWorld


class ServedDrone:
    """Serves one drone of a world.

    Args:
        stand: which drone, its address, its site.
        world: what it flies in.
        room: what it sees.
        people: those of the room.
        faults: what befalls it.
        beyond_loopback: allow an address that other machines can reach.

    Attributes:
        faults: as given.

    Raises:
        ConfigError: an address that is not loopback, without ``beyond_loopback``.
    """

    def __init__(
        self,
        stand: DroneStand,
        world: SimulatedWorld,
        room: Room,
        people: tuple[PersonScript, ...],
        faults: FaultInjector,
        beyond_loopback: bool,
    ) -> None:
        self.faults = faults
        self._world, self._drone = world, world.drones[stand.name]
        self._rate_hz = stand.site.twin.video_rate_hz
        kind, address = stand.config.kind, stand.config.address
        filters = faulty_links(faults, self._now)
        self._server = server_of(
            kind, self._drone, address,
            beyond_loopback=beyond_loopback, filters=filters, environment=os.environ,
        )  # fmt: skip
        self._filmed = self._server if isinstance(self._server, FilmingServer) else None
        has_video = stand.site.twin.video and stand.config.enabled and self._filmed is not None
        self._camera = CameraProcess(stand.site, room, people) if has_video else None
        self._camera_state = (0, "")

    @property
    def films(self) -> bool:
        """Whether its camera is simulated."""
        return self._camera is not None

    @property
    def counters(self) -> Counters:
        """What happened on its ports so far, where its server counts."""
        return self._filmed.counters if self._filmed else Counters()

    async def start(self, open_parts: contextlib.AsyncExitStack) -> list[Coroutine[Any, Any, None]]:
        """Open its ports until the stack closes; return what must run meanwhile.

        Raises LinkError when a port cannot be had.
        """
        open_parts.push_async_callback(self._server.stop)
        await self._server.start()
        if self._camera is None or self._filmed is None:
            return []
        open_parts.callback(self._camera.close)
        self._camera.on_picture(faulty_pictures(self.faults, self._now, self._filmed.publish))
        self._camera.start()
        return [self._film(self._camera, self._filmed)]

    def act(self) -> None:
        """Let its faults act on it, and on who is in its way."""
        self.faults.act_on(self._world, self._drone)

    def _now(self) -> float:
        return self._world.now

    async def _film(self, camera: CameraProcess, server: FilmingServer) -> None:
        rate = Rate(self._rate_hz)
        while True:
            await rate.sleep()
            truth = self._drone.truth()
            view = self.faults.view(truth.pose, truth.at)
            if view is not None:
                camera.request_picture(
                    view,
                    self._world.visitor_present,
                    server.camera,
                    truth.at,
                    self._world.people(),
                )
            self._report_changes(camera)

    def _report_changes(self, camera: CameraProcess) -> None:
        """Print what changed about the camera since the last call."""
        state = camera.restarts, camera.problem
        if state == self._camera_state:
            return
        if camera.restarts != self._camera_state[0]:
            log_line(f"twin: the camera process ended and is started again ({camera.restarts})")
        if camera.problem != self._camera_state[1]:
            log_line(f"twin: the picture is a plain card: {camera.problem}")
        self._camera_state = state
