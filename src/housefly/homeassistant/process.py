"""Home Assistant's process: ``python -m housefly.homeassistant.process --site FILE --bus END``.

Started by the launcher where ``homeassistant.enabled``. It listens on the bus and asks hub and
tasks as anybody does; when it dies, flights go on, and the broker tells Home Assistant.
"""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import gc
import logging
import os
import signal
import sys
from collections.abc import Sequence
from functools import partial
from pathlib import Path

from housefly.bus.bus import Bus, Subscription
from housefly.bus.stop_sender import StopSender
from housefly.bus.topics import DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.clock import Clock, RealClock
from housefly.config.environment import (
    SECRET_VARIABLE,
    STOP_PORTS_VARIABLE,
    stop_ports_of_text,
)
from housefly.config.process_log import log_line
from housefly.config.repeated_work import repeat
from housefly.config.site import Site, site_from_file
from housefly.config.state import clips_folder
from housefly.errors import ConfigError, HouseflyError, LinkError
from housefly.evidence.clip_index import ClipIndex
from housefly.homeassistant.drone_entities import picture_key
from housefly.homeassistant.home_link import HomeLink
from housefly.homeassistant.home_requests import HomeRequests
from housefly.homeassistant.home_view import HomeView
from housefly.homeassistant.last_pictures import LastPictures
from housefly.homeassistant.live_camera import LiveCamera
from housefly.homeassistant.room_reader import RoomReader
from housefly.hub.api.answers import News
from housefly.hub.api.topics import ROOM_NEWS_TOPIC
from housefly.messages import PilotStep
from housefly.room.edits import room_of
from housefly.room.model import Room
from housefly.tasks.api.topics import TASK_NEWS_TOPIC

_READ_PERIOD, _CAMERA_PERIOD, _LINK_PERIOD = 0.2, 0.5, 2.0
"""How often one looks what to ask the room, whether a picture is over, how the broker does [s]."""
_KEPT = "snapshot kept"


class HomeProcess:
    """Home Assistant's view of one run.

    Args:
        site: what is shown, and what may be asked for.
        room: its places and pads.
        bus: of the run.
        stops: a sender for each drone, by name.
    """

    def __init__(self, site: Site, room: Room, bus: Bus, stops: dict[str, StopSender]) -> None:
        self._bus, clock = bus, RealClock()
        self._view = HomeView(site, room, clock)
        self._reader = RoomReader(bus, self._view, clock, has_tasks=site.tasks.enabled)
        self._requests = HomeRequests(
            site.homeassistant,
            self._view.topics,
            [place.name for place in room.places],
            {name: sender.send for name, sender in stops.items()},
            bus,
            self._view.board,
            clock,
        )
        self._pictures = _last_pictures(site, self._view)
        self._wants_pictures = asyncio.Event()
        self._link = HomeLink(site, self._view, self._requests, clock, self._wants_pictures.set)
        self._cameras = {
            name: self._camera_of(site, name, clock)
            for name in site.drone_names
            if site.homeassistant.pictures and site.for_drone(name).drone.has_camera
        }
        self._drones = site.drone_names

    async def run(self) -> None:
        """Run until cancelled."""
        self._loop = asyncio.get_running_loop()
        subscriptions = self._listen()
        try:
            async with asyncio.TaskGroup() as tasks:
                tasks.create_task(self._link.run_for_ever())
                tasks.create_task(repeat(_READ_PERIOD, self._reader.read, "homeassistant"))
                tasks.create_task(repeat(_CAMERA_PERIOD, self._end_pictures, "homeassistant"))
                tasks.create_task(repeat(_LINK_PERIOD, self._check_link, "homeassistant"))
                if self._pictures is not None:
                    tasks.create_task(self._show_pictures(self._pictures))
        finally:
            for subscription in subscriptions:
                subscription.close()
            self._requests.close()

    def _listen(self) -> list[Subscription]:
        found = [
            self._bus.subscribe(ROOM_NEWS_TOPIC, self._on_news),
            self._bus.subscribe(TASK_NEWS_TOPIC, self._view.hear_board),
        ]
        for name in self._drones:
            topics = DroneTopics(name)
            found.append(self._bus.subscribe(topics.step, partial(self._on_step, name)))
            if name in self._cameras:
                found.append(self._bus.subscribe(topics.video, self._cameras[name].add_frame))
        return found

    def _check_link(self) -> None:
        """Raise LinkError while the broker is not there, so that the log says why."""
        if problem := self._link.problem:
            raise LinkError(problem)

    def _on_news(self, news: News) -> None:
        for topic, payload in self._view.hear_news(news):
            self._link.send(topic, payload)
        self._reader.touch([thing.thing for thing in news.things])
        if any(event.kind == _KEPT for event in news.events):
            self._loop.call_soon_threadsafe(self._wants_pictures.set)

    def _on_step(self, drone: str, step: PilotStep) -> None:
        self._view.hear_step(drone, step)
        if drone in self._cameras:
            self._cameras[drone].add_step(step)

    def _camera_of(self, site: Site, name: str, clock: Clock) -> LiveCamera:
        topic = self._view.topics.picture(picture_key(name, "camera"))
        camera = site.for_drone(name).drone.airframe.capabilities.camera
        show = partial(self._link.send, topic)
        return LiveCamera(site.tasks, camera, self._view.mode, show, clock)

    def _end_pictures(self) -> None:
        for camera in self._cameras.values():
            camera.look_at_end()

    async def _show_pictures(self, pictures: LastPictures) -> None:
        """Send the last pictures when there is a new one, and when Home Assistant is there anew."""
        while True:
            await self._wants_pictures.wait()
            self._wants_pictures.clear()
            await asyncio.sleep(1.0)  # it subscribes only when it has read what is announced
            for topic, payload in await asyncio.to_thread(pictures.messages):
                self._link.send(topic, payload)


