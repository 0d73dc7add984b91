"""The room: its bus and its tracking system; ``python -m housefly.app.room_main``.

It listens on the bus, which all others join, hears the tracking system and tells where the bodies
are: everybody on the bus, and pilots on a socket of their own. A pilot that dies blinds nobody.
Where there is no drone it stands for the pilot, too; it orders nothing.
"""

from __future__ import annotations

import asyncio
import gc
import signal
from collections.abc import Coroutine
from contextlib import suppress
from pathlib import Path

from housefly.app.machine_load import machine_load
from housefly.app.priority import raise_priority
from housefly.app.runtime import Runtime, runtime_from_environment
from housefly.app.views import room_view
from housefly.bus.bus import Bus
from housefly.bus.rate import Frequency
from housefly.bus.topics import FRAME_TOPIC, DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.clock import Clock, RealClock
from housefly.config.process_log import log_line, log_traceback
from housefly.errors import HouseflyError
from housefly.hub.api.pilot_queries import PreflightView
from housefly.hub.api.pilot_queries_json import to_json
from housefly.messages import LinkStatus, PlanAnswer, Sighting, TrackedFrame
from housefly.messages.words import literal
from housefly.sites.loaded_site import LoadedSite, open_site
from housefly.tasks.document.open_library import NO_DRONE
from housefly.tracking.contracts import Tracker
from housefly.tracking.sighting_server import SightingServer
from housefly.tracking.trackers import tracker_of

_LINK_PERIOD = 0.5
"""How often the health of tracking is published [s]."""


class RoomTracking:
    """Hears the tracking system and tells where the bodies are.

    Args:
        tracker: of the tracking system.
        bus: of the run.
        socket: where pilots are told.
        clock: of all stamps.

    Attributes:
        frames: how often one came.
    """

    def __init__(self, tracker: Tracker, bus: Bus, socket: Path, clock: Clock) -> None:
        self.frames = Frequency()
        self._tracker, self._bus, self._clock = tracker, bus, clock
        self._server = SightingServer(tracker, socket)

    async def run(self) -> None:
        """Run until cancelled."""
        await asyncio.gather(self._server.run(), self._tracker.run(self._on_sightings))

    def _on_sightings(self, sightings: tuple[Sighting, ...]) -> None:
        self._server.send_sightings(sightings)  # pilots before all others
        self.frames.add(self._clock.now())
        try:
            self._bus.publish(FRAME_TOPIC, TrackedFrame(sightings))
        except HouseflyError:
            log_traceback()


class DronelessPilot:
    """Stands for the pilot where nothing flies: tells how tracking is, and answers for the room.

    Args:
        loaded: the site.
        bus: of the run.
        tracker: of the tracking system; None where there is none.
        frames: how often one came.
        clock: of all stamps.
    """

    def __init__(
        self,
        loaded: LoadedSite,
        bus: Bus,
        tracker: Tracker | None,
        frames: Frequency,
        clock: Clock,
    ) -> None:
        self._tracker, self._clock = tracker, clock
        self._frames, self._late = frames, 0.0
        self._bus = bus
        room, home = to_json(room_view(loaded)), loaded.room.home
        refused = to_json(PlanAnswer(home, home, None, literal(NO_DRONE)))
        unready = to_json(PreflightView())
        topics = self._topics = DroneTopics(loaded.site.drone.name)
        self._answering = [
            bus.answer(topics.room, lambda _: room),
            bus.answer(topics.plan, lambda _: refused),
            bus.answer(topics.preflight, lambda _: unready),
            bus.answer(topics.stand_down, lambda _: ""),
        ]

    async def run(self) -> None:
        """Run until cancelled."""
        try:
            while True:
                self._bus.publish(self._topics.link, self._link_status())
                due = self._clock.now() + _LINK_PERIOD
                await asyncio.sleep(_LINK_PERIOD)
                self._late = self._clock.now() - due
        finally:
            for answering in self._answering:
                answering.close()

    def _link_status(self) -> LinkStatus:
        now, tracker = self._clock.now(), self._tracker
        notes = (tracker.problem if tracker else "", machine_load(self._late).note)
        return LinkStatus(
            at=now,
            tracking_connected=tracker is not None and tracker.connected,
            tracking_rate_hz=self._frames.rate_hz(now),
            loop_p99_s=max(0.0, self._late),
            loop_max_s=max(0.0, self._late),
            notes=tuple(map(literal, filter(None, notes))),
        )


async def _run(runtime: Runtime, loaded: LoadedSite) -> None:
    site, clock = loaded.site, RealClock()
    tracker = tracker_of(site.tracking, clock) if site.tracking.enabled else None
    with ZenohBus(listen=runtime.bus) as bus:
        work, frames = list[Coroutine[None, None, None]](), Frequency()
        if tracker is not None:
            tracking = RoomTracking(tracker, bus, runtime.tracking_socket, clock)
            work, frames = [tracking.run()], tracking.frames
        if not site.drone_names:
            work.append(DronelessPilot(loaded, bus, tracker, frames, clock).run())
        running = asyncio.gather(*work)
        loop = asyncio.get_running_loop()
        for number in (signal.SIGINT, signal.SIGTERM):
            loop.add_signal_handler(number, running.cancel)
        log_line("room ready")
        with suppress(asyncio.CancelledError):
            await running


def main() -> None:
    """Run until SIGINT or SIGTERM."""
    runtime = runtime_from_environment()
    loaded = open_site(runtime.site())
    raise_priority()
    gc.collect()
    gc.freeze()
    asyncio.run(_run(runtime, loaded))


if __name__ == "__main__":
    main()
