"""What leaves the pilot's process besides commands."""

from __future__ import annotations

import asyncio
import contextlib
import io
import threading
from pathlib import Path
from typing import Any

import pytest
from full_disk import full_output
from room_here import RoomHere

from housefly.app.launcher import Launcher, processes_of
from housefly.app.new_runtime import new_runtime
from housefly.app.pilot_shell import PilotShell, StepFailure
from housefly.app.readiness import Readiness
from housefly.bus.local import LocalBus
from housefly.bus.topics import FRAME_TOPIC, DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.clock import RealClock
from housefly.drones.ardrone.driver import ArDrone
from housefly.errors import LinkError
from housefly.messages import (
    Action,
    Inputs,
    KnownMotion,
    LinkStatus,
    Order,
    OrderKind,
    Outputs,
    PilotStep,
    PreflightCheck,
    RecordingNews,
    SafetyMode,
    Severity,
    Sighting,
    TrackedFrame,
    VideoFrame,
)
from housefly.pilot.assembly import warm_up
from housefly.pilot.estimation.estimation_report import EstimationReport
from housefly.sites.loaded_site import open_site, read_site
from housefly.tracking.trackers import tracker_of

TOPICS = DroneTopics()

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.usefixtures("fresh_log")]


def test_frames_are_told_as_they_come_and_not_at_the_next_step(
    tmp_path: Path, write_site: Any
) -> None:
    told: list[Sighting] = []
    stepped: list[Sighting] = []
    waited: list[float] = []
    enough = threading.Event()

    def on_frame(frame: TrackedFrame) -> None:
        told.extend(frame.sightings)

    def on_step(step: PilotStep) -> None:
        if told:
            stepped.extend(step.inputs.sightings)
            waited.extend(step.now - sighting.received_at for sighting in step.inputs.sightings)
        if len(stepped) > 200:
            enough.set()

    site = read_site(str(write_site()), hub__enabled=False)
    runtime = new_runtime(site, tmp_path)
    with (
        Launcher(runtime, tmp_path, processes_of(runtime)),
        ZenohBus(connect=runtime.bus) as bus,
    ):
        assert Readiness(site, bus, web=False, video=False).wait(60.0) == ""
        subscriptions = [
            bus.subscribe(FRAME_TOPIC, on_frame),
            bus.subscribe(TOPICS.step, on_step),
        ]
        assert enough.wait(30.0)
        for subscription in subscriptions:
            subscription.close()
    begun, ended = told[0].captured_at, told[-1].captured_at
    missing = [one for one in stepped if begun <= one.captured_at <= ended and one not in told]
    assert len(missing) <= 5, "steps know of frames that were never told"
    assert max(waited) > 0.002, "the pilot steps on its own clock"


class FailingPilot:
    """Steps as the real one does until told to fail."""

    def __init__(self, pilot: Any) -> None:
        self._pilot = pilot
        self.fails = False
        self.calls_after_failing = 0

    def step(self, now: float, inputs: Inputs) -> Outputs:
        if self.fails:
            self.calls_after_failing += 1
            raise ZeroDivisionError("float division by zero")
        outputs: Outputs = self._pilot.step(now, inputs)
        return outputs

    @property
    def estimation(self) -> EstimationReport:
        if self.fails:
            raise ZeroDivisionError("float division by zero")
        found: EstimationReport = self._pilot.estimation
        return found

    @property
    def origin_confirmed(self) -> bool:
        if self.fails:
            raise ZeroDivisionError("float division by zero")
        return bool(self._pilot.origin_confirmed)

    @property
    def known_motion(self) -> KnownMotion | None:
        if self.fails:
            raise ZeroDivisionError("float division by zero")
        found: KnownMotion | None = self._pilot.known_motion
        return found

    def preflight(self) -> tuple[PreflightCheck, ...]:
        if self.fails:
            raise ZeroDivisionError("float division by zero")
        checks: tuple[PreflightCheck, ...] = self._pilot.preflight()
        return checks


async def flying_shell(room: RoomHere, steps: list[PilotStep], links: list[LinkStatus]) -> Any:
    """Return a pilot's shell on real wires in flight, and the task that runs it."""
    loaded, clock, bus = room.loaded, RealClock(), LocalBus()
    warm_up(loaded.site, loaded.room, loaded.grid)
    drone = ArDrone(loaded.site.drone, loaded.site.limits, clock)
    shell = PilotShell(loaded, bus, tracker_of(loaded.site.tracking, clock), drone)
    failing = FailingPilot(shell.pilot)
    shell.pilot = failing  # type: ignore[assignment]
    bus.subscribe(TOPICS.step, steps.append)
    bus.subscribe(TOPICS.link, links.append)
    running = asyncio.create_task(shell.run())
    await room.until(lambda: steps and steps[-1].outputs.estimate is not None)
    await room.until(lambda: drone.telemetry is not None and drone.telemetry.configured)
    bus.publish(TOPICS.order, Order(OrderKind.TAKE_OFF, issued_at=clock.now()))
    await room.until(lambda: room.world.onboard().flight.name == "HOVERING", 20.0)
    return shell, failing, bus, running