def _last_pictures(site: Site, view: HomeView) -> LastPictures | None:
    if not (site.homeassistant.pictures and site.tasks.enabled and site.drone_names):
        return None
    try:
        index = ClipIndex(clips_folder(site), site.tasks)
    except HouseflyError as error:
        log_line(f"homeassistant: no snapshots are shown: {error}", sys.stderr)
        return None
    return LastPictures(index, site.drone_names, view.topics, view.mode)


def stop_senders() -> dict[str, StopSender]:
    """Return a sender for each drone that is flown; raises ConfigError without a launcher."""
    try:
        ports = stop_ports_of_text(os.environ[STOP_PORTS_VARIABLE])
        secret = os.environ[SECRET_VARIABLE]
        return {name: StopSender("127.0.0.1", port, secret) for name, port in ports.items()}
    except (KeyError, ValueError) as error:
        raise ConfigError(
            "environment", f"{error}: this process is started by `housefly run`"
        ) from error


async def _run(site: Site, endpoint: str) -> None:
    room, stops = room_of(site), stop_senders()
    with ZenohBus(connect=endpoint) as bus:
        running = asyncio.create_task(HomeProcess(site, room, bus, stops).run())
        loop = asyncio.get_running_loop()
        for number in (signal.SIGINT, signal.SIGTERM):
            loop.add_signal_handler(number, running.cancel)
        # Objects that live for the whole run need not be scanned by every collection.
        gc.freeze()
        log_line("homeassistant ready")
        with contextlib.suppress(asyncio.CancelledError):
            await running
        for sender in stops.values():
            sender.close()


def main(arguments: Sequence[str] | None = None) -> int:
    """Run until SIGINT or SIGTERM; returns the exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m housefly.homeassistant.process",
        description="Show a site in Home Assistant.",
    )
    parser.add_argument("--site", type=Path, required=True, help="site file")
    parser.add_argument("--bus", required=True, help="zenoh endpoint of the run")
    options = parser.parse_args(arguments)
    logging.basicConfig(level=logging.INFO, format="%(asctime)s %(name)s %(message)s")
    try:
        asyncio.run(_run(site_from_file(options.site), options.bus))
    except HouseflyError as error:
        log_line(f"homeassistant: {error}", sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
