"""Streams for the detectors: made by hand, or played by the simulated room in lock step."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import pytest

from housefly.hub.situations import Layout, Situation, Situations
from housefly.hub.situations.furniture import beds_of, entrance_of, seats_of
from housefly.messages import Observation, RoomEvent
from housefly.room.bsen import bsen
from housefly.twin.people import Scene
from housefly.twin.sensors.devices import SimulatedDevices
from housefly.wires.devices import Delivered, Placement, decode_reading

UNIX = 1_800_000_000.0
Item = Observation | RoomEvent
Heard = list[tuple[float, Item]]
Told = list[RoomEvent]


@pytest.fixture(scope="session")
def layout() -> Layout:
    """Return what is known of B-sen beforehand."""
    return Layout(
        seats=seats_of(bsen()),
        beds={"bed": beds_of(bsen())[0]},
        entrance=entrance_of(bsen()),
        bells=frozenset({"doorbell"}),
        motion=frozenset({"corridor-motion"}),
        containers={"cabinet": (11.50, 4.20, 0.60), "refrigerator": (7.18, 5.82, 0.60)},
        open_limits={"refrigerator": 30.0},
        people=frozenset({"visitor"}),
    )


@pytest.fixture(scope="session")
def play() -> Callable[[Scene, float], Heard]:
    """Return a function that plays a scene in lock step and returns what is heard of its devices,
    with the time [s].
    """

    def played(scene: Scene, seconds: float) -> Heard:
        devices = SimulatedDevices(scene, "bsen")
        things = Placement(things={thing.tag: thing.name for thing in scene.script.things})
        heard: Heard = []
        for now in (step * 0.05 for step in range(round(seconds / 0.05) + 1)):
            for message in devices.messages(now, UNIX + now):
                delivered = Delivered(message.address, message.channel, message.payload, UNIX + now)
                reading = decode_reading(delivered, things)
                heard += [(now, event) for event in reading.events]
                heard += [(now, seen) for seen in reading.observations]
        return heard

    return played


class Watcher:
    """Hears a stream and keeps what is said at each tenth of a second.

    Attributes:
        told: all events so far.
        holds: what held, by tenths of a second.
    """

    def __init__(self, layout: Layout) -> None:
        self.situations = Situations(layout)
        self.told: Told = []
        self.holds: dict[int, tuple[Situation, ...]] = {}

    def hear(self, stream: Iterable[tuple[float, Item]], until: float, since: float = 0.0) -> Told:
        """Hear a stream of items with the times [s] at which they come, until a time [s]; return
        what is told.
        """
        rows = sorted(stream, key=lambda row: row[0])
        index, before = 0, len(self.told)
        for tenth in range(round(since * 10), round(until * 10) + 1):
            due = index
            while due < len(rows) and rows[due][0] <= tenth / 10 + 1e-9:
                due += 1
            self.told += self.situations.update(
                [item for _, item in rows[index:due]], UNIX + tenth / 10
            )
            self.holds[tenth] = self.situations.active()
            index = due
        return self.told[before:]

    def named(self, kind: str) -> Told:
        """Return the events of a kind."""
        return [event for event in self.told if event.kind == kind]

    def held(self, kind: str) -> list[float]:
        """Return the times [s] at which a situation of a kind held."""
        return [
            tenth / 10
            for tenth, claims in sorted(self.holds.items())
            if any(claim.kind == kind for claim in claims)
        ]


@pytest.fixture
def watcher(layout: Layout) -> Watcher:
    """Return somebody who hears streams in B-sen."""
    return Watcher(layout)


@pytest.fixture(scope="session")
def watching(layout: Layout) -> Callable[[], Watcher]:
    """Return what makes further such ones."""
    return lambda: Watcher(layout)
