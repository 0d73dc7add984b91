"""Whether anything grows: half an hour of the room's memory, and of the stepped world with its
pilot, as fast as they go.
"""

from __future__ import annotations

import gc
import json
import math
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import psutil

from _run import table
from housefly.config.site import Site, changed
from housefly.hub.change_feed import CHANGE_FEED_PERIOD, ChangeFeed
from housefly.hub.memory import RoomMemory
from housefly.hub.room_status import RoomStatus
from housefly.hub.situation_service import SituationService
from housefly.hub.store.open import open_store
from housefly.hub.things_of_room import things_of
from housefly.lab.lockstep.lockstep_room import LockstepRoom
from housefly.lab.lockstep.pilot_loop import PilotLoop
from housefly.messages import Observation, Order, OrderKind, RoomEvent
from housefly.pilot.assembly import make_pilot
from housefly.room.files import load_room
from housefly.sites.loaded_site import open_site, read_site
from housefly.twin.people import load_scene
from housefly.twin.sensors.devices import SimulatedDevices
from housefly.twin.world import SimulatedWorld
from housefly.wires.devices import Delivered, Placement, decode_reading

MINUTES = 30
SETTLED = 5
"""Minutes after which nothing may grow any more."""
GROWTH_LIMIT = 0.05
THINGS, RATE = 20, 100
NAMES = ("ardrone", "visitor", *(f"thing-{number}" for number in range(THINGS - 2)))
BATTERY_EVERY = 300.0
"""The battery lasts twelve minutes; it is changed in the air this often [s]."""


def rss() -> float:
    """Return the memory of this process [MiB]."""
    gc.collect()
    return float(psutil.Process().memory_info().rss) / 2**20


def frame(at: float) -> list[Observation]:
    """Return what a motion capture system sees at a time [s, Unix time]."""
    found = []
    for number, name in enumerate(NAMES):
        angle = 0.5 * (at % 1e5) + number
        turned = (math.cos(angle / 2), 0.0, 0.0, math.sin(angle / 2))
        found.append(
            Observation(
                name,
                "vicon",
                at,
                at,
                (7 + 3 * math.cos(angle), 3 + 2 * math.sin(angle), 1.0),
                turned,
            )
        )
    return found


class Room:
    """The parts of the hub without its wires, on a simulated clock."""

    def __init__(self, site: Site, file: Path) -> None:
        room = load_room(site.room.model)
        self._site = site
        self._begin = self.now = time.time() - 60.0 * MINUTES
        self._devices = SimulatedDevices(load_scene("bsen"), site.mqtt.site)
        self._placement = Placement(things={row.tag: row.thing for row in site.mqtt.tags})
        self.memory = RoomMemory(things_of(site, room), lambda: open_store(file))
        self.status = RoomStatus(self.memory.writer.report)
        self._situations = SituationService(site, room, self.memory, self.status)
        self._change_feed = ChangeFeed(self.memory, self.status, lambda: self.now)
        self.taken = self.told = 0

    def tick(self, number: int) -> None:
        """Let a hundredth of a second pass."""
        self.now = self._begin + number / RATE
        for sample in frame(self.now):
            self._take(sample)
        if number % 5 == 0:
            for item in self._said(number / RATE):
                self._take(item)
        if number % round(CHANGE_FEED_PERIOD * RATE) == 0:
            self._situations.update(self.now)
            self.told += self._change_feed.changes() is not None
        if number % (5 * RATE) == 0:
            assert self.memory.flush()

    def _take(self, item: Observation | RoomEvent) -> None:
        self.memory.add(item)
        self.taken += 1

    def _said(self, since: float) -> Iterator[Observation | RoomEvent]:
        for message in self._devices.messages(since, self.now):
            reading = decode_reading(
                Delivered(message.address, message.channel, message.payload, self.now),
                self._placement,
            )
            yield from reading.observations
            yield from reading.events


