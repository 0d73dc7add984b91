"""A simulated room that belongs to no run: it stays whatever happens to the run."""

from __future__ import annotations

import asyncio
import contextlib
import os
import re
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from itertools import count, cycle
from pathlib import Path

import psutil
from filming import RATE_HZ, video

from housefly.bus.topics import DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.clock import RealClock
from housefly.config.site import Site, changed, site_from_file
from housefly.messages import DroneStatus, Order, OrderKind, PilotStep, VideoFrame
from housefly.room.files import load_room
from housefly.twin.ardrone.server import ArDroneServer
from housefly.twin.contracts import EncodedPicture, FlightState
from housefly.twin.mocap.tracking_servers import tracking_servers
from housefly.twin.real_time import RealTimeRunner
from housefly.twin.world import SimulatedWorld

TOPICS = DroneTopics()

_IN_THE_AIR = 0.3
_SITE = """
name = "test"
[drone]
address = "{address}"
has_video = {has_video}
[tracking]
kind = "vicon"
address = "{address}"
[hub]
store = "{folder}/room.db"
[web]
port = 0
[twin]
seed = 3
video = false
"""


def outside_site(folder: Path, address: str, *, has_video: bool = False) -> Path:
    """Write the site file of a run whose room is outside of it."""
    site = folder / "site.toml"
    text = _SITE.format(address=address, folder=folder, has_video=str(has_video).lower())
    site.write_text(text)
    return site


class OutsideRoom:
    """The truth of one flight.

    Attributes:
        was_left_alone: whether the drone's own watchdog had to act in the air.
        films: whether the drone's camera sends pictures.
    """

    def __init__(self, site: Site) -> None:
        self.world = SimulatedWorld(site, load_room(site.room.model))
        self.was_left_alone = self.films = False
        self._site = site
        self._stop = threading.Event()
        self._thread = threading.Thread(target=lambda: asyncio.run(self._serve()), daemon=True)

    @property
    def height(self) -> float:
        return self.world.truth().pose.position[2]

    def do(self, change: Callable[[], None]) -> None:
        """Change the world between two of its steps."""
        self._loop.call_soon_threadsafe(change)

    def is_standing(self) -> bool:
        return self.world.onboard().flight is FlightState.LANDED and self.height < 0.15

    def __enter__(self) -> OutsideRoom:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._stop.set()
        self._thread.join()

    async def _serve(self) -> None:
        self._loop = asyncio.get_running_loop()
        drone = ArDroneServer(self.world, self._site.drone.address)
        servers = [drone, *tracking_servers(self._site)]
        for server in servers:
            await server.start()
        serving = asyncio.create_task(
            RealTimeRunner(self.world, RealClock()).run(lambda: self._after_step(servers[1:]))
        )
        frames = cycle(list(video(2.0)))
        for number in count(1):
            if self._stop.is_set():
                break
            await asyncio.sleep(1.0 / RATE_HZ)
            one = next(frames)
            if self.films:
                self._publish(drone, number, one)
        serving.cancel()
        with contextlib.suppress(asyncio.CancelledError):
            await serving
        for server in servers:
            await server.stop()

    def _publish(self, drone: ArDroneServer, number: int, frame: VideoFrame) -> None:
        size = frame.width, frame.height
        at = self.world.truth().at
        drone.publish(EncodedPicture(number, frame.data, frame.keyframe, *size, at))

    def _after_step(self, tracking: list) -> None:
        for frame in self.world.mocap_frames():
            for server in tracking:
                server.publish(frame)
        if self.world.onboard().com_lost and not self.is_standing():
            self.was_left_alone = True


class Run:
    """``housefly run`` as a process of its own, in a room outside."""

    def __init__(self, process: subprocess.Popen[bytes], log: Path, bus: ZenohBus) -> None:
        self.process, self.log, self.bus = process, log, bus
        self.parts = psutil.Process(process.pid).children(recursive=True)
        self._status = DroneStatus.UNKNOWN
        self._steps = bus.subscribe(TOPICS.step, self._on_step)

    def _on_step(self, step: PilotStep) -> None:
        if step.inputs.telemetry is not None:
            self._status = step.inputs.telemetry.status

    def part(self, module: str) -> psutil.Process:
        found = [part for part in self.current_parts() if module in " ".join(part.cmdline())]
        return found[-1]

    def current_parts(self) -> list[psutil.Process]:
        with contextlib.suppress(psutil.NoSuchProcess):
            self.parts = list(
                {*self.parts, *psutil.Process(self.process.pid).children(recursive=True)}
            )
        return [part for part in self.parts if is_alive(part)]

    def order(self, kind: OrderKind, place: str = "") -> None:
        self.bus.publish(
            TOPICS.order, Order(kind, place, issued_at=RealClock().now(), sender="test")
        )

    def order_take_off(self, place: str = "entrance") -> None:
        """Order a flight as soon as the drone is heard."""
        wait_for(lambda: self._status is DroneStatus.LANDED, 60.0, "telemetry")
        time.sleep(1.0)
        self.order(OrderKind.SERVICE, place)

    def fly_off(self, room: OutsideRoom, place: str = "entrance") -> None:
        """Fly to a place; return when the drone is under way."""
        home = room.world.truth().pose.position[:2]
        self.order_take_off(place)
        asked_at = time.monotonic()

        def is_under_way() -> bool:
            x, y, z = room.world.truth().pose.position
            return z > _IN_THE_AIR and abs(x - home[0]) + abs(y - home[1]) > 0.5

        deadline = time.monotonic() + 100.0
        while not is_under_way():
            assert time.monotonic() < deadline, "no flight within 100 s"
            time.sleep(0.02)
            if room.is_standing() and time.monotonic() > asked_at + 4.0:
                asked_at = time.monotonic()  # a busy machine lets an order grow too old
                self.order(OrderKind.SERVICE, place)


def is_alive(part: psutil.Process) -> bool:
    try:
        return part.is_running() and part.status() != psutil.STATUS_ZOMBIE
    except psutil.NoSuchProcess:
        return False


def wait_for(condition: Callable[[], bool], timeout: float, what: str) -> None:
    deadline = time.monotonic() + timeout
    while not condition():
        assert time.monotonic() < deadline, f"{what}: not within {timeout:.0f} s"
        time.sleep(0.02)


@contextmanager
def running_outside(
    site_path: Path, log: Path, *, films: bool = False, **popen: object
) -> Iterator[tuple[OutsideRoom, Run]]:
    """Start a run whose room is outside of it; whatever is left of it in the end is killed."""
    site = site_from_file(site_path)
    mine = site_path.with_suffix(".outside.json")
    mine.write_text(changed(site, twin__enabled=False).model_dump_json())
    with OutsideRoom(site) as room:
        room.films = films
        process = subprocess.Popen(
            [sys.executable, "-m", "housefly.cli", "run", "--site", str(mine)],
            **(popen or {"stdout": log.open("wb"), "stderr": subprocess.STDOUT}),  # type: ignore[call-overload]
        )
        run = None
        try:
            wait_for(lambda: b"ready after" in log.read_bytes(), 200.0, "a run that is ready")
            found = re.search(r"bus: +(\S+)", log.read_text())
            assert found
            with ZenohBus(connect=found[1]) as bus:
                run = Run(process, log, bus)
                yield room, run
        finally:
            left = run.current_parts() if run else []
            if process.poll() is None:
                process.kill()
                process.wait()
            for part in left:
                with contextlib.suppress(psutil.NoSuchProcess):
                    os.kill(part.pid, 9)
