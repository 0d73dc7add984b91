"""Runs the detectors on everything that the memory accepts, and feeds their events back into it."""

from __future__ import annotations

import threading
from collections.abc import Iterable

from housefly.config.site import Site
from housefly.hub.api.answers import SituationAnswer
from housefly.hub.memory import RoomMemory
from housefly.hub.room_status import RoomStatus
from housefly.hub.said import situation_words
from housefly.hub.situations import Layout, Situations
from housefly.hub.situations.device_traits import device_traits_of
from housefly.hub.situations.furniture import beds_of, entrance_of, seats_of
from housefly.hub.situations.kinds import SituationKind
from housefly.hub.situations.situation import evidence_words, sources_of
from housefly.hub.situations_at import lasting_facts
from housefly.hub.things.thing import Thing, ThingKind
from housefly.messages import Observation, RoomEvent
from housefly.room.model import Room

_MAX_WAITING = 20_000
"""At most this many items wait for the detectors; the memory keeps the rest as well."""


class SituationService:
    """Feeds one site's detectors; items may come from any thread, ``update`` from one."""

    def __init__(self, site: Site, room: Room, memory: RoomMemory, status: RoomStatus) -> None:
        self._memory, self._status = memory, status
        self._situations = Situations(
            _layout_of(site, room, memory.world.of_kind(ThingKind.FURNITURE))
        )
        self._lock = threading.Lock()
        self._waiting: list[Observation | RoomEvent] = []
        memory.add_listener(self._enqueue)

    def update(self, now: float) -> None:
        """Run the detectors up to now [Unix time, s]."""
        with self._lock:
            items, self._waiting = self._waiting, []
        for event in self._situations.update(items, now):
            self._memory.add(event)
            if event.kind == SituationKind.OBJECT_TAKEN and event.cause:
                # It is with whoever took it, until a sensor says where it was put.
                at = event.at
                self._memory.add(
                    Observation(event.thing, event.source, at, now, inside=event.cause)
                )
        holds = (
            SituationAnswer(
                s.kind.value,
                s.thing,
                s.since,
                s.confidence,
                evidence_words(s.evidence),
                lasting_facts(s.facts),
                sources_of(s.evidence),
                situation_words(s.kind),
            )
            for s in self._situations.active()
        )
        self._status.set_situations(holds, "detectors")

    def _enqueue(self, item: Observation | RoomEvent) -> None:
        with self._lock:
            if len(self._waiting) < _MAX_WAITING:
                self._waiting.append(item)


def _layout_of(site: Site, room: Room, furniture: Iterable[Thing]) -> Layout:
    """Return what the detectors know in advance; beds, bells and motion sensors by their ids."""
    names = [d.id for d in site.mqtt.devices if "bed" in d.id] or ["bed"]
    return Layout(
        seats=seats_of(room),
        beds=dict(zip(names, beds_of(room), strict=False)),
        entrance=entrance_of(room),
        bells=frozenset({"doorbell"} | {d.id for d in site.mqtt.devices if "bell" in d.id}),
        motion=frozenset(
            {"corridor-motion"} | {d.id for d in site.mqtt.devices if "motion" in d.id}
        ),
        containers={thing.id: thing.position for thing in furniture if thing.position is not None},
        people=frozenset({site.tracking.visitor}),
        robots=frozenset(site.drone_bodies),
        devices=device_traits_of(site),
    )
