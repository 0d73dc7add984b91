"""The hub's process: ``python -m housefly.hub.process --site FILE --bus ENDPOINT [--port PORT]``.

It listens to the pilot, runs the drivers of the room's sensors, keeps what they tell, and answers
on the bus. It may die at any
time: the flight goes on, and what it had written is there when it is started again.
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
import time
from collections.abc import Callable, Sequence
from pathlib import Path

from housefly.bus.bus import Bus
from housefly.bus.topics import HUB_QUERY, OBSTACLE, ROOM_NEWS, SENSOR, STEP
from housefly.bus.zenoh_bus import ZenohBus
from housefly.clock import RealClock
from housefly.config.site import Site, load_site
from housefly.config.state import database_file
from housefly.errors import HouseflyError, LinkError
from housefly.hub.answers import Answers
from housefly.hub.api.room_json import answer_to_json, question_from_json, refusal_to_json
from housefly.hub.asking.discovery import ROOM_KEY
from housefly.hub.counter import Counter
from housefly.hub.flight_facts import FlightFacts
from housefly.hub.memory import RoomMemory
from housefly.hub.newsroom import PERIOD, Newsroom
from housefly.hub.obstacle_board import ObstacleBoard
from housefly.hub.pilot_health import PilotHealth
from housefly.hub.present import Present
from housefly.hub.sensor_board import SensorBoard
from housefly.hub.situation_desk import SituationDesk
from housefly.hub.store.opening import SERVERS, open_store
from housefly.hub.things.catalogue import load_catalogue
from housefly.hub.things.thing import Thing
from housefly.hub.things_of_room import thing_of, things_of
from housefly.messages import Happening, PilotStep
from housefly.pilot.planning.furniture import TrackedFurniture
from housefly.room.edits import room_of
from housefly.room.model import Room
from housefly.sensors.contracts import Sensor
from housefly.sensors.mqtt import MqttSensors

log = logging.getLogger(__name__)


class Hub:
    """The parts of the hub and how they feed each other.

    Args:
        site: which sensors there are, and where the memory is.
        folder: of the site file, for relative paths.
        bus: where the pilot and those who ask are.
    """

    def __init__(self, site: Site, folder: Path, bus: Bus) -> None:
        room = room_of(site, folder)
        address = store_address(site)
        self.memory = RoomMemory(
            catalogue_of(site, room, folder),
            lambda: open_store(address, keep_days=site.hub.keep_days),
        )
        self.present = Present(self.memory.writer.report)
        self._answers = Answers(self.memory, self.present, time.time)
        self._obstacles = ObstacleBoard(self.present, RealClock())
        self._furniture = TrackedFurniture(site, room)
        self._situations = SituationDesk(site, room, self.memory, self.present)
        self._sensors: tuple[Sensor, ...] = (MqttSensors(site.mqtt),) if site.mqtt.broker else ()
        self._pilot = PilotHealth(site.tracking.kind, RealClock())
        self._facts = FlightFacts(
            site.tracking.body,
            site.tracking.kind,
            {piece.body: thing_of(piece) for piece in site.furniture},
        )
        self._others = SensorBoard(site, RealClock())
        for watched in (self._pilot, *self._sensors, self._others):
            self.present.watch(watched.health)
        self._newsroom = Newsroom(self.memory, self.present, time.time)
        self._bus = bus
        self._subscriptions = (
            bus.subscribe(STEP, self._step),
            bus.subscribe(OBSTACLE, self._obstacles.heard),
            bus.subscribe(SENSOR, self._others.heard),
            bus.answer(HUB_QUERY, self.answer),
        )

    async def run(self) -> None:
        """Run the drivers until cancelled."""
        self.memory.take(Happening("memory started", "hub", time.time(), "hub"))
        async with asyncio.TaskGroup() as tasks:
            for sensor in self._sensors:
                tasks.create_task(sensor.run(self.memory.take))
            tasks.create_task(self._tell())

    def close(self) -> None:
        """Write what is left and let go."""
        for subscription in self._subscriptions:
            subscription.close()
        self.memory.close()

    async def _tell(self) -> None:
        while True:
            await asyncio.sleep(PERIOD)
            self._obstacles.step()
            self._situations.step(time.time())
            if (news := self._newsroom.news()) is not None:
                self._bus.publish(ROOM_NEWS, news)

    def _step(self, step: PilotStep) -> None:
        self._pilot.heard(step)
        for obstacle in self._furniture.step(step.inputs.sightings, step.now):
            self._obstacles.heard(obstacle)
        unix = time.time() - time.monotonic()
        for item in self._facts.after(step, unix):
            self.memory.take(item)

    def answer(self, text: str) -> str:
        """Return the answer to a question, both JSON; safe from any thread, raises nothing."""
        try:
            return answer_to_json(self._answers.answer(question_from_json(text)))
        except HouseflyError as error:
            return refusal_to_json(error)
        except Exception:
            log.exception("a question could not be answered: %s", text[:500])
            return refusal_to_json(HouseflyError("the hub could not answer that; its log says why"))


def catalogue_of(site: Site, room: Room, folder: Path) -> tuple[Thing, ...]:
    """Return the things of a room and those of the site's own catalogue; raises ConfigError for a
    bad one.
    """
    own = load_catalogue(folder / site.hub.things) if site.hub.things else ()
    return (*things_of(site, room), *own)


def store_address(site: Site) -> str:
    """Return where a site's memory is: what the site says, or a file in the user's state folder,
    which is made.
    """
    if site.hub.store.startswith(SERVERS):
        return site.hub.store
    path = database_file(site)
    path.parent.mkdir(parents=True, exist_ok=True)
    return str(path)


async def run_hub(site: Site, folder: Path, endpoint: str, port: int = 0, key: str = "") -> None:
    """Remember and answer until SIGTERM, SIGINT or cancellation.

    Args:
        site: which sensors there are, and where the memory is.
        folder: of the site file, for relative paths.
        endpoint: of the bus.
        port: on which programs of this machine ask, with a key; 0 for none.
        key: bearer token of the run.

    Raises:
        StoreError, ConfigError: it cannot begin.
    """
    with ZenohBus(connect=endpoint) as bus:
        hub = Hub(site, folder, bus)
        counter = opened_counter(hub.answer, key, port) if port and key else None
        working = asyncio.create_task(hub.run())
        for number in (signal.SIGTERM, signal.SIGINT):
            asyncio.get_running_loop().add_signal_handler(number, working.cancel)
        gc.freeze()  # what lives for the whole run need not be walked by every collection while somebody waits
        print(f"hub ready: memory in {store_address(site)}", flush=True)
        try:
            with contextlib.suppress(asyncio.CancelledError):
                await working
        finally:
            if counter is not None:
                counter.close()
            hub.close()


def opened_counter(answer: Callable[[str], str], key: str, port: int) -> Counter | None:
    """Open the counter; without it programs ask over HTTP, and the room is remembered all the same."""
    try:
        return Counter(answer, key, port)
    except LinkError as error:
        log.warning("%s", error)
        return None


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the hub of a site until told to leave; returns the exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m housefly.hub.process", description="Remember what the room tells."
    )
    parser.add_argument("--site", type=Path, required=True, help="site file")
    parser.add_argument(
        "--bus", required=True, help="zenoh endpoint of the pilot, for example tcp/127.0.0.1:7447"
    )
    parser.add_argument(
        "--port",
        type=int,
        default=0,
        help=f"loopback TCP port for who asks, with the key in {ROOM_KEY}",
    )
    options = parser.parse_args(arguments)
    logging.basicConfig(level=logging.INFO, format="%(asctime)s %(name)s %(message)s")
    try:
        key = os.environ.get(ROOM_KEY, "")
        asyncio.run(
            run_hub(load_site(options.site), options.site.parent, options.bus, options.port, key)
        )
    except HouseflyError as error:
        print(f"hub: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