async def test_the_drones_light_shows_that_its_camera_is_recorded_until_the_recorder_falls_silent(
    write_site: Any,
) -> None:
    loaded = open_site(read_site(str(write_site()), hub__enabled=False))
    bus, clock = LocalBus(), RealClock()
    async with RoomHere(loaded) as room:
        drone = ArDrone(loaded.site.drone, loaded.site.limits, clock)
        shell = PilotShell(loaded, bus, tracker_of(loaded.site.tracking, clock), drone)
        running = asyncio.create_task(shell.run())
        await room.until(lambda: drone.telemetry is not None and drone.telemetry.configured)
        bus.publish(TOPICS.recording, RecordingNews(clock.now() - 10.0, records=True))
        await asyncio.sleep(0.5)
        assert room.world.truth().leds == 6, "an old message says nothing about now"
        for _ in range(3):
            bus.publish(TOPICS.recording, RecordingNews(clock.now(), records=True))
            await room.until(lambda: room.world.truth().leds == 2)
            await asyncio.sleep(0.5)
        bus.publish(TOPICS.recording, RecordingNews(clock.now(), records=False))
        await room.until(lambda: room.world.truth().leds == 6)
        bus.publish(TOPICS.recording, RecordingNews(clock.now(), records=True))
        await room.until(lambda: room.world.truth().leds == 2)
        await room.until(lambda: room.world.truth().leds == 6)
        shell.leave()
        await asyncio.wait_for(running, 30.0)


async def test_an_exception_in_the_step_lands_the_drone_and_ends_the_process(
    write_site: Any, capfd: pytest.CaptureFixture[str]
) -> None:
    loaded = open_site(read_site(str(write_site()), hub__enabled=False))
    steps: list[PilotStep] = []
    links: list[LinkStatus] = []
    async with RoomHere(loaded) as room:
        _, failing, _, running = await flying_shell(room, steps, links)
        place = room.now
        failing.fails = True
        with pytest.raises(StepFailure, match="division by zero"):
            await asyncio.wait_for(running, 30.0)
        assert room.world.onboard().flight.name == "LANDED"
        assert room.way_since(place) < 0.4
    assert failing.calls_after_failing == 1
    (told,) = [event for step in steps for event in step.outputs.events if "failed" in event.text]
    assert told.severity is Severity.FAULT and "division by zero" in told.text
    assert steps[-1].outputs.command.action is Action.LAND
    assert any("the pilot failed" in note for link in links for note in link.notes)
    assert "ZeroDivisionError" in capfd.readouterr().err


async def test_an_exception_in_the_step_lands_the_drone_although_the_log_takes_no_more(
    write_site: Any,
) -> None:
    loaded = open_site(read_site(str(write_site()), hub__enabled=False))
    links: list[LinkStatus] = []
    async with RoomHere(loaded) as room:
        _, failing, _, running = await flying_shell(room, [], links)
        links.clear()
        with full_output():
            failing.fails = True
            with pytest.raises(StepFailure, match="division by zero"):
                await asyncio.wait_for(running, 30.0)
        assert room.world.onboard().flight.name == "LANDED"
    assert sum("the pilot failed" in " ".join(link.notes) for link in links) >= 2


