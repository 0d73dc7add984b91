"""Tracking cut in a hover, pilot and driver killed in flight: each drone over its real wire.

    python benchmarks/endings_over_wires.py                          10 of each, every drone
    python benchmarks/endings_over_wires.py --kinds tello px4 --count 3 --endings cut

Room, pilot and driver are processes of their own; the simulated room is here, so that the truth is.
A flight is whole when the drone is down, stays there, and touched nothing. Times count from the cut
or the kill, in the room's time; *told* is the first order on the wire to land or to sink.
"""

from __future__ import annotations

import argparse
import asyncio
import os
import random
import signal
import sys
import tempfile
import time
from collections.abc import Callable, Coroutine, Iterator
from contextlib import AsyncExitStack, contextmanager, suppress
from dataclasses import dataclass, field
from itertools import pairwise
from math import inf, isfinite, nan
from pathlib import Path
from typing import Any

from _run import TOPICS, bench_site, percentile, table
from housefly.app.launcher import Launcher, processes_of
from housefly.app.new_runtime import new_runtime
from housefly.app.readiness import Readiness
from housefly.bus.zenoh_bus import ZenohBus
from housefly.errors import LinkError, WireError
from housefly.messages import Order, OrderKind
from housefly.sites.loaded_site import open_site
from housefly.twin.contracts import FlightState
from housefly.twin.link_filters import Deliver, LinkFilters
from housefly.wires.crazyflie.crtp import Port, decode_crtp
from housefly.wires.crazyflie.high_level import Land, decode_high_level
from housefly.wires.crazyflie.setpoints import AltHold, decode_setpoint, is_notify_stop
from housefly.wires.mavlink.autopilots import AUTOPILOTS
from housefly.wires.mavlink.framing import messages_in
from housefly.wires.mavlink.requests import CommandId

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "support"))
from room_here import Moment, RoomHere
from tello_ports import tello_ports

KINDS = ("crazyflie", "crazyflie_brushless", "arducopter", "px4", "tello", "betaflight")
READY_TIME, DOWN_TIME, STAYS = 90.0, 60.0, 2.0
"""Longest wait for all processes, and for the air or the floor; how long it stays there [s]."""
HOVERS = 0.5
"""A hover is so far above where it stood, or higher [m]."""
ORDERS = 6
"""How often it is ordered, at most."""
LEVEL_WITHIN, LOW = 0.3, 0.1
"""Its lean counts so long after the cut [s], while it is so far above where it stood [m]."""
SINKS = -0.2
"""A setpoint that sinks faster is an order to sink [m/s]."""
NOT_FLOWN = "not flown"
_DOWN = (FlightState.LANDED, FlightState.EMERGENCY)


@dataclass
class Uplink:
    """What came over the drone's wire, by the room's time."""

    lands: Callable[[bytes], bool]
    now: Callable[[], float] = lambda: -inf
    heard: list[float] = field(default_factory=list)
    told: list[float] = field(default_factory=list)

    def __call__(self, deliver: Deliver) -> Deliver:
        """Note what a client sends to the drone."""

        def noted(data: bytes) -> None:
            self.heard.append(self.now())
            if self.lands(data):
                self.told.append(self.now())
            deliver(data)

        return noted

    def told_after(self, at: float) -> float:
        """Return how long after a time the drone was told to land or to sink [s]."""
        return next((told - at for told in self.told if told > at), nan)

    def silent_between(self, at: float, end: float) -> float:
        """Return the longest silence between two times, one that lasted then included [s]."""
        times = [max((one for one in self.heard if one <= at), default=at)]
        times += [*(one for one in self.heard if at < one < end), end]
        return max((b - a for a, b in pairwise(times)), default=nan)


def crazyflie_lands(data: bytes) -> bool:
    """Return whether a packet lands a Crazyflie, or lets it sink."""
    try:
        packet = decode_crtp(data)
        if packet.port == Port.HIGH_LEVEL:
            return isinstance(decode_high_level(packet), Land)
        if packet.port != Port.GENERIC_SETPOINT or is_notify_stop(packet):
            return False
        asked = decode_setpoint(packet)
    except WireError:
        return False
    return isinstance(asked, AltHold) and asked.vz < SINKS


def tello_lands(data: bytes) -> bool:
    """Return whether a line lands a Tello."""
    return data.strip() == b"land"


def autopilot_lands(kind: str) -> Callable[[bytes], bool]:
    """Return what knows an autopilot's landing mode by its bytes."""
    landing = AUTOPILOTS[kind].landing

    def lands(data: bytes) -> bool:
        with suppress(WireError):
            return any(
                message.get_type() == "COMMAND_LONG"
                and message.command == CommandId.SET_MODE
                and (message.param2, message.param3) == (landing.main, landing.sub)
                for message in messages_in(data)
            )
        return False

    return lands


