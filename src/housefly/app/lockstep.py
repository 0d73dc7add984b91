"""A whole service on a stepped clock: the same pilot and the same world, the wires cut out."""

from __future__ import annotations

from collections.abc import Callable

from housefly.app.lookers import LockstepLookers
from housefly.app.premises import Premises
from housefly.app.service_watch import ServiceWatch
from housefly.messages import Estimate, Inputs, Order, PilotStep
from housefly.pilot.pilot import Pilot
from housefly.twin.lockstep import LockstepRoom
from housefly.twin.movable import Movable
from housefly.twin.people import load_scene
from housefly.twin.world import SimulatedWorld

SETTLE = 0.5
"""World time before the order is given, so that tracking and telemetry are there [s]."""


def fly_lockstep(
    premises: Premises,
    order: Order,
    on_step: Callable[[PilotStep], None],
    give_up_after: float = 240.0,
    movables: tuple[Movable, ...] = (),
    on_world: Callable[[SimulatedWorld], None] = lambda world: None,
) -> str:
    """Fly one service in lock step and return its outcome ("completed" or the reason).

    Args:
        premises: site, room and map.
        order: what to fly; it is issued ``SETTLE`` seconds after the start.
        on_step: called with every step of the pilot.
        give_up_after: longest world time [s].
        movables: things that no map shows.
        on_world: called before every step of the pilot; may put movables somewhere.
    """
    scene = load_scene(premises.site.twin.scene) if premises.site.twin.scene else None
    world = SimulatedWorld(premises.site, premises.room, scene, movables)
    room = LockstepRoom(world, premises.site)
    lookers = LockstepLookers(premises, world)
    estimate: Estimate | None = None
    pilot = Pilot(premises.site, premises.room, premises.grid)
    period = 1.0 / premises.site.control.rate_hz
    order_at = room.now + SETTLE
    watch = ServiceWatch(order_at, premises.room.home, give_up_after)
    sequence, given = 0, False
    while not watch.outcome:
        room.advance(period)
        on_world(world)
        orders: tuple[Order, ...] = ()
        if not given and room.now >= order_at:
            orders, given = (_issued(order, room.now),), True
        inputs = Inputs(
            room.sightings(), room.telemetry(), orders, lookers.look(room.now, estimate)
        )
        outputs = pilot.step(room.now, inputs)
        estimate = outputs.estimate
        room.send(outputs.command)
        step = PilotStep(sequence, room.now, inputs, outputs)
        on_step(step)
        if given:
            watch = watch.after(step)
        sequence += 1
    return watch.outcome


def _issued(order: Order, now: float) -> Order:
    return Order(
        order.kind, order.place, order.goal, order.look_at, order.look_s, now, order.sender
    )
