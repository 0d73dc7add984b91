"""An identification flight, on a stepped clock or over real wires: take off, go to the box, fly the
blocks, come home, land.
"""

from __future__ import annotations

import asyncio
import gc
import os
import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from math import inf
from pathlib import Path

from housefly.app.launcher import Launcher, Part
from housefly.app.pilot_shell import PilotShell
from housefly.app.premises import Premises
from housefly.app.runtime import new_runtime
from housefly.app.trackers import tracker_of
from housefly.bus.local import LocalBus
from housefly.bus.topics import ORDER, STEP
from housefly.clock import RealClock
from housefly.drones.ardrone.driver import ArDrone
from housefly.geometry import Vec2, Vec3, distance
from housefly.lab.identification.box import Box
from housefly.lab.identification.maneuver import NEAR, Maneuver
from housefly.messages import DroneStatus, Inputs, Order, OrderKind, Phase, PilotStep, SafetyMode
from housefly.pilot.pilot import Pilot, warm_up
from housefly.twin.contracts import World
from housefly.twin.lockstep import LockstepRoom

START_PATIENCE = 30.0
"""How long drone and tracking may take to answer [s]."""
BLOCK_PATIENCE = 30.0
"""Longest time for one block with the rest before it [s]."""
INTERRUPTED = "interrupted"
SENDER = "identification"
AGAIN_AFTER = 1.0
"""An order that was not followed is given again after this [s]."""
URGENCY = -10
"""Nice value that the flight takes where the system lets it."""


@dataclass(slots=True)
class Errand:
    """Leads one flight by orders, step by step, as a person would.

    Attributes:
        box: where the blocks are flown.
        maneuver: the blocks.
        patience: longest time in the air [s].
        outcome: "" while it flies, then "completed" or the reason.
    """

    box: Box
    maneuver: Maneuver
    patience: float
    outcome: str = ""
    _asked_at: float = -inf
    _began: float | None = None
    _flown: bool = False
    _arrived: bool = False
    _problem: str = ""

    def after(self, step: PilotStep) -> Order | None:
        """Return the next order, if one is due."""
        now, outputs, telemetry = step.now, step.outputs, step.inputs.telemetry
        self._began = now if self._began is None else self._began
        if telemetry is None or outputs.estimate is None:
            waited = now - self._began > START_PATIENCE
            self.outcome = "no word from the drone or from tracking" if waited else ""
            return None
        self._flown = self._flown or outputs.phase is Phase.HOLDING
        if outputs.safety in (SafetyMode.LAND, SafetyMode.CUT) and not self._problem:
            self._problem = outputs.reason
        if telemetry.status is DroneStatus.LANDED and outputs.phase is Phase.IDLE and self._flown:
            self.outcome = self._problem or self.maneuver.problem or "completed"
            return None
        if now - self._began > self.patience:
            self._problem = self._problem or f"not done within {self.patience:.0f} s"
            return self._asking(OrderKind.LAND, now)
        return self._next(outputs.phase, outputs.estimate.position, now)

    def _next(self, phase: Phase, position: Vec3, now: float) -> Order | None:
        if phase is Phase.IDLE:
            return self._asking(OrderKind.TAKE_OFF, now)
        if phase is not Phase.HOLDING:
            return None
        if self.maneuver.finished:
            return self._asking(OrderKind.HOME, now)
        # The blocks begin in the middle: anywhere else in the box they would wait for ever.
        self._arrived = self._arrived or distance(position[:2], self.box.centre) < NEAR
        return None if self._arrived else self._asking(OrderKind.GO, now, self.box.centre)

    def _asking(self, kind: OrderKind, now: float, goal: Vec2 | None = None) -> Order | None:
        """Return the order, again after a while: the pilot refuses orders while it does not see the
        drone.
        """
        if now - self._asked_at < AGAIN_AFTER:
            return None
        self._asked_at = now
        return Order(kind, goal=goal, issued_at=now, sender=SENDER)


def fly_in_lock_step(
    premises: Premises, world: World, errand: Errand, on_step: Callable[[PilotStep], None]
) -> str:
    """Fly on a stepped clock and return the outcome; the world may hold another drone than the
    pilot believes.
    """
    room = LockstepRoom(world, premises.site)
    pilot = Pilot(premises.site, premises.room, premises.grid, errand.maneuver)
    period = 1.0 / premises.site.control.rate_hz
    sequence, order = 0, None
    while not errand.outcome:
        room.advance(period)
        issued = (
            (Order(order.kind, goal=order.goal, issued_at=room.now, sender=SENDER),)
            if order
            else ()
        )
        inputs = Inputs(room.sightings(), room.telemetry(), issued)
        outputs = pilot.step(room.now, inputs)
        room.send(outputs.command)
        step = PilotStep(sequence, room.now, inputs, outputs)
        on_step(step)
        order = errand.after(step)
        sequence += 1
    return errand.outcome


def fly_over_wires(
    premises: Premises, errand: Errand, folder: Path, on_step: Callable[[PilotStep], None]
) -> str:
    """Fly whatever drone the site names and return the outcome; Ctrl-C lands it first.

    The pilot runs in this process, at the head of its own loop; the twin, where the site has one,
    in a process of its own.
    """
    runtime = new_runtime(premises.site, folder)
    site = runtime.site()
    parts = (
        (Part("twin", "housefly.twin.process", ("--site", str(runtime.site_file))),)
        if site.twin.enabled
        else ()
    )
    warm_up(premises.site, premises.room, premises.grid)
    with Launcher(runtime, folder, parts), _undisturbed():
        return asyncio.run(_fly(premises, errand, on_step))


@contextmanager
def _undisturbed() -> Iterator[None]:
    """Keep the loop on time: every step is kept, and a garbage collector that walks them all would
    stop it for half a second.
    """
    with suppress(PermissionError):
        os.setpriority(os.PRIO_PROCESS, 0, URGENCY)
    gc.collect()
    gc.disable()
    try:
        yield
    finally:
        gc.enable()


async def _fly(premises: Premises, errand: Errand, on_step: Callable[[PilotStep], None]) -> str:
    site, clock, bus = premises.site, RealClock(), LocalBus()
    shell = PilotShell(
        premises,
        bus,
        tracker_of(site.tracking, clock),
        ArDrone(site.drone, site.limits, clock),
        errand.maneuver,
    )
    interrupted = threading.Event()

    def heard(step: PilotStep) -> None:
        on_step(step)
        if errand.outcome or interrupted.is_set():
            return
        order = errand.after(step)
        if errand.outcome:
            shell.leave()
        elif order is not None:
            bus.publish(ORDER, order)

    def interrupt() -> None:
        interrupted.set()
        shell.leave()

    loop = asyncio.get_running_loop()
    for number in (signal.SIGINT, signal.SIGTERM):
        loop.add_signal_handler(number, interrupt)
    subscription = bus.subscribe(STEP, heard)
    try:
        await shell.run()
    finally:
        subscription.close()
        bus.close()
    return INTERRUPTED if interrupted.is_set() else errand.outcome
