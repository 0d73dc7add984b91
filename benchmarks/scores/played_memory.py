"""The hub's memory in process, fed in fast time by a scene's devices and a stepped pilot.

Devices of the twin -> their codec -> memory and detectors -> answers, wired as the hub wires them;
no process, no broker, no waiting.
"""

from __future__ import annotations

from pathlib import Path

from housefly.hub.api.answers import Answer
from housefly.hub.api.questions import Question
from housefly.hub.flight_facts import FlightFacts
from housefly.hub.memory import RoomMemory
from housefly.hub.query_handler import QueryHandler
from housefly.hub.room_status import RoomStatus
from housefly.hub.situation_service import SituationService
from housefly.hub.situations.device_traits import device_traits_of
from housefly.hub.store.open import open_store
from housefly.hub.things_of_room import catalogue_of, furniture_id, surfaces_of
from housefly.messages import Observation, PilotStep, RoomEvent
from housefly.sites.loaded_site import LoadedSite
from housefly.twin.people import Scene
from housefly.twin.sensors.devices import SimulatedDevices
from housefly.wires.devices import Delivered, Placement, decode_reading

DEVICE_PERIOD = 0.1
"""Time between two looks at what the devices send [s]: the floor reports as often."""
_DETECTORS_EVERY = 2
"""Device periods between two runs of the detectors."""
_STEPS_EVERY = 10
"""Steps of the pilot between two that are remembered."""


class PlayedMemory:
    """One room's memory on a stepped clock.

    Args:
        loaded: site and room.
        folder: for the memory's file.
        begin: Unix time of the begin [s].

    Attributes:
        now: Unix time [s].
    """

    def __init__(self, loaded: LoadedSite, folder: Path, begin: float) -> None:
        site, store = loaded.site, folder / "room.db"
        things = catalogue_of(site, loaded.room, folder)
        self._memory = RoomMemory(things, lambda: open_store(store), surfaces_of(loaded.room))
        status = RoomStatus(self._memory.writer.report)
        status.add_health_source(lambda: ())
        self._situations = SituationService(site, loaded.room, self._memory, status)
        self.now = begin
        self._queries = QueryHandler(self._memory, status, lambda: self.now, device_traits_of(site))
        self._facts = FlightFacts(
            site.tracking.body,
            site.tracking.kind,
            {piece.body: furniture_id(piece) for piece in site.furniture},
        )
        self._site = site.mqtt.site
        self._devices: SimulatedDevices | None = None
        self._tags = Placement()
        self._began, self._ticks = begin, 0

    def close(self) -> None:
        """Close the memory."""
        self._memory.close()

    def listen_to(self, scene: Scene) -> None:
        """Let the devices of a scene that begins now tell what they sense."""
        self._devices = SimulatedDevices(scene, self._site)
        self._tags = Placement(things={thing.tag: thing.name for thing in scene.script.things})
        self._began, self._ticks = self.now, 0

    def ask(self, question: Question) -> Answer:
        """Return the answer; raises ThingError when there is no such thing."""
        return self._queries.answer(question)

    def add(self, item: Observation | RoomEvent) -> None:
        """Remember what somebody tells."""
        self._memory.add(item)

    def advance(self) -> None:
        """Listen to the devices now, then let one device period pass."""
        self.now = self._began + self._ticks * DEVICE_PERIOD
        if self._devices is not None:
            for message in self._devices.messages(self.now - self._began, self.now):
                sent = Delivered(message.address, message.channel, message.payload, self.now)
                reading = decode_reading(sent, self._tags)
                told: tuple[Observation | RoomEvent, ...]
                told = (*reading.observations, *reading.events)
                for item in told:
                    self._memory.add(item)
        if self._ticks % _DETECTORS_EVERY == 0:
            self._situations.update(self.now)
        self._ticks += 1

    def hear(self, step: PilotStep) -> None:
        """Remember what a step of the pilot tells; its clock began with the scene's."""
        if step.sequence % _STEPS_EVERY == 0 or step.outputs.events:
            for item in self._facts.items_of(step, self._began):
                self._memory.add(item)
