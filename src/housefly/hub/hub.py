"""The hub: the parts that remember the room and answer questions about it, wired together."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable
from pathlib import Path

from housefly.bus.bus import Bus
from housefly.bus.topics import (
    FRAME_TOPIC,
    HUB_QUERY,
    OBSTACLE_TOPIC,
    ROOM_EVENT_TOPIC,
    SENSOR_TOPIC,
    DroneTopics,
)
from housefly.clock import RealClock
from housefly.config.site import Site
from housefly.errors import HouseflyError
from housefly.hub.api.json import answer_to_json, question_from_json, refusal_to_json
from housefly.hub.api.told_events import checked_event
from housefly.hub.api.topics import ROOM_NEWS_TOPIC
from housefly.hub.change_feed import CHANGE_FEED_PERIOD, ChangeFeed
from housefly.hub.flight_facts import FlightFacts
from housefly.hub.memory import RoomMemory
from housefly.hub.obstacle_status import ObstacleStatus
from housefly.hub.pilot_health import PilotHealth
from housefly.hub.query_handler import QueryHandler
from housefly.hub.room_status import RoomStatus
from housefly.hub.sensor_status import SensorStatus
from housefly.hub.situation_service import SituationService
from housefly.hub.situations.device_traits import device_traits_of
from housefly.hub.situations_at import MEMORY_STARTED
from housefly.hub.store.open import open_site_store
from housefly.hub.things_of_room import catalogue_of, furniture_id, surfaces_of
from housefly.hub.wall_clock import WallClock
from housefly.messages import PilotStep, RoomEvent, TrackedFrame
from housefly.pilot.planning.furniture import TrackedFurniture
from housefly.room.edits import room_of
from housefly.sensors.contracts import Sensor
from housefly.sensors.mqtt import MqttSensors

_log = logging.getLogger(__name__)


class Hub:
    """The parts of the hub and how they are connected.

    Args:
        site: its sensors, and the address of its store.
        folder: of the site file, for relative paths.
        bus: of the pilot and of whoever asks.
    """

    def __init__(self, site: Site, folder: Path, bus: Bus) -> None:
        room = room_of(site, folder)
        self.memory = RoomMemory(
            catalogue_of(site, room, folder),
            lambda: open_site_store(site),
            surfaces_of(room),
        )
        self.clock = WallClock(newest=self.memory.newest())
        self.status = RoomStatus(self.memory.writer.report)
        self._queries = QueryHandler(
            self.memory, self.status, self.clock.now, device_traits_of(site)
        )
        self._obstacles = ObstacleStatus(self.status, RealClock())
        self._furniture = TrackedFurniture(site, room)
        self._situations = SituationService(site, room, self.memory, self.status)
        self._sensors: tuple[Sensor, ...] = (
            (MqttSensors(site.mqtt, wall=self.clock.now),) if site.mqtt.broker else ()
        )
        tracking = site.tracking.kind if site.tracking.enabled else ""
        first, *others = site.drone_names or ("",)
        self._tracking = PilotHealth(tracking, RealClock(), first)
        pilots = {first: self._tracking} | {
            name: PilotHealth("", RealClock(), name) for name in others
        }
        things = {piece.body: furniture_id(piece) for piece in site.furniture}
        self._facts = FlightFacts(site.tracking.body, site.tracking.kind, things)
        self._sensor_status = SensorStatus(site, RealClock())
        for watched in (*pilots.values(), *self._sensors, self._sensor_status, self.clock):
            self.status.add_health_source(watched.health)
        self._change_feed = ChangeFeed(self.memory, self.status, self.clock.now)
        self._bus = bus
        self._subscriptions = (
            bus.subscribe(FRAME_TOPIC, self._frame),
            *(
                bus.subscribe(
                    DroneTopics(name).step,
                    self._steps_of(
                        pilot,
                        FlightFacts(site.for_drone(name).tracking.body, site.tracking.kind, things),
                    ),
                )
                for name, pilot in pilots.items()
                if name
            ),
            bus.subscribe(OBSTACLE_TOPIC, self._obstacles.update),
            bus.subscribe(SENSOR_TOPIC, self._sensor_status.update),
            bus.subscribe(ROOM_EVENT_TOPIC, self._told),
            bus.answer(HUB_QUERY, self.answer),
        )

    async def run(self) -> None:
        """Run the drivers until cancelled."""
        self.memory.add(RoomEvent(MEMORY_STARTED, "hub", self.clock.now(), "hub"))
        async with asyncio.TaskGroup() as tasks:
            for sensor in self._sensors:
                tasks.create_task(sensor.run(self.memory.add))
            tasks.create_task(self._publish_changes())

    def close(self) -> None:
        """Write what waits and close everything."""
        for subscription in self._subscriptions:
            subscription.close()
        self.memory.close()

    async def _publish_changes(self) -> None:
        while True:
            await asyncio.sleep(CHANGE_FEED_PERIOD)
            self._obstacles.refresh()
            self._situations.update(self.clock.now())
            if (news := self._change_feed.changes()) is not None:
                self._bus.publish(ROOM_NEWS_TOPIC, news)

    def _steps_of(self, pilot: PilotHealth, facts: FlightFacts) -> Callable[[PilotStep], None]:
        """Return what keeps the steps of one drone."""

        def on_step(step: PilotStep) -> None:
            pilot.update(step)
            for item in facts.items_of(step, self.clock.offset()):
                self.memory.add(item)

        return on_step

    def _frame(self, frame: TrackedFrame) -> None:
        self._tracking.update_frame(frame.sightings)
        now = max((one.received_at for one in frame.sightings), default=0.0)
        for obstacle in self._furniture.step(frame.sightings, now):
            self._obstacles.update(obstacle)
        offset = self.clock.offset()
        for sighting in frame.sightings:
            self.memory.add(self._facts.seen(sighting, offset))

    def _told(self, event: RoomEvent) -> None:
        self.memory.add(checked_event(event, self.clock.now()))

    def answer(self, text: str) -> str:
        """Return the answer to a question, both JSON; thread-safe, never raises."""
        try:
            return answer_to_json(self._queries.answer(question_from_json(text)))
        except HouseflyError as error:
            return refusal_to_json(error)
        except Exception:
            _log.exception("a question could not be answered: %s", text[:500])
            return refusal_to_json(HouseflyError("the hub could not answer that; its log says why"))
