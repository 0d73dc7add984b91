"""Pilot, driver or room killed or stopped in flight, over real wires, scored on the truth."""

from __future__ import annotations

import asyncio
import os
import signal
import time
from contextlib import AsyncExitStack
from math import hypot
from pathlib import Path
from typing import Any

import pytest
from room_here import RoomHere
from tello_ports import tello_ports

from housefly.app.launcher import Launcher, processes_of
from housefly.app.new_runtime import new_runtime
from housefly.app.readiness import Readiness
from housefly.app.runtime import Runtime
from housefly.bus.topics import DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.messages import Order, OrderKind
from housefly.sites.loaded_site import open_site, read_site
from housefly.twin.contracts import FlightState

TOPICS = DroneTopics()

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow, pytest.mark.timeout(240)]

OTHERS = [
    pytest.param(kind, marks=pytest.mark.interop)
    for kind in ("tello", "arducopter", "px4", "crazyflie", "crazyflie_brushless", "betaflight")
]
LANDED = (FlightState.LANDED,)
DOWN = {
    # they cut their motors two seconds after their driver died, unless that is back before
    "crazyflie": (FlightState.LANDED, FlightState.EMERGENCY),
    "crazyflie_brushless": (FlightState.LANDED, FlightState.EMERGENCY),
}
"""How a drone ends whose driver was killed; any other has landed."""
STOPPING_DISTANCE_MAX = 0.6
"""From 0.5 m/s [m]."""


class Run:
    """Pilot and driver as processes of their own in a room that is here."""

    def __init__(self, launcher: Launcher, bus: ZenohBus, room: RoomHere) -> None:
        self.launcher, self.bus, self.room = launcher, bus, room
        self.told: list[str] = []
        bus.subscribe(
            TOPICS.step,
            lambda step: self.told.extend(event.text for event in step.outputs.events),
        )

    def order(self, kind: OrderKind, place: str = "") -> None:
        self.bus.publish(
            TOPICS.order, Order(kind, place, issued_at=time.monotonic(), sender="test")
        )

    async def cruise(self, place: str, seconds: float = 0.0) -> None:
        """Send the drone somewhere, and wait until it is so long on its way [s]."""
        self.order(OrderKind.GO, place)
        try:
            await self.room.until(lambda: self.room.now.speed > 0.45, 30.0)
        except AssertionError as error:
            raise AssertionError(f"{error}; the pilot told: {self.told[-8:]}") from error
        await asyncio.sleep(seconds)

    def kill(self, name: str, number: signal.Signals) -> None:
        os.kill(self.launcher.pid(name), number)

    async def stop_the_next(self, name: str) -> None:
        """Wait for the process that takes the place of one that died, and stop it."""
        await self.room.until(lambda: self.launcher.restarts(name) >= 1, 10.0)
        self.kill(name, signal.SIGSTOP)

    async def at_rest(self) -> float:
        """Wait for rest, before any landing; return the way until then [m]."""
        start = self.room.now
        await self.room.until(lambda: self.room.now.speed < 0.08, 1.8)
        await asyncio.sleep(0.3)
        return self.room.way_since(start)

    @property
    def has_landed(self) -> bool:
        return self.room.world.onboard().flight is FlightState.LANDED

    async def landed(self) -> None:
        await self.room.until(lambda: self.has_landed)

    def hovers_at(self, place: str) -> bool:
        """Return whether it rests where it was sent."""
        now, (x, y) = self.room.now, self.room.loaded.room.place(place).viewpoint
        return hypot(now.x - x, now.y - y) < 0.1 and now.speed < 0.05


async def started(tmp_path: Path, site_file: Path, stack: AsyncExitStack) -> Run:
    loaded = open_site(read_site(str(site_file), hub__enabled=False))
    room = await stack.enter_async_context(RoomHere(loaded))
    runtime: Runtime = new_runtime(loaded.site, tmp_path)
    names = ("room", "pilot", "driver")
    processes = tuple(spec for spec in processes_of(runtime) if spec.name in names)
    launcher = Launcher(runtime, tmp_path, processes)
    await asyncio.to_thread(launcher.__enter__)
    stack.push_async_callback(asyncio.to_thread, launcher.stop)
    bus = stack.enter_context(ZenohBus(connect=runtime.bus))
    ready = Readiness(loaded.site, bus, web=False, video=False)
    assert await asyncio.to_thread(ready.wait, 60.0) == ""
    await asyncio.sleep(1.0)
    return Run(launcher, bus, room)


