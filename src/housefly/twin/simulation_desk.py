"""What a person at the page does to the simulated room: hands, a charger, a walker, faults.

Pilot and drivers learn of it by their wires only, as they would in a real room.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from housefly.bus.simulated_room import (
    SimulatedAct,
    SimulatedDeed,
    SimulatedFault,
    SimulatedOutcome,
)
from housefly.errors import ConfigError, WireError
from housefly.messages.words import Words, error_words, figure
from housefly.twin.faults.fault import Fault
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.faults.told_rows import TOLD_ROWS, told_fault
from housefly.twin.faults.vocabulary import FaultComponent, FaultKind
from housefly.twin.world import SimulatedWorld

_WALK_SPEED, _WALK_TIME = 0.8, 30.0
"""How fast somebody walks through the room [m/s], and after how long they are gone [s]."""
_FAULTS = tuple(SimulatedFault(row, words) for row, words in TOLD_ROWS.items())


class SimulationDesk:
    """Does what is asked; all calls belong to the thread of the world.

    Args:
        world: the simulated room.
        faults: what befalls its drones, by their names.
        told: is told each thing that was done, for the log.
    """

    def __init__(
        self,
        world: SimulatedWorld,
        faults: Mapping[str, FaultInjector],
        told: Callable[[str], None] = lambda line: None,
    ) -> None:
        self._world, self._faults, self._told = world, faults, told
        self._made: tuple[Fault, ...] = ()
        self._deeds: dict[SimulatedDeed, Callable[[SimulatedAct, str], Words]] = {
            SimulatedDeed.LOOK: lambda act, drone: Words("this room is simulated"),
            SimulatedDeed.PUT_BACK: self._put_back,
            SimulatedDeed.CHARGE: self._charge,
            SimulatedDeed.WALK: self._walk,
            SimulatedDeed.FAULT: self._fail,
            SimulatedDeed.MEND: self._mend,
        }

    def do(self, act: SimulatedAct) -> SimulatedOutcome:
        """Do something, and say what happens now, or why nothing does."""
        drone = act.drone or next(iter(self._world.drones))
        done = True
        try:
            if drone not in self._world.drones:
                raise WireError(Words("there is no drone called {name}", name=drone))
            words = self._deeds[act.deed](act, drone)
        except (ConfigError, WireError) as error:
            done, words = False, error_words(error)
        if act.deed is not SimulatedDeed.LOOK:
            self._told(f"{act.deed.value}: {words}")
        return SimulatedOutcome(done, words, _FAULTS, len(self._failing()))

    def _put_back(self, act: SimulatedAct, drone: str) -> Words:
        self._world.drones[drone].put_back()
        return Words("somebody carries the drone to its pad")

    def _charge(self, act: SimulatedAct, drone: str) -> Words:
        self._world.drones[drone].charge()
        return Words("the drone has a full battery")

    def _walk(self, act: SimulatedAct, drone: str) -> Words:
        walk = Fault(
            FaultComponent.PEOPLE, FaultKind.WRONG, "walking", self._world.now, _WALK_TIME,
            _WALK_SPEED, drone=drone,
        )  # fmt: skip
        self._faults[drone].inject(walk)
        return Words("somebody walks up to the drone, and leaves after {n} s", n=figure(_WALK_TIME))

    def _fail(self, act: SimulatedAct, drone: str) -> Words:
        faults = told_fault(act.fault, drone, self._world.now, act.seconds)
        for injector in self._faults.values():
            injector.inject(*faults)
        self._made = (*self._failing(), *faults)
        return Words("{what}, for {n} s", what=TOLD_ROWS[act.fault], n=figure(act.seconds, "g"))

    def _mend(self, act: SimulatedAct, drone: str) -> Words:
        failing = self._failing()
        for injector in self._faults.values():
            injector.withdraw(failing, self._world.now)
        self._made = ()
        return Words("the faults that were made are over")

    def _failing(self) -> tuple[Fault, ...]:
        """Return the faults that a person made and that are not over."""
        return tuple(fault for fault in self._made if self._world.now < fault.end)