LANDS: dict[str, Callable[[], Callable[[bytes], bool]]] = {
    "crazyflie": lambda: crazyflie_lands,
    "crazyflie_brushless": lambda: crazyflie_lands,
    "arducopter": lambda: autopilot_lands("arducopter"),
    "px4": lambda: autopilot_lands("px4"),
    "tello": lambda: tello_lands,
    "betaflight": lambda: lambda data: False,  # it has sticks, and no order to land
}


@dataclass(frozen=True, slots=True)
class Ended:
    """What became of one flight.

    Attributes:
        told: until the wire carried an order to land or to sink [s]; nan where none was needed.
        silent: longest silence on the wire since, until it was down [s].
        lean: largest, from ``LEVEL_WITHIN`` on and above ``LOW`` [rad].
        way: furthest from where it was [m].
        down: until it was down, by its own computer [s].
        state: in which it ended.
        contacts: that it had.
        why: it was not whole; "" where it was.
    """

    told: float = nan
    silent: float = nan
    lean: float = nan
    way: float = nan
    down: float = nan
    state: str = ""
    contacts: int = 0
    why: str = ""


@dataclass
class Run:
    """One flight: a room that is here, and the processes that fly in it."""

    room: RoomHere
    uplink: Uplink
    launcher: Launcher
    bus: ZenohBus

    def order(self, kind: OrderKind, place: str = "") -> None:
        """Give an order."""
        order = Order(kind, place, issued_at=time.monotonic(), sender="benchmark")
        self.bus.publish(TOPICS.order, order)

    async def until(self, holds: Callable[[], bool], kind: OrderKind, place: str = "") -> None:
        """Order something until it holds: an order on the floor is refused while nothing is ready.

        Raises:
            AssertionError: that took too long.
        """
        for left in reversed(range(ORDERS)):
            if self.room.now.height < self.room.moments[0].height + LOW:
                self.order(kind, place)
            with suppress(*() if left == 0 else (AssertionError,)):
                await self.room.until(holds, DOWN_TIME / ORDERS)
                return

    def kill(self, name: str) -> None:
        """Kill one of our processes as nothing can be asked of it any more."""
        os.kill(self.launcher.pid(name), signal.SIGKILL)

    async def ended(self, since: Moment) -> Ended:
        """Wait until it is down and stays there; return what became of it."""
        room, world, why = self.room, self.room.world, ""
        down = inf
        try:
            await room.until(lambda: world.onboard().flight in _DOWN, DOWN_TIME)
            down = room.now.at - since.at
            await asyncio.sleep(STAYS)
            is_high = room.now.height > room.moments[0].height + LOW
            if world.onboard().flight not in _DOWN or is_high:
                why = f"did not stay down: {world.onboard().flight.value}"
        except AssertionError as error:
            why = f"not down {error}"
        after = [one for one in room.moments if one.at > since.at]
        low = room.moments[0].height + LOW
        lean = (m.lean for m in after if m.at > since.at + LEVEL_WITHIN and m.height > low)
        contacts = len(world.contact_log)
        return Ended(
            told=self.uplink.told_after(since.at),
            silent=self.uplink.silent_between(since.at, since.at + min(down, DOWN_TIME)),
            lean=max(lean, default=nan),
            way=room.way_since(since),
            down=down,
            state=world.onboard().flight.value,
            contacts=contacts,
            why=why or (f"touched {world.contact_log[0].name}" if contacts else ""),
        )


async def tracking_cut(run: Run, chance: random.Random) -> Ended:
    """Cut tracking in a hover."""
    room = run.room
    await run.until(lambda: room.now.height > 0.8, OrderKind.TAKE_OFF)
    await asyncio.sleep(3.0 + chance.uniform(0.0, 1.0))
    if room.now.height < room.moments[0].height + HOVERS:
        raise AssertionError(f"it came down before: {room.now}")
    since, room.is_tracked = room.now, False
    return await run.ended(since)


async def killed(run: Run, chance: random.Random, name: str) -> Ended:
    """Kill a process in cruise."""
    room = run.room
    await run.until(lambda: room.now.speed > 0.45, OrderKind.GO, "entrance")
    await asyncio.sleep(chance.uniform(0.0, 1.5))
    since = room.now
    run.kill(name)
    return await run.ended(since)


async def pilot_killed(run: Run, chance: random.Random) -> Ended:
    """Kill the pilot in cruise; the launcher starts another, as it would."""
    return await killed(run, chance, "pilot")


