"""With a disk nearly full nothing takes off, and it is said why; a flight goes on."""

from __future__ import annotations

import asyncio
from collections import namedtuple
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from room_here import RoomHere

from housefly.app.disk_space import FREE_ENOUGH_GB, FREE_SHARE_MIN, DiskSpace, disks_of
from housefly.app.loaded_site import open_site, read_site
from housefly.app.pilot_shell import PilotShell
from housefly.app.trackers import tracker_of
from housefly.bus.local import LocalBus
from housefly.bus.topics import ORDER_TOPIC, STEP_TOPIC
from housefly.clock import RealClock
from housefly.config.site import Site
from housefly.drones.ardrone.driver import ArDrone
from housefly.messages import Order, OrderKind, PilotStep
from housefly.pilot.assembly import warm_up

Usage = namedtuple("Usage", "total free")
RISING = (OrderKind.TAKE_OFF, OrderKind.GO, OrderKind.SERVICE)
HERE = Path("/")


def looked(*usages: Usage) -> DiskSpace:
    """Return what is known of disks that are so full."""
    found = iter(usages)
    disks = DiskSpace([HERE] * len(usages), lambda _: next(found))
    disks.look()
    return disks


@given(st.integers(0, 10**13), st.floats(0.0, 1.0))
def test_what_would_take_off_is_refused_exactly_where_the_list_says_so(
    total: int, share: float
) -> None:
    disks = looked(Usage(total, int(share * total)))
    orders = tuple(Order(kind) for kind in OrderKind)
    passed, events = disks.allowed(orders, 5.0)
    is_short = int(share * total) < min(FREE_SHARE_MIN * total, FREE_ENOUGH_GB * 1e9) or total == 0
    assert disks.check().passed is not is_short
    assert {order.kind for order in orders if order not in passed} == set(is_short * RISING)
    assert all(event.code == "order_refused" and "free at /" in event.text for event in events)


def test_one_full_disk_of_several_is_enough_and_one_that_does_not_answer_none() -> None:
    assert "5.0% free" in looked(Usage(100, 50), Usage(100, 5)).shortage

    def gone(folder: Path) -> Usage:
        raise OSError("no such disk")

    disks = DiskSpace([HERE], gone)
    disks.look()
    assert disks.shortage == "" and disks.check().value == "unknown"


def test_the_disks_of_a_run_are_there() -> None:
    disks = disks_of(Site())
    disks.look()
    assert "free at" in disks.check().value


@pytest.mark.wire
@pytest.mark.realtime
async def test_with_a_full_disk_nothing_takes_off_and_a_flight_goes_on(write_site: Any) -> None:
    loaded = open_site(read_site(str(write_site()), hub__enabled=False))
    steps: list[PilotStep] = []
    left = [1]
    async with RoomHere(loaded) as room:
        clock, bus = RealClock(), LocalBus()
        warm_up(loaded.site, loaded.room, loaded.grid)
        drone = ArDrone(loaded.site.drone, loaded.site.limits, clock)
        shell = PilotShell(loaded, bus, tracker_of(loaded.site.tracking, clock), drone)
        shell._disks = DiskSpace([HERE], lambda _: Usage(100, left[0]))
        bus.subscribe(STEP_TOPIC, steps.append)
        running = asyncio.create_task(shell.run())
        await room.until(
            lambda: running.done() or (drone.telemetry is not None and drone.telemetry.configured)
        )
        assert not running.done(), running.result()
        await room.until(lambda: shell._disks.shortage)
        bus.publish(ORDER_TOPIC, Order(OrderKind.TAKE_OFF, issued_at=clock.now()))
        told = [event.text for step in steps for event in step.outputs.events]
        await room.until(lambda: any("full" in e.text for s in steps for e in s.outputs.events))
        await asyncio.sleep(1.0)
        assert room.world.onboard().flight.name == "LANDED", told
        left[0] = 50
        await room.until(lambda: not shell._disks.shortage)
        bus.publish(ORDER_TOPIC, Order(OrderKind.TAKE_OFF, issued_at=clock.now()))
        await room.until(lambda: room.world.onboard().flight.name == "HOVERING", 20.0)
        left[0] = 1
        await room.until(lambda: shell._disks.shortage)
        await asyncio.sleep(1.0)
        assert room.world.onboard().flight.name in ("HOVERING", "FLYING")
        shell.leave()
        await asyncio.wait_for(running, 40.0)
