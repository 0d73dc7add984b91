"""The room's process: what it tells of tracking, also where there is no drone."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable
from pathlib import Path
from typing import NoReturn

import pytest

from housefly.app.commands.shared import require_drone
from housefly.app.doctor import check_machine
from housefly.app.launcher import processes_of
from housefly.app.new_runtime import new_runtime
from housefly.app.ports import port_needs
from housefly.app.readiness import Readiness
from housefly.app.room_main import DronelessPilot, RoomTracking
from housefly.bus.local import LocalBus
from housefly.bus.topics import DroneTopics
from housefly.clock import RealClock, SteppedClock
from housefly.config.site import Site, changed
from housefly.errors import ConfigError, LinkError, ThingError
from housefly.hub.api.pilot_queries import PlanRequest, PreflightView, RoomView
from housefly.hub.api.pilot_queries_json import from_json, to_json
from housefly.hub.hub import Hub
from housefly.messages import PlanAnswer, Pose, Sighting
from housefly.sites.loaded_site import open_site, read_site
from housefly.tracking.contracts import SightingSink
from housefly.tracking.remote_tracker import RemoteTracker
from housefly.twin.demo_site import demo_site

TOPICS = DroneTopics()


def site_at(folder: Path, **changes: object) -> Site:
    site = read_site("bsen", drone__enabled=False, hub__store=str(folder / "room.db"))
    return changed(site, **changes)


class OneBody:
    """A tracking system that sees the visitor walk."""

    connected, problem = True, ""

    async def run(self, sink: SightingSink) -> NoReturn:
        while True:
            await asyncio.sleep(0.02)
            now = time.monotonic()
            sink((Sighting("visitor", Pose((1.0, 4.2, 1.7)), now, now),))


async def until(done: Callable[[], bool]) -> None:
    async with asyncio.timeout(20.0):
        while not done():
            await asyncio.sleep(0.02)


async def test_what_tracking_sees_is_remembered_and_the_room_is_told(tmp_path: Path) -> None:
    loaded, bus = open_site(site_at(tmp_path)), LocalBus()
    hub = Hub(loaded.site, tmp_path, bus)
    ready = Readiness(loaded.site, bus, web=False, video=loaded.site.has_picture)
    assert ready.wait(0.0).startswith("waiting for tracking")
    tracker, clock = OneBody(), RealClock()
    tracking = RoomTracking(tracker, bus, tmp_path / "tracking", clock)
    nobody = DronelessPilot(loaded, bus, tracker, tracking.frames, clock)
    running = asyncio.gather(tracking.run(), nobody.run())
    try:
        await until(lambda: hub.memory.world.where("visitor").position is not None)
        assert ready.wait(0.0) == ""
        (mocap,) = hub.status.sensors().sensors
        assert (mocap.kind, mocap.connected) == ("mocap", True)
        with pytest.raises(ThingError):
            hub.memory.world.thing("the drone")
        assert from_json(RoomView, bus.ask(TOPICS.room, "")).site == "B-sen"
        refused = from_json(PlanAnswer, bus.ask(TOPICS.plan, to_json(PlanRequest("sofa"))))
        assert refused.path is None and refused.reason == "this room has no drone"
        assert from_json(PreflightView, bus.ask(TOPICS.preflight, "")) == PreflightView()
        assert bus.ask(TOPICS.stand_down, "") == "", "nothing flies that new edits would disturb"
    finally:
        running.cancel()
        await asyncio.gather(running, return_exceptions=True)
        hub.close()


async def test_a_pilot_hears_each_frame_also_when_the_bus_takes_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    bus, clock, heard = LocalBus(), RealClock(), list[Sighting]()

    def refuse(topic: object, message: object) -> None:
        raise LinkError("the bus is gone")

    monkeypatch.setattr(bus, "publish", refuse)
    heard_by = SteppedClock(10.0)
    pilot = RemoteTracker(tmp_path / "tracking", heard_by)
    assert not pilot.connected and "room.log" in pilot.problem
    listening = asyncio.create_task(pilot.run(heard.extend))
    running = asyncio.create_task(RoomTracking(OneBody(), bus, tmp_path / "tracking", clock).run())
    try:
        await until(lambda: len(heard) > 3)
        assert pilot.connected and pilot.problem == ""
        assert all(one.body == "visitor" for one in heard)
        heard_by.advance(1.5)
        assert not pilot.connected and "room.log" in pilot.problem, "it stands still"
        await until(lambda: pilot.connected)
    finally:
        running.cancel()
        await asyncio.gather(running, return_exceptions=True)
    await until(lambda: not pilot.connected)
    again = asyncio.create_task(RoomTracking(OneBody(), bus, tmp_path / "tracking", clock).run())
    before = len(heard)
    await until(lambda: len(heard) > before)
    for task in (again, listening):
        task.cancel()
    await asyncio.gather(again, listening, return_exceptions=True)


def test_no_drone_is_asked_for_started_or_given_a_port(tmp_path: Path) -> None:
    site = changed(demo_site(site_at(tmp_path), has_broker=True)[0], drone__enabled=False)
    names = [spec.name for spec in processes_of(new_runtime(site, tmp_path))]
    assert names[0] == "room" and not {"pilot", "driver"} & set(names)
    assert not any("drone" in need.name for need in port_needs(site, web=True))
    with pytest.raises(ConfigError, match="this room has no drone; set it to true to fly one"):
        require_drone(site)
    found = {check.name: check.found for check in check_machine(site)}
    assert found["drone and tracking"] == "simulated; no drone"


def test_a_drone_without_tracking_is_refused_and_devices_alone_are_a_room(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match="a drone flies by tracking"):
        changed(Site(), tracking__enabled=False)
    alone = site_at(tmp_path, tracking__enabled=False, twin__enabled=False)
    assert Readiness(alone, LocalBus(), web=False, video=alone.has_picture).wait(0.0) == ""
