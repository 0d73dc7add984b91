"""The twin as one process: the simulated room in real time behind the real ports.

``kill -USR1`` makes the visitor come or go. Of the true state, only pictures and tracked poses
leave this process, and a file for the summary if that is asked for.
"""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import signal
import sys
import time
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

from housefly.bus.bus import Bus
from housefly.bus.simulated_bell import BELL_QUERY, press_to_json
from housefly.bus.simulated_room import (
    SIMULATION_QUERY,
    SimulatedOutcome,
    act_from_json,
    outcome_to_json,
)
from housefly.bus.zenoh_bus import ZenohBus
from housefly.clock import RealClock
from housefly.config.laser import scip_lasers
from housefly.config.process_log import log_line
from housefly.config.site import Site, site_from_file
from housefly.errors import HouseflyError, WireError
from housefly.messages.words import error_words
from housefly.room.files import load_room
from housefly.room.model import Room
from housefly.twin.address import check_address
from housefly.twin.doorbell import BellWire, Doorbell
from housefly.twin.drone_stands import drone_stands
from housefly.twin.faults.faulty_devices import FaultyDevices
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.faults.vocabulary import Injection
from housefly.twin.hands_link import HandsLink
from housefly.twin.mocap.tracking_servers import tracking_servers
from housefly.twin.people import Scene, load_scene
from housefly.twin.real_time import RealTimeRunner
from housefly.twin.sensors.depth_feed import DepthFeed
from housefly.twin.sensors.laser_feed import LaserFeed
from housefly.twin.sensors.mqtt_publisher import MqttPublisher
from housefly.twin.served_drone import ServedDrone
from housefly.twin.simulation_desk import SimulationDesk
from housefly.twin.truth_log import TruthLog
from housefly.twin.world import SimulatedWorld

_ANSWER_TIMEOUT = 1.5
"""How long the room may take to do what somebody asks for [s]."""


