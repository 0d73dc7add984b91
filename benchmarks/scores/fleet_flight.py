"""Flies a service with each of several drones at once, on a stepped clock, in one room."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from math import inf

from housefly.geometry import distance
from housefly.lab.lockstep.service_monitor import ServiceMonitor
from housefly.lab.lockstep.simulation import SETTLING_TIME, Simulation
from housefly.messages import Inputs, Order, PilotStep
from housefly.record.truth import ContactRecord, judged_outcome

WAITING_MAX = 60.0
"""A service waits for its drone to be ready at most so long [s]."""
_LOOK_PERIOD = 0.05
"""How often the distances between drones are looked at [s]."""


@dataclass(frozen=True, slots=True)
class FlownService:
    """What became of the service of one drone.

    Attributes:
        outcome: "completed", or why not.
        duration: from the order to the landing [s].
        contacts: what it touched other than the floor, in order of time.
        nearest_drone: smallest true distance from its hull to another's while both flew [m];
            infinite where they did not.
        nearest_person: likewise to a person while it flew [m].
    """

    outcome: str
    duration: float
    contacts: tuple[ContactRecord, ...]
    nearest_drone: float
    nearest_person: float


def fly_services_lockstep(
    simulation: Simulation,
    orders: Mapping[str, Order],
    *,
    after: Mapping[str, float] | None = None,
    give_up_after: float = 240.0,
    hear: Callable[[str, Inputs], Inputs] = lambda drone, inputs: inputs,
    on_step: Callable[[str, PilotStep], None] = lambda drone, step: None,
) -> dict[str, FlownService]:
    """Fly the services that are ordered, and return what became of each, by the drone's name.

    Drones without an order stay on their pads.

    Args:
        simulation: at its beginning.
        orders: what each drone flies.
        after: how long after ``SETTLING_TIME`` each is ordered [s]; at once where it is left out.
        give_up_after: longest world time of each [s].
        hear: what the pilot of a drone hears in place of what it should.
        on_step: called with every step of every pilot.
    """
    after = after or {}
    flights = {
        name: _Flight(simulation, name, order, SETTLING_TIME + after.get(name, 0.0), give_up_after)
        for name, order in orders.items()
    }
    look_at = 0.0
    while not all(flight.monitor.outcome for flight in flights.values()):
        simulation.advance()
        for name in simulation.drones:
            flight = flights.get(name)
            told = flight.orders() if flight else ()
            inputs = hear(name, simulation.inputs(*told, drone=name))
            step = simulation.step(inputs, name)
            on_step(name, step)
            if flight:
                flight.take(step)
        if simulation.now >= look_at:
            look_at = simulation.now + _LOOK_PERIOD
            for flight in flights.values():
                flight.look()
    return {name: flight.result() for name, flight in flights.items()}


def without_others(simulation: Simulation) -> Callable[[str, Inputs], Inputs]:
    """Return what takes the other drones away from what a pilot hears: the negative control."""
    bodies = {name: own.site.tracking.body for name, own in simulation.loaded.items()}

    def hear(drone: str, inputs: Inputs) -> Inputs:
        others = {body for name, body in bodies.items() if name != drone}
        seen = tuple(one for one in inputs.sightings if one.body not in others)
        return replace(inputs, sightings=seen)

    return hear


class _Flight:
    """The service of one drone, as seen so far."""

    def __init__(
        self,
        simulation: Simulation,
        name: str,
        order: Order,
        begin: float,
        give_up_after: float,
    ) -> None:
        self._simulation, self._name, self._order, self._begin = simulation, name, order, begin
        self._home = simulation.loaded[name].room.home
        self._drone = simulation.world.drones[name]
        self.monitor = ServiceMonitor(begin, self._home, give_up_after)
        self._given = False
        self._ended = inf
        self._nearest_drone = self._nearest_person = inf

    def orders(self) -> tuple[Order, ...]:
        """Return what its pilot is ordered now."""
        now = self._simulation.now
        if self._given or now < self._begin or not self._may_begin():
            return ()
        self._given = True
        self.monitor = replace(self.monitor, started_at=now)
        return (replace(self._order, issued_at=now),)

    def _may_begin(self) -> bool:
        """Wait for a drone that is ready, as the tasks do, but not for ever."""
        has_waited = self._simulation.now > self._begin + WAITING_MAX
        return has_waited or self._simulation.is_ready(self._name)

    def take(self, step: PilotStep) -> None:
        """Follow the service by a step of its pilot."""
        if self._given and not self.monitor.outcome:
            self.monitor = self.monitor.updated(step)
            self._ended = step.now

    def look(self) -> None:
        """Note how near the drone really is to others and to people while it flies."""
        if not self._drone.onboard().flight.airborne:
            return
        clear = self._drone.clearance()
        self._nearest_person = min(self._nearest_person, clear.person)
        others = (one for name, one in self._simulation.world.drones.items() if name != self._name)
        if any(other.onboard().flight.airborne for other in others):
            self._nearest_drone = min(self._nearest_drone, clear.drone)

    def result(self) -> FlownService:
        """Return what became of it, in truth."""
        contacts = self._simulation.contacts(self._name)
        off_pad = distance(self._drone.truth().pose.position[:2], self._home)
        return FlownService(
            judged_outcome(self.monitor.outcome, contacts, off_pad),
            self._ended - self._begin,
            contacts,
            self._nearest_drone,
            self._nearest_person,
        )
