"""An identification flight: take off, go to the box, fly the blocks, come home, land.

It runs on a stepped clock or over real wires.
"""

from __future__ import annotations

import asyncio
import gc
import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from math import inf
from pathlib import Path

from housefly.app.launcher import Launcher, ProcessSpec, driver_process
from housefly.app.new_runtime import new_runtime
from housefly.app.pilot_shell import PilotShell
from housefly.app.priority import raise_priority
from housefly.bus.local import LocalBus
from housefly.bus.topics import DroneTopics
from housefly.clock import RealClock
from housefly.config.drone import DroneConfig
from housefly.drones.remote_drone import RemoteDrone
from housefly.geometry import Vec2, Vec3, distance
from housefly.lab.identification.box import Box
from housefly.lab.identification.maneuver import REST_DISTANCE, IdentificationManeuver
from housefly.lab.identification.pattern import Block, largest_excursion
from housefly.lab.lockstep.lockstep_room import LockstepRoom
from housefly.lab.lockstep.pilot_loop import PilotLoop
from housefly.messages import (
    DroneStatus,
    Order,
    OrderKind,
    OrderSource,
    Phase,
    PilotStep,
    SafetyMode,
)
from housefly.pilot.assembly import make_pilot, warm_up
from housefly.sites.loaded_site import LoadedSite
from housefly.tracking.trackers import tracker_of
from housefly.twin.contracts import TwinWorld

_START_TIMEOUT = 30.0
"""Longest time until drone and tracking answer [s]."""
BLOCK_TIMEOUT = 30.0
"""Longest time for one block and the pause before it [s]."""
_BOX_MARGIN = 0.3
"""Room in the box beyond the predicted excursion [m]."""
_INTERRUPTED = "interrupted"
_SENDER = "identification"
_REPEAT_ORDER_AFTER = 1.0
"""An order that was not followed is repeated after this time [s]."""


def box_reach(plan: tuple[Block, ...], drone: DroneConfig) -> float:
    """Return how far [m] the box must reach from its centre for the blocks of a plan."""
    return _BOX_MARGIN + largest_excursion(
        plan, drone.attitude_lag, drone.attitude_gain, drone.drag, drone.command_delay
    )


@dataclass(slots=True)
class IdentificationFlight:
    """Gives the orders of one flight, as a person would.

    Attributes:
        box: where the blocks are flown.
        maneuver: the blocks.
        timeout: longest time in the air [s].
        outcome: "" while it flies, then "completed" or the reason.
    """

    box: Box
    maneuver: IdentificationManeuver
    timeout: float
    outcome: str = ""
    _asked_at: float = -inf
    _began: float | None = None
    _flown: bool = False
    _arrived: bool = False
    _problem: str = ""

    def next_order(self, step: PilotStep) -> Order | None:
        """Return the next order, if one is due."""
        now, outputs, telemetry = step.now, step.outputs, step.inputs.telemetry
        self._began = now if self._began is None else self._began
        if telemetry is None or outputs.estimate is None:
            waited = now - self._began > _START_TIMEOUT
            self.outcome = "no word from the drone or from tracking" if waited else ""
            return None
        self._flown = self._flown or outputs.phase is Phase.HOLDING
        if outputs.safety in (SafetyMode.LAND, SafetyMode.CUT) and not self._problem:
            self._problem = outputs.reason
        if telemetry.status is DroneStatus.LANDED and outputs.phase is Phase.IDLE and self._flown:
            self.outcome = self._problem or self.maneuver.problem or "completed"
            return None
        if now - self._began > self.timeout:
            self._problem = self._problem or f"not done within {self.timeout:.0f} s"
            return self._order(OrderKind.LAND, now)
        return self._next(outputs.phase, outputs.estimate.position, now)

    def _next(self, phase: Phase, position: Vec3, now: float) -> Order | None:
        if phase is Phase.IDLE:
            return self._order(OrderKind.TAKE_OFF, now)
        if phase is not Phase.HOLDING:
            return None
        if self.maneuver.finished:
            return self._order(OrderKind.HOME, now)
        # The blocks begin only near the centre of the box.
        self._arrived = self._arrived or distance(position[:2], self.box.centre) < REST_DISTANCE
        return None if self._arrived else self._order(OrderKind.GO, now, self.box.centre)

    def _order(self, kind: OrderKind, now: float, goal: Vec2 | None = None) -> Order | None:
        """Return the order unless it was just given; the pilot may have refused an earlier one."""
        if now - self._asked_at < _REPEAT_ORDER_AFTER:
            return None
        self._asked_at = now
        return Order(kind, goal=goal, issued_at=now, sender=_SENDER, source=OrderSource.PROGRAM)


