"""Flies one service on a stepped clock: the same pilot and world, without wires."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing, nullcontext
from dataclasses import replace
from pathlib import Path

from housefly.geometry import distance
from housefly.lab.lockstep.service_monitor import ServiceMonitor
from housefly.lab.lockstep.simulation import SETTLING_TIME, Simulation
from housefly.messages import Order, PilotStep
from housefly.record.truth import judged_outcome
from housefly.sites.loaded_site import LoadedSite
from housefly.twin.movable import Movable
from housefly.twin.truth_log import TruthLog
from housefly.twin.world import SimulatedWorld


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
        loaded: site, room and map; of several drones as one has them.
        order: what to fly; it is issued ``SETTLING_TIME`` after the start.
        on_step: called with every step of the pilot.
        give_up_after: longest world time [s].
        movables: things that no map shows.
        on_world: called before every step of the pilot; may place movables.
        truth_file: where the true course of the flight goes, for the summary.

    Raises:
        ConfigError: a fault of the site that cannot be made in lock step.
    """
    simulation = Simulation(loaded, movables)
    world = simulation.world
    order_at = simulation.now + SETTLING_TIME
    monitor = ServiceMonitor(order_at, loaded.room.home, give_up_after)
    given = False
    # Of several drones the one flies whose site this is; the others stand on their pads.
    own = loaded.site.drone.name
    name = own if own in simulation.drones else simulation.drones[0]
    drone = world.drones[name]
    truth = TruthLog(drone, truth_file, lambda: world.now) if truth_file else None
    with closing(truth) if truth else nullcontext():
        while not monitor.outcome:
            simulation.advance()
            on_world(world)
            orders: tuple[Order, ...] = ()
            if not given and simulation.now >= order_at:
                orders, given = (replace(order, issued_at=simulation.now),), True
            step = simulation.step(simulation.inputs(*orders, drone=name), name)
            on_step(step)
            if truth is not None:
                truth.sample()
            if given:
                monitor = monitor.updated(step)
    off_pad = distance(drone.truth().pose.position[:2], loaded.room.home)
    return judged_outcome(monitor.outcome, simulation.contacts(name), off_pad)