def hub() -> list[float]:
    """Let the hub's parts live and return their memory after each minute [MiB]."""
    with tempfile.TemporaryDirectory() as folder:
        room = Room(read_site("bsen"), Path(folder) / "room.db")
        used = sampled(room.tick)
        kept = room.memory.writer.report() or "all is kept"
        print(f"{room.taken:,} taken, {room.told:,} news, store: {kept}", file=sys.stderr)
        assert not room.memory.writer.dropped()
        room.memory.close()
    return used


class Flight:
    """A world and a pilot in lock step, hovering."""

    def __init__(self) -> None:
        loaded = open_site(changed(read_site("bsen"), twin__visitor_present=True))
        self._world = SimulatedWorld(loaded.site, loaded.room, load_scene("bsen"))
        self._loop = PilotLoop(
            LockstepRoom(self._world, loaded.site),
            make_pilot(loaded.site, loaded.room, loaded.grid),
            RATE,
        )
        self.airborne = 0

    def tick(self, number: int) -> None:
        """Let a hundredth of a second pass."""
        self._loop.advance()
        if number % round(BATTERY_EVERY * RATE) == 0:
            self._world.first.battery.charge = 1.0
        orders = (Order(OrderKind.TAKE_OFF, sender="benchmark"),) if number == RATE else ()
        self._loop.step(self._loop.inputs(*orders))
        self.airborne += self._world.truth().pose.position[2] > 0.5


def flight() -> list[float]:
    """Hover and return the memory after each minute [MiB]."""
    flown = Flight()
    used = sampled(flown.tick)
    assert flown.airborne > 0.95 * MINUTES * 60 * RATE, "it did not hover"
    return used


def sampled(tick: Callable[[int], None]) -> list[float]:
    """Let time pass and return the memory at the begin and after each minute [MiB]."""
    used = [rss()]
    for number in range(1, MINUTES * 60 * RATE + 1):
        tick(number)
        if number % (60 * RATE) == 0:
            used.append(rss())
    return used


def measured(part: str) -> tuple[list[float], float]:
    """Run a part in a process of its own; return its memory by minute [MiB] and how long that took
    [s].
    """
    begin = time.monotonic()
    output = subprocess.run(
        [sys.executable, __file__, part], stdout=subprocess.PIPE, check=True, timeout=600
    ).stdout
    return json.loads(output), time.monotonic() - begin


def row(words: str, part: str) -> list[object]:
    """Return the row of a part."""
    used, took = measured(part)
    settled = used[SETTLED:]
    middle = (len(settled) - 1) / 2
    spread = sum((minute - middle) ** 2 for minute in range(len(settled)))
    slope = sum((minute - middle) * value for minute, value in enumerate(settled)) / spread
    growth = 100 * (settled[-1] / settled[0] - 1)
    shown = [f"{value:.1f}" for value in (used[0], settled[0], used[-1])]
    return [
        words,
        *shown,
        f"{1024 * slope:+.1f}",
        f"{growth:+.2f} %",
        f"{100 * GROWTH_LIMIT:.0f} %",
        f"{took:.0f}",
    ]


def main() -> None:
    """Print how much memory each part takes."""
    rows = [
        row("hub: memory, situations, news, store", "hub"),
        row("stepped world with people, and its pilot, hovering", "flight"),
    ]
    headings = [
        "RSS [MiB]",
        "first",
        f"minute {SETTLED}",
        f"minute {MINUTES}",
        "slope [KiB/min]",
        "growth",
        "limit",
        "took [s]",
    ]
    print(f"### Memory over {MINUTES} simulated minutes\n")
    print(table(headings, rows))
    print(
        f"\n{THINGS} things at {RATE} Hz and the devices of the twin's scene, stamped with"
        f" simulated time and fed as fast as they are taken; slope and growth from minute {SETTLED}"
        " on. Each part in a process of its own, sampled each minute."
    )


if __name__ == "__main__":
    match sys.argv[1:]:
        case ["hub"]:
            print(json.dumps(hub()))
        case ["flight"]:
            print(json.dumps(flight()))
        case _:
            main()