def fly_identification_lockstep(
    loaded: LoadedSite,
    world: TwinWorld,
    flight: IdentificationFlight,
    on_step: Callable[[PilotStep], None],
) -> str:
    """Fly on a stepped clock and return the outcome.

    The drone of the world may differ from the one that the site describes.
    """
    pilot = make_pilot(loaded.site, loaded.room, loaded.grid, flight.maneuver)
    loop = PilotLoop(LockstepRoom(world, loaded.site), pilot, loaded.site.control.rate_hz)
    order = None
    while not flight.outcome:
        loop.advance()
        orders = (replace(order, issued_at=loop.now),) if order else ()
        step = loop.step(loop.inputs(*orders))
        on_step(step)
        order = flight.next_order(step)
    return flight.outcome


def fly_identification_over_wires(
    loaded: LoadedSite,
    flight: IdentificationFlight,
    folder: Path,
    on_step: Callable[[PilotStep], None],
) -> str:
    """Fly whatever drone the site names and return the outcome; Ctrl-C lands it first.

    The pilot runs in this process, driver and twin in processes of their own.
    """
    runtime = new_runtime(loaded.site, folder)
    site = runtime.site()
    processes = (
        driver_process(site, site.drone.name),
        *(
            (ProcessSpec("twin", "housefly.twin.process", ("--site", str(runtime.site_file))),)
            if site.twin.enabled
            else ()
        ),
    )
    warm_up(loaded.site, loaded.room, loaded.grid)
    with Launcher(runtime, folder, processes), _undisturbed():
        return asyncio.run(_fly(loaded, flight, runtime.driver_socket(site.drone.name), on_step))


@contextmanager
def _undisturbed() -> Iterator[None]:
    """Keep the loop on time: collecting garbage among all the kept steps takes half a second."""
    raise_priority()
    gc.collect()
    gc.disable()
    try:
        yield
    finally:
        gc.enable()


async def _fly(
    loaded: LoadedSite,
    flight: IdentificationFlight,
    driver_socket: Path,
    on_step: Callable[[PilotStep], None],
) -> str:
    site, clock, bus = loaded.site, RealClock(), LocalBus()
    topics = DroneTopics(site.drone.name)
    shell = PilotShell(
        loaded,
        bus,
        tracker_of(site.tracking, clock),
        RemoteDrone(driver_socket, clock),
        flight.maneuver,
    )
    interrupted = threading.Event()

    def on_pilot_step(step: PilotStep) -> None:
        on_step(step)
        if flight.outcome or interrupted.is_set():
            return
        order = flight.next_order(step)
        if flight.outcome:
            shell.leave()
        elif order is not None:
            bus.publish(topics.order, order)

    def interrupt() -> None:
        interrupted.set()
        shell.leave()

    loop = asyncio.get_running_loop()
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        loop.add_signal_handler(number, interrupt)
    subscription = bus.subscribe(topics.step, on_pilot_step)
    try:
        await shell.run()
    finally:
        subscription.close()
        bus.close()
    return _INTERRUPTED if interrupted.is_set() else flight.outcome
