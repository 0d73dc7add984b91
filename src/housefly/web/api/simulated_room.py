"""The simulated room behind the console: what may be done to it, and what came of it.

A room with real hardware has its own hands, and nothing is done there from a page.
"""

from __future__ import annotations

from dataclasses import dataclass

from housefly.bus.bus import Bus
from housefly.bus.simulated_room import (
    SIMULATION_QUERY,
    SimulatedAct,
    SimulatedDeed,
    SimulatedFault,
    SimulatedOutcome,
    act_to_json,
    outcome_from_json,
)
from housefly.errors import HouseflyError
from housefly.messages.words import UNSAID, Words

_TIMEOUT = 3.0
"""How long the simulated room may take to answer [s]."""
_LOOK = SimulatedAct(SimulatedDeed.LOOK)


@dataclass(frozen=True, slots=True)
class SimulationView:
    """The simulated room as a page has it.

    Attributes:
        simulated: whether it is one.
        done: whether something was done just now.
        words: what happens now, or why nothing does.
        faults: those that can be made.
        failing: how many that somebody made are there now.
    """

    simulated: bool
    done: bool = False
    words: Words = UNSAID
    faults: tuple[SimulatedFault, ...] = ()
    failing: int = 0


class SimulatedRoom:
    """Asks the simulated room; all methods block, and are safe from any thread.

    Args:
        bus: where it is.
    """

    def __init__(self, bus: Bus) -> None:
        self._bus = bus

    def view(self) -> SimulationView:
        """Return what can be done."""
        return self.do(_LOOK)

    def do(self, act: SimulatedAct) -> SimulationView:
        """Do something."""
        try:
            text = self._bus.ask(SIMULATION_QUERY, act_to_json(act), _TIMEOUT)
            came = outcome_from_json(text)
        except HouseflyError:
            came = SimulatedOutcome(False, Words("the simulated room does not answer"))
        return SimulationView(True, came.done, came.words, came.faults, came.failing)