class Twin:
    """Wires the parts of the twin together.

    Args:
        site: addresses, rates, noise, seed.
        room: what the drone flies in.
        beyond_loopback: allow addresses that other machines can reach.
        scene: the people and things that move; its devices speak when the site names a broker.
        bus: where the site's depth cameras send their images and people do things to the room;
            None for neither.
        truth_file: where the true course of the flight goes; None writes none.
        hands: socket on which orders to carry the drone arrive; None takes none.

    Raises:
        ConfigError: an address that is not loopback, without ``beyond_loopback``; a fault of the
            site that cannot be made on wires.
    """

    def __init__(
        self,
        site: Site,
        room: Room,
        beyond_loopback: bool = False,
        scene: Scene | None = None,
        bus: Bus | None = None,
        truth_file: Path | None = None,
        hands: Path | None = None,
    ) -> None:
        check_address("tracking.address", site.tracking.address, beyond_loopback)
        if scene is not None and site.mqtt.broker:
            check_address("mqtt.broker", site.mqtt.broker, beyond_loopback)
        self._site = site
        stands = drone_stands(site, room)
        asked = bus is not None  # whoever is asked may have to put somebody in the way
        faults = [FaultInjector(one.site, Injection.WIRES, intruders=asked) for one in stands]
        self._faults = faults[0]
        movables = next((one.movables for one in faults if one.movables), ())
        intruders = next((one.people for one in faults if one.people), ())
        self._world = SimulatedWorld(site, room, scene, movables, intruders)
        clock = RealClock()
        self._truth = (
            [
                TruthLog(drone, truth_of(truth_file, drone.name, self._world), clock.now)
                for drone in self._world.drones.values()
            ]
            if truth_file
            else []
        )
        self._hands = HandsLink(self._world, hands) if hands else None
        self._time = RealTimeRunner(self._world, RealClock())
        people = (*(scene.script.people if scene else ()), *intruders)
        self._drones = [
            ServedDrone(stand, self._world, room, people, befalls, beyond_loopback)
            for stand, befalls in zip(stands, faults, strict=True)
        ]
        self._stands = stands
        self._tracking = tracking_servers(site) if site.tracking.enabled else ()
        self._lasers = LaserFeed(
            site, self._world, beyond_loopback, self._faults, lambda: self._time.slipped
        )
        self._bus = bus
        self._depth = DepthFeed(site, self._world, bus, clock, self._faults) if bus else None
        self._devices = self._device_link(scene) if scene is not None and site.mqtt.broker else None
        self._bell = Doorbell(self._world, self._bell_wire(scene))
        self._desk = SimulationDesk(
            self._world,
            {stand.name: one for stand, one in zip(stands, faults, strict=True)},
            lambda line: log_line(f"twin: {line}"),
        )

    async def run(self) -> None:
        """Serve until cancelled; raises LinkError when a port cannot be had."""
        async with contextlib.AsyncExitStack() as open_parts:
            for truth in self._truth:
                open_parts.callback(truth.close)
            work = [self._time.run(self._after_step)]
            for stand, drone in zip(self._stands, self._drones, strict=True):
                if stand.config.enabled:
                    work += await drone.start(open_parts)
            for server in self._tracking:
                open_parts.push_async_callback(server.stop)
                await server.start()
            open_parts.push_async_callback(self._lasers.stop)
            await self._lasers.start()
            if self._hands is not None:
                open_parts.callback(self._hands.stop)
                self._hands.start()
            if self._bus is not None:
                loop = asyncio.get_running_loop()
                for query, answer in (
                    (BELL_QUERY, lambda _: self._rung()),
                    (SIMULATION_QUERY, self._done),
                ):
                    answering = self._bus.answer(query, partial(_on_loop, loop, answer))
                    open_parts.callback(answering.close)
            if self._devices is not None:
                work.append(self._devices.run())
            log_line(self._greeting())
            await asyncio.gather(*work)

    def toggle_visitor(self) -> None:
        """Let the visitor come to the door, or leave."""
        present = not self._world.visitor_present
        self._world.set_visitor(present)
        log_line(f"twin: the visitor {'is at the door' if present else 'has left'}")

    def summary(self) -> str:
        """Return one line about the whole run."""
        served = [drone.counters for drone in self._drones]
        commands = sum(counters.commands for counters in served)
        malformed = sum(counters.malformed for counters in served)
        reports = sum(counters.navdata_sent for counters in served)
        pictures = sum(counters.frames_sent for counters in served)
        dropped = sum(counters.frames_dropped for counters in served)
        return (
            f"twin ends after {self._world.now:.1f} s: {commands} commands, {malformed} malformed,"
            f" {reports} reports, {pictures} pictures sent, {dropped} dropped,"
            f" {self._time.slipped:.2f} s lost to stalls"
        )

    def _greeting(self) -> str:
        tracking = self._site.tracking
        video = "on" if any(drone.films for drone in self._drones) else "off"
        scanners = "".join(
            f", {laser.name} at {laser.address}:{laser.port}"
            for laser in scip_lasers(self._site.lasers)
        )
        places = ", ".join(
            f"{tracking.address}:{tracking.port_of(wire)}" for wire in self._site.served_wires
        )
        depth = "".join(
            f", {camera.name} on the bus" for camera in self._site.depth_cameras if self._depth
        )
        faults = "".join(
            f"; made to fail: {fault}"
            for drone in self._drones
            for fault in drone.faults.schedule.faults
        )
        flies = self._flying()
        return f"twin ready: {flies}, tracking at {places}, video {video}{scanners}{depth}{faults}"

    def _flying(self) -> str:
        """Return which drones answer where, in words."""
        flown = [stand for stand in self._stands if stand.config.enabled]
        if len(flown) > 1:
            places = ", ".join(f"{stand.name} at {stand.config.address}" for stand in flown)
            return f"drones {places}"
        return f"drone at {flown[0].config.address}" if flown else "no drone"

    def _device_link(self, scene: Scene) -> MqttPublisher:
        return MqttPublisher(
            self._site.mqtt,
            FaultyDevices(scene, self._site.mqtt.site, self._faults),
            self._now,
            lambda line: log_line(f"twin: {line}"),
        )

    def _bell_wire(self, scene: Scene | None) -> BellWire | None:
        """Return what the scene's first doorbell speaks with, or None without one."""
        if scene is None or self._devices is None:
            return None
        link = self._devices
        bells = (device.id for device in scene.script.devices if device.kind == "doorbell")
        return next((BellWire(partial(link.press, bell), link.trouble) for bell in bells), None)

    def _rung(self) -> str:
        return press_to_json(self._bell.ring(self._world.now, time.time()))

    def _done(self, text: str) -> str:
        try:
            return outcome_to_json(self._desk.do(act_from_json(text)))
        except WireError as error:
            return outcome_to_json(SimulatedOutcome(False, error_words(error)))

    def _now(self) -> float:
        return self._world.now

    def _after_step(self) -> None:
        for drone in self._drones:
            drone.act()
        self._bell.advance(self._world.now)
        for truth in self._truth:
            truth.sample()
        frames = self._world.mocap_frames()
        for drone in self._drones:
            frames = drone.faults.frames(frames, self._world.now)
        for frame in frames:
            for server in self._tracking:
                server.publish(frame)
        self._lasers.publish()
        if self._depth is not None:
            self._depth.publish()