async def test_a_step_that_fails_lands_the_drone_before_it_says_so(
    write_site: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    loaded, clock, bus = open_site(read_site(str(write_site()))), RealClock(), LocalBus()
    drone = ArDrone(loaded.site.drone, loaded.site.limits, clock)
    shell = PilotShell(loaded, bus, tracker_of(loaded.site.tracking, clock), drone)
    failing = FailingPilot(shell.pilot)
    failing.fails = True
    shell.pilot = failing  # type: ignore[assignment]
    done: list[str] = []
    monkeypatch.setattr(drone, "send", lambda command, *_: done.append(command.action.name))

    class Watched(io.StringIO):
        def write(self, text: str) -> int:
            done.append("said")
            return super().write(text)

    with contextlib.redirect_stderr(Watched()) as said:
        shell._step()
    assert "ZeroDivisionError" in said.getvalue()
    assert done[:2] == ["LAND", "said"]


async def test_after_a_failed_step_cutting_the_motors_still_passes_and_stop_lands_on(
    write_site: Any,
) -> None:
    loaded = open_site(read_site(str(write_site()), hub__enabled=False))
    steps: list[PilotStep] = []
    async with RoomHere(loaded) as room:
        shell, failing, bus, running = await flying_shell(room, steps, [])
        failing.fails = True
        await room.until(lambda: steps[-1].outputs.command.action is Action.LAND)
        shell.stop()
        assert steps[-1].outputs.command.action is Action.LAND
        bus.publish(TOPICS.order, Order(OrderKind.CUT))
        await room.until(lambda: room.world.onboard().flight.name == "EMERGENCY", 1.0)
        with pytest.raises(StepFailure):
            await asyncio.wait_for(running, 10.0)


async def test_a_flood_of_orders_is_named_and_stop_passes_it_at_once(write_site: Any) -> None:
    loaded = open_site(read_site(str(write_site()), hub__enabled=False))
    steps: list[PilotStep] = []
    async with RoomHere(loaded) as room:
        shell, _, bus, running = await flying_shell(room, steps, [])
        before = len(steps)
        for number in range(1000):
            place = ("table", "entrance")[number % 2]
            now = shell._clock.now()
            bus.publish(TOPICS.order, Order(OrderKind.GO, place, issued_at=now, sender="loop"))
        bus.publish(TOPICS.order, Order(OrderKind.STOP, issued_at=shell._clock.now()))
        await room.until(lambda: len(steps) > before, 1.0)
        assert [order.kind for order in steps[before].inputs.orders][-1] is OrderKind.STOP
        assert len(steps[before].inputs.orders) == 2
        await room.until(
            lambda: any(
                event.code == "orders_flooded"
                for step in steps[before:]
                for event in step.outputs.events
            )
        )
        assert steps[-1].outputs.safety is SafetyMode.STOPPED
        shell.leave()
        await asyncio.wait_for(running, 30.0)


@pytest.mark.parametrize("log_is_full", [False, True], ids=["", "the log takes no more"])
async def test_a_step_that_cannot_be_published_is_said_and_flown_all_the_same(
    write_site: Any, monkeypatch: pytest.MonkeyPatch, log_is_full: bool
) -> None:
    loaded = open_site(read_site(str(write_site()), hub__enabled=False))
    steps: list[PilotStep] = []
    links: list[LinkStatus] = []
    log = full_output() if log_is_full else contextlib.nullcontext()
    async with RoomHere(loaded) as room:
        shell, _, bus, running = await flying_shell(room, steps, links)

        def refuse(topic: object, message: object) -> None:
            if topic == TOPICS.step:
                raise ValueError("too long")
            publish(topic, message)

        publish = bus.publish
        monkeypatch.setattr(bus, "publish", refuse)
        links.clear()
        with log:
            await room.until(lambda: len(links) > 1)
        assert any("too long" in note for note in links[-1].notes)
        assert room.world.onboard().flight.airborne
        shell.leave()
        await asyncio.wait_for(running, 30.0)
        assert room.world.onboard().flight.name == "LANDED"


async def test_a_picture_or_report_that_cannot_be_published_stops_nothing(
    write_site: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    loaded, clock, bus = open_site(read_site(str(write_site()))), RealClock(), LocalBus()
    drone = ArDrone(loaded.site.drone, loaded.site.limits, clock)
    shell = PilotShell(loaded, bus, tracker_of(loaded.site.tracking, clock), drone)

    def refuse(topic: object, message: object) -> None:
        raise LinkError("the bus is gone")

    monkeypatch.setattr(bus, "publish", refuse)
    for topic, hear in (
        (TOPICS.video, lambda: shell._on_video(VideoFrame(b"", True, 640, 360, 0, 1.0))),
        (TOPICS.link, shell._report),
    ):
        hear()
        problem = f"{topic.key} could not be published: LinkError: the bus is gone"
        assert problem in shell._link_status().notes


async def test_disks_that_cannot_be_looked_at_once_are_looked_at_again(
    write_site: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    loaded = open_site(read_site(str(write_site()), hub__enabled=False))
    looks: list[int] = []

    def look() -> None:
        looks.append(1)
        if len(looks) == 1:
            raise RuntimeError("a disk of its own kind")

    monkeypatch.setattr("housefly.app.pilot_shell.DISK_LOOK_PERIOD", 0.01)
    clock = RealClock()
    drone = ArDrone(loaded.site.drone, loaded.site.limits, clock)
    shell = PilotShell(loaded, LocalBus(), tracker_of(loaded.site.tracking, clock), drone)
    monkeypatch.setattr(shell._disks, "look", look)
    watching = asyncio.create_task(shell._watch_disks())
    async with asyncio.timeout(10.0):
        while len(looks) < 2:
            await asyncio.sleep(0.01)
    watching.cancel()
