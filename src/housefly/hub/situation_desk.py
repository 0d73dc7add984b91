"""Runs the detectors over what the memory takes: what they find is taken too, and what holds is
shown.
"""

from __future__ import annotations

import threading
from collections.abc import Iterable

from housefly.config.site import Site
from housefly.hub.api.answers import Holding
from housefly.hub.memory import RoomMemory
from housefly.hub.present import Present
from housefly.hub.situations import Layout, Situations
from housefly.hub.situations.furniture import beds_of, entrance_of, seats_of
from housefly.hub.things.thing import Kind, Thing
from housefly.messages import Happening, Observation
from housefly.room.model import Room

MOST = 20_000
"""Items that may wait for the detectors; more are left out of them, not of the memory."""


class SituationDesk:
    """Feeds one site's detectors; items may come from any thread, ``step`` is called by one."""

    def __init__(self, site: Site, room: Room, memory: RoomMemory, present: Present) -> None:
        self._memory, self._present = memory, present
        self._situations = Situations(layout_of(site, room, memory.world.of_kind(Kind.FURNITURE)))
        self._lock = threading.Lock()
        self._waiting: list[Observation | Happening] = []
        memory.listen(self._noted)

    def step(self, now: float) -> None:
        """Let the detectors look [Unix time, s]."""
        with self._lock:
            items, self._waiting = self._waiting, []
        for happening in self._situations.after(items, now):
            self._memory.take(happening)
            if happening.kind == "object taken" and happening.cause:
                # It is with whoever took it, until a sensor says where it was put.
                at = happening.at
                self._memory.take(
                    Observation(happening.thing, happening.source, at, now, inside=happening.cause)
                )
        holds = (
            Holding(s.kind, s.thing, s.since, s.confidence, "; ".join(s.evidence))
            for s in self._situations.holds()
        )
        self._present.hold(holds, "detectors")

    def _noted(self, item: Observation | Happening) -> None:
        with self._lock:
            if len(self._waiting) < MOST:
                self._waiting.append(item)


def layout_of(site: Site, room: Room, furniture: Iterable[Thing]) -> Layout:
    """Return what the detectors know of a site beforehand; beds, bells and motion sensors are told
    by their ids.
    """
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
    )