@pytest.mark.parametrize("kind", ["ardrone", *OTHERS])
async def test_a_pilot_killed_in_cruise_leaves_a_drone_that_brakes_lands_and_stays(
    tmp_path: Path, write_site: Any, kind: str
) -> None:
    async with AsyncExitStack() as stack:
        stack.enter_context(tello_ports())
        run = await started(tmp_path, write_site(kind=kind), stack)
        await run.cruise("entrance", 1.0)
        run.kill("pilot", signal.SIGKILL)
        # A new pilot that is quick may hold the drone: this one comes too late.
        stopped = asyncio.create_task(run.stop_the_next("pilot"))
        assert await run.at_rest() < STOPPING_DISTANCE_MAX
        rest = run.room.now
        await stopped
        await run.landed()
        run.kill("pilot", signal.SIGCONT)
        await asyncio.sleep(6.0)
        assert run.room.world.onboard().flight is FlightState.LANDED
        assert run.room.way_since(rest) < 0.4


@pytest.mark.interop
@pytest.mark.parametrize("pause", [1.0, 3.1])
async def test_a_pilot_stopped_in_cruise_and_back_after_the_landing_does_not_fly_on(
    tmp_path: Path, write_site: Any, pause: float
) -> None:
    async with AsyncExitStack() as stack:
        run = await started(tmp_path, write_site(), stack)
        late: list[float] = []
        run.bus.subscribe(TOPICS.step, lambda step: late.append(step.inputs.late))
        await run.cruise("entrance", pause)
        run.kill("pilot", signal.SIGSTOP)
        try:
            assert await run.at_rest() < STOPPING_DISTANCE_MAX
            rest = run.room.now
            await asyncio.sleep(2.0)
        finally:
            run.kill("pilot", signal.SIGCONT)
        await run.landed()
        await asyncio.sleep(2.0)
        assert max(late) > 2.0, "the step was not told how late it is"
        assert run.room.world.onboard().flight is FlightState.LANDED
        assert run.room.way_since(rest) < 0.4


async def test_a_room_that_stands_still_in_cruise_means_hover_then_landing(
    tmp_path: Path, write_site: Any
) -> None:
    async with AsyncExitStack() as stack:
        run = await started(tmp_path, write_site(), stack)
        await run.cruise("entrance", 1.0)
        run.kill("room", signal.SIGSTOP)
        try:
            assert await run.at_rest() < STOPPING_DISTANCE_MAX
            rest = run.room.now
            await run.landed()
        finally:
            run.kill("room", signal.SIGCONT)
        assert run.room.way_since(rest) < 0.4
        assert run.launcher.restarts("pilot") == 0


@pytest.mark.interop
async def test_a_room_killed_in_cruise_is_back_soon_and_the_drone_is_safe_meanwhile(
    tmp_path: Path, write_site: Any
) -> None:
    async with AsyncExitStack() as stack:
        run = await started(tmp_path, write_site(), stack)
        await run.cruise("entrance", 1.0)
        run.kill("room", signal.SIGKILL)
        assert await run.at_rest() < STOPPING_DISTANCE_MAX
        await run.room.until(lambda: run.launcher.restarts("room") == 1, 10.0)
        # It lands where tracking stayed away for too long, and flies on where it was soon back.
        await run.room.until(lambda: run.has_landed or run.hovers_at("entrance"), 30.0)
        assert run.launcher.restarts("pilot") == 0


@pytest.mark.interop
@pytest.mark.parametrize(
    "kind",
    ["ardrone", "tello", "arducopter", "px4", "crazyflie", "crazyflie_brushless", "betaflight"],
)
async def test_a_driver_killed_in_cruise_comes_back_and_lets_the_drone_only_hover_and_land(
    tmp_path: Path, write_site: Any, kind: str
) -> None:
    async with AsyncExitStack() as stack:
        stack.enter_context(tello_ports())
        run = await started(tmp_path, write_site(kind=kind), stack)
        await run.cruise("entrance", 1.0)
        run.kill("driver", signal.SIGKILL)
        await asyncio.sleep(3.0)
        rest = run.room.now
        await run.room.until(lambda: run.room.world.onboard().flight in DOWN.get(kind, LANDED))
        await asyncio.sleep(2.0)
        assert run.room.way_since(rest) < 0.4 and run.room.now.height < 0.1
        assert run.room.world.onboard().flight in DOWN.get(kind, LANDED)
        assert run.room.world.contact_log == ()


@pytest.mark.interop
async def test_a_driver_told_to_end_in_flight_lands_first(tmp_path: Path, write_site: Any) -> None:
    async with AsyncExitStack() as stack:
        run = await started(tmp_path, write_site(), stack)
        await run.cruise("entrance", 1.0)
        before = run.launcher.pid("driver")
        for _ in range(5):
            for number in (signal.SIGHUP, signal.SIGINT, signal.SIGTERM):
                run.kill("driver", number)
            await asyncio.sleep(0.05)
        assert await run.at_rest() < STOPPING_DISTANCE_MAX
        os.kill(before, 0)  # still there
        await run.landed()
