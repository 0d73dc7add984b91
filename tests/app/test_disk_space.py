"""With a disk nearly full, or one that takes nothing, no take-off, and why; a flight goes on."""

from __future__ import annotations

import asyncio
import os
import sys
from collections import namedtuple
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from room_here import RoomHere

from housefly.app.disk_space import FREE_ENOUGH_GB, FREE_SHARE_MIN, DiskSpace, disks_of
from housefly.app.pilot_shell import PilotShell
from housefly.bus.local import LocalBus
from housefly.bus.topics import DroneTopics
from housefly.clock import RealClock
from housefly.config.environment import RECORDING_VARIABLE
from housefly.config.site import Site, changed
from housefly.drones.ardrone.driver import ArDrone
from housefly.messages import Order, OrderKind, PilotStep
from housefly.pilot.assembly import warm_up
from housefly.sites.loaded_site import open_site, read_site
from housefly.tracking.trackers import tracker_of

TOPICS = DroneTopics()

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
    passed, refused = disks.allowed(orders)
    is_short = int(share * total) < min(FREE_SHARE_MIN * total, FREE_ENOUGH_GB * 1e9) or total == 0
    assert [check.passed for check in disks.checks()] == [not is_short]
    assert {order.kind for order in orders if order not in passed} == set(is_short * RISING)
    told = [one.event(5.0) for one in refused]
    assert all(event.code == "order_refused" and "free at /" in event.text for event in told)


def test_one_full_disk_of_several_is_enough_and_one_that_does_not_answer_none() -> None:
    assert "5.0% free" in looked(Usage(100, 50), Usage(100, 5)).shortage

    def gone(folder: Path) -> Usage:
        raise OSError("no such disk")

    disks = DiskSpace([HERE], gone)
    disks.look()
    assert disks.shortage == "" and disks.checks()[0].value == "unknown"


def test_the_disks_of_a_run_are_there() -> None:
    disks = disks_of(Site())
    disks.look()
    space, writing = disks.checks()
    assert "free at" in space.value and writing.value == "written a moment ago"


def test_where_nothing_can_be_written_what_would_take_off_is_refused_and_it_is_said_why(
    tmp_path: Path,
) -> None:
    folder = tmp_path / "state" / "tasks"
    disks = DiskSpace((), kept=[folder])
    disks.look()
    assert disks.checks()[1].passed and list(tmp_path.iterdir()) == [], "its parent counts"
    folder.parent.write_text("in the way")
    disks.look()
    line = disks.checks()[1]
    assert not line.passed and line.required
    assert line.value == f"nothing can be written at {folder.parent} (Not a directory)"
    orders = tuple(Order(kind) for kind in OrderKind)
    passed, refused = disks.allowed(orders)
    assert {order.kind for order in orders if order not in passed} == set(RISING)
    assert {one.why for one in refused} == {
        f"a disk cannot be written to: {line.value}; {line.mend}"
    }


@pytest.mark.skipif(sys.platform != "linux", reason="another system has no /proc")
def test_a_disk_that_may_only_be_read_and_one_without_permission_count(tmp_path: Path) -> None:
    tmp_path.chmod(0o500)
    for folder in (Path("/proc/sys"), *([tmp_path] if os.geteuid() else [])):
        disks = DiskSpace((), kept=[folder])
        disks.look()
        assert str(folder) in disks.refusal


def test_a_disk_that_does_not_even_say_what_is_on_it_cannot_be_written(tmp_path: Path) -> None:
    nameless = tmp_path / (300 * "x")
    disks = DiskSpace((), kept=[nameless])
    disks.look()
    assert disks.refusal == f"nothing can be written at {nameless} (File name too long)"


def test_what_a_run_records_or_remembers_counts_and_nothing_else(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    site = changed(Site(), hub__store=str(tmp_path / "file" / "room.db"))
    (tmp_path / "file").write_text("in the way")
    disks = disks_of(site)
    disks.look()
    assert "file" in disks.refusal
    disks = disks_of(changed(site, hub__enabled=False, tasks__enabled=False))
    disks.look()
    assert disks.refusal == "" and len(disks.checks()) == 1
    monkeypatch.setenv(RECORDING_VARIABLE, str(tmp_path / "file"))
    disks = disks_of(changed(site, hub__enabled=False, tasks__enabled=False))
    disks.look()
    assert "file" in disks.refusal


@pytest.mark.wire
@pytest.mark.realtime
async def test_with_a_full_disk_nothing_takes_off_and_a_flight_goes_on(write_site: Any) -> None:
    left = [1]
    disks = DiskSpace([HERE], lambda _: Usage(100, left[0]))
    await refuses_and_flies_on(write_site, disks, "full", lambda room: left.__setitem__(0, room))


@pytest.mark.wire
@pytest.mark.realtime
async def test_where_nothing_can_be_written_nothing_takes_off_and_a_flight_goes_on(
    write_site: Any, tmp_path: Path
) -> None:
    place = tmp_path / "memory"
    place.write_text("in the way")

    def make(room: int) -> None:
        if room > 1:
            place.unlink()
            place.mkdir()
        else:
            place.rmdir()
            place.write_text("in the way")

    await refuses_and_flies_on(write_site, DiskSpace((), kept=[place]), "cannot be written", make)


async def refuses_and_flies_on(
    write_site: Any, disks: DiskSpace, words: str, leave: Callable[[int], None]
) -> None:
    """Ask for a take-off beside a disk that refuses, then fly, and let it refuse again.

    Args:
        write_site: as the fixture.
        disks: of the run; they refuse.
        words: said with a refusal.
        leave: leaves so much room on the disk [%].
    """
    loaded = open_site(read_site(str(write_site()), hub__enabled=False))
    steps: list[PilotStep] = []
    async with RoomHere(loaded) as room:
        clock, bus = RealClock(), LocalBus()
        warm_up(loaded.site, loaded.room, loaded.grid)
        drone = ArDrone(loaded.site.drone, loaded.site.limits, clock)
        shell = PilotShell(loaded, bus, tracker_of(loaded.site.tracking, clock), drone)
        shell._disks = disks
        bus.subscribe(TOPICS.step, steps.append)
        running = asyncio.create_task(shell.run())
        await room.until(
            lambda: running.done() or (drone.telemetry is not None and drone.telemetry.configured)
        )
        assert not running.done(), running.result()
        await room.until(lambda: disks.shortage or disks.refusal)
        bus.publish(TOPICS.order, Order(OrderKind.TAKE_OFF, issued_at=clock.now()))
        await room.until(lambda: any(words in e.text for s in steps for e in s.outputs.events))
        await asyncio.sleep(1.0)
        told = [event.text for step in steps for event in step.outputs.events]
        assert room.world.onboard().flight.name == "LANDED", told
        leave(50)
        await room.until(lambda: not (disks.shortage or disks.refusal))
        bus.publish(TOPICS.order, Order(OrderKind.TAKE_OFF, issued_at=clock.now()))
        await room.until(lambda: room.world.onboard().flight.name == "HOVERING", 20.0)
        leave(1)
        await room.until(lambda: disks.shortage or disks.refusal)
        await asyncio.sleep(1.0)
        assert room.world.onboard().flight.name in ("HOVERING", "FLYING")
        shell.leave()
        await asyncio.wait_for(running, 40.0)