def _on_loop(loop: asyncio.AbstractEventLoop, answer: Callable[[str], str], question: str) -> str:
    """Return an answer to what is asked on a thread of the bus; given on the loop of the room."""

    async def answered() -> str:
        return answer(question)

    return asyncio.run_coroutine_threadsafe(answered(), loop).result(_ANSWER_TIMEOUT)


def truth_of(path: Path, name: str, world: SimulatedWorld) -> Path:
    """Return the file of a drone's true course: the one given, with its name where there are more.

    Args:
        path: as given.
        name: of the drone.
        world: its world.
    """
    return path if len(world.drones) == 1 else path.with_stem(f"{path.stem}-{name}")


async def run_twin(
    site: Site,
    room: Room,
    *,
    beyond_loopback: bool = False,
    scene: Scene | None = None,
    bus: Bus | None = None,
    truth_file: Path | None = None,
    hands: Path | None = None,
) -> None:
    """Serve the simulated room until SIGTERM, SIGINT or cancellation.

    Raises:
        ConfigError: an address that is not loopback, without ``beyond_loopback``.
        LinkError: a port that cannot be had.
    """
    twin = Twin(site, room, beyond_loopback, scene, bus, truth_file, hands)
    serving = asyncio.create_task(twin.run())
    loop = asyncio.get_running_loop()
    loop.add_signal_handler(signal.SIGUSR1, twin.toggle_visitor)
    for number in (signal.SIGTERM, signal.SIGINT):
        loop.add_signal_handler(number, serving.cancel)
    with contextlib.suppress(asyncio.CancelledError):
        await serving
    log_line(twin.summary())


def main(argv: Sequence[str] | None = None) -> int:
    """Run the twin of a site file and return the exit code."""
    parser = argparse.ArgumentParser(
        prog="housefly.twin.process", description=__doc__.splitlines()[0] if __doc__ else None
    )
    parser.add_argument("--site", type=Path, required=True, help="site file")
    parser.add_argument(
        "--beyond-loopback",
        action="store_true",
        help="serve other machines too; nothing on these ports is secured",
    )
    parser.add_argument(
        "--bus",
        default="",
        help="zenoh endpoint for depth images and what people do, unixsock-stream/PATH",
    )
    parser.add_argument(
        "--truth", type=Path, help="file for the true course of the flight, for its summary"
    )
    parser.add_argument(
        "--hands", type=Path, help="Unix socket on which orders to carry the drone arrive"
    )
    options = parser.parse_args(argv)
    try:
        site = site_from_file(options.site)
        room = load_room(site.room.model, options.site.parent)
        scene = load_scene(site.twin.scene, options.site.parent) if site.twin.scene else None
        with ZenohBus(connect=options.bus) if options.bus else contextlib.nullcontext() as bus:
            asyncio.run(
                run_twin(
                    site,
                    room,
                    beyond_loopback=options.beyond_loopback,
                    scene=scene,
                    bus=bus,
                    truth_file=options.truth,
                    hands=options.hands,
                )
            )
    except HouseflyError as error:
        log_line(f"twin: {error}", sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
