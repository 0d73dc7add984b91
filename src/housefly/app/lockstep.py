"""Flies one service on a stepped clock: the same pilot and world, without wires."""

from __future__ import annotations

from collections.abc import Callable

from housefly.app.loaded_site import LoadedSite
from housefly.app.lockstep_perception import LockstepPerception
from housefly.app.service_monitor import ServiceMonitor
from housefly.messages import Estimate, Inputs, Order, PilotStep
from housefly.pilot.assembly import make_pilot
from housefly.twin.lockstep import LockstepRoom
from housefly.twin.movable import Movable
from housefly.twin.people import load_scene
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
) -> str:
    """Fly one service in lock step and return its outcome ("completed" or the reason).

    Args:
        loaded: site, room and map.
        order: what to fly; it is issued ``_SETTLING_TIME`` after the start.
        on_step: called with every step of the pilot.
        give_up_after: longest world time [s].
        movables: things that no map shows.
        on_world: called before every step of the pilot; may place movables.
    """
    scene = load_scene(loaded.site.twin.scene) if loaded.site.twin.scene else None
    world = SimulatedWorld(loaded.site, loaded.room, scene, movables)
    room = LockstepRoom(world, loaded.site)
    perception = LockstepPerception(loaded, world)
    estimate: Estimate | None = None
    pilot = make_pilot(loaded.site, loaded.room, loaded.grid)
    period = 1.0 / loaded.site.control.rate_hz
    order_at = room.now + _SETTLING_TIME
    monitor = ServiceMonitor(order_at, loaded.room.home, give_up_after)
    sequence, given = 0, False
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
        if given:
            monitor = monitor.updated(step)
        sequence += 1
    return monitor.outcome


def _issued(order: Order, now: float) -> Order:
    return Order(
        order.kind, order.place, order.goal, order.look_at, order.look_s, now, order.sender
    )