async def driver_killed(run: Run, chance: random.Random) -> Ended:
    """Kill the driver in cruise; the launcher starts another, as it would."""
    return await killed(run, chance, "driver")


ENDINGS: dict[str, Callable[[Run, random.Random], Coroutine[Any, Any, Ended]]] = {
    "cut": tracking_cut,
    "pilot": pilot_killed,
    "driver": driver_killed,
}
TITLES = {"cut": "tracking cut in hover", "pilot": "pilot killed", "driver": "driver killed"}


async def flown(kind: str, ending: str, number: int) -> Ended:
    """Fly one flight from its start to its end."""
    loaded = open_site(
        bench_site(
            f"127.57.{KINDS.index(kind)}.{1 + number % 250}",
            drone__kind=kind,
            drone__has_video=False,
            hub__enabled=False,
            tasks__enabled=False,
            twin__video=False,
            twin__seed=number,
        )
    )
    uplink, chance = Uplink(LANDS[kind]()), random.Random(f"{kind} {ending} {number}")
    async with AsyncExitStack() as stack:
        stack.enter_context(tello_ports())
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        room = RoomHere(loaded, filters=LinkFilters(uplink=uplink))
        await stack.enter_async_context(room)
        uplink.now = lambda: room.world.now
        runtime = new_runtime(loaded.site, folder)
        names = ("room", "pilot", "driver")
        processes = tuple(spec for spec in processes_of(runtime) if spec.name in names)
        launcher = Launcher(runtime, folder, processes)
        await asyncio.to_thread(launcher.__enter__)
        stack.push_async_callback(asyncio.to_thread, launcher.stop)
        bus = stack.enter_context(ZenohBus(connect=runtime.bus))
        ready = Readiness(loaded.site, bus, web=False, video=False)
        if missing := await asyncio.to_thread(ready.wait, READY_TIME):
            raise LinkError(missing)
        await asyncio.sleep(1.0)
        try:
            return await ENDINGS[ending](Run(room, uplink, launcher, bus), chance)
        except AssertionError as error:
            return Ended(state=NOT_FLOWN, why=f"{error}")


@contextmanager
def ended_by_hand() -> Iterator[None]:
    """Let Ctrl-C end the flights, not the table, also where a shell has it ignored."""
    signal.signal(signal.SIGINT, signal.default_int_handler)
    with suppress(KeyboardInterrupt):
        yield


def spread(values: list[float], digits: int = 2) -> str:
    """Return median and largest of what is a number."""
    known = [value for value in values if isfinite(value)]
    if not known:
        return "-"
    return f"{percentile(known, 0.5):.{digits}f}, {max(known):.{digits}f}"


def printed(flights: dict[tuple[str, str], list[Ended]]) -> str:
    """Return the table of all flights."""
    rows = [
        (
            kind,
            TITLES[ending],
            f"{sum(not one.why for one in ended)} of {len(ended)}",
            sum(one.state == NOT_FLOWN for one in everyone),
            spread([one.told for one in ended]),
            spread([one.silent for one in ended]),
            spread([one.lean for one in ended], 3),
            spread([one.way for one in ended]),
            spread([one.down for one in ended]),
            sum(one.contacts for one in ended),
        )
        for (kind, ending), everyone in flights.items()
        for ended in [[one for one in everyone if one.state != NOT_FLOWN]]
    ]
    headings = (
        "drone", "what", "whole", "not flown", "told [s]", "wire silent [s]", "lean [rad]",
        "way [m]", "down [s]", "contacts",
    )  # fmt: skip
    return table(headings, rows)


def main() -> None:
    """Fly and print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--kinds", nargs="+", choices=KINDS, default=KINDS, help="which drones")
    parser.add_argument("--endings", nargs="+", choices=ENDINGS, default=tuple(ENDINGS))
    parser.add_argument("--count", type=int, default=10, help="flights of each")
    parser.add_argument("--first", type=int, default=1, help="number of the first")
    options = parser.parse_args()
    flights: dict[tuple[str, str], list[Ended]] = {}
    with ended_by_hand():
        for number in range(options.first, options.first + options.count):
            for kind in options.kinds:
                for ending in options.endings:
                    try:
                        one = asyncio.run(flown(kind, ending, number))
                    except LinkError as error:
                        one = Ended(state=NOT_FLOWN, why=f"not ready: {error}")
                    flights.setdefault((kind, ending), []).append(one)
                    print(number, kind, ending, one, flush=True)
    print("\n### Ends over real wires, median and largest\n")
    print(printed(flights))


if __name__ == "__main__":
    main()
