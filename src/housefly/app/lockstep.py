"""Flies one service on a stepped clock: the same pilot and world, without wires."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing, nullcontext
from pathlib import Path

from housefly.app.loaded_site import LoadedSite
from housefly.app.lockstep_perception import LockstepPerception
from housefly.app.service_monitor import ServiceMonitor
from housefly.geometry import distance
from housefly.messages import Estimate, Inputs, Order, PilotStep
from housefly.pilot.assembly import make_pilot
from housefly.record.truth import ContactRecord, judged_outcome
from housefly.twin.contact_log import Contact
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.lockstep import LockstepRoom
from housefly.twin.movable import Movable
from housefly.twin.people import load_scene
from housefly.twin.truth_log import TruthLog
from housefly.twin.world import SimulatedWorld

_SETTLING_TIME = 0.5
"""World time before the order is given, so that tracking and telemetry are there [s]."""


def fly_lockstep(
    loaded: LoadedSite,
    order: Order,
    on_step: Callable[[PilotStep], None],
    give_up_after: float = 240.0,
    movables: tuple[Movable, ...] = (),
    on_world: Callable[[SimulatedWorld], None] = lambda world: None,
    truth_file: Path | None = None,
) -> str:
    """Fly one service in lock step and return its outcome ("completed" or the reason).

    A service in which the drone touched anything is not completed.

    Args:
        loaded: site, room and map.
        order: what to fly; it is issued ``_SETTLING_TIME`` after the start.
        on_step: called with every step of the pilot.
        give_up_after: longest world time [s].
        movables: things that no map shows.
        on_world: called before every step of the pilot; may place movables.
        truth_file: where the true course of the flight goes, for the summary.

    Raises:
        ConfigError: a fault of the site that cannot be made in lock step.
    """
    scene = load_scene(loaded.site.twin.scene) if loaded.site.twin.scene else None
    faults = FaultInjector(loaded.site)
    world = SimulatedWorld(
        loaded.site, loaded.room, scene, (*movables, *faults.movables), faults.people
    )
    room = LockstepRoom(world, loaded.site, faults)
    perception = LockstepPerception(loaded, world, faults)
    estimate: Estimate | None = None
    pilot = make_pilot(loaded.site, loaded.room, loaded.grid)
    period = 1.0 / loaded.site.control.rate_hz
    order_at = room.now + _SETTLING_TIME
    monitor = ServiceMonitor(order_at, loaded.room.home, give_up_after)
    sequence, given = 0, False
    truth = TruthLog(world, truth_file, lambda: world.now) if truth_file else None
    with closing(truth) if truth else nullcontext():
        while not monitor.outcome:
            room.advance(period)
            on_world(world)
            orders: tuple[Order, ...] = ()
            if not given and room.now >= order_at:
                orders, given = (_issued(order, room.now),), True
            inputs = Inputs(
                room.sightings(), room.telemetry(), orders, perception.update(room.now, estimate)
            )
            outputs = pilot.step(room.now, inputs)
            estimate = outputs.estimate
            room.send(outputs.command)
            step = PilotStep(sequence, room.now, inputs, outputs)
            on_step(step)
            if truth is not None:
                truth.sample()
            if given:
                monitor = monitor.updated(step)
            sequence += 1
    contacts = tuple(_record(contact) for contact in world.contact_log)
    off_pad = distance(world.truth().pose.position[:2], loaded.room.home)
    return judged_outcome(monitor.outcome, contacts, off_pad)


def _record(contact: Contact) -> ContactRecord:
    return ContactRecord(
        at_s=contact.began_at,
        kind=contact.kind.value,
        name=contact.name,
        speed=contact.speed,
        height=contact.height,
        duration_s=contact.ended_at - contact.began_at,
        motors_turned=contact.motors_turned,
    )


def _issued(order: Order, now: float) -> Order:
    return Order(
        order.kind, order.place, order.goal, order.look_at, order.look_s, now, order.sender
    )
