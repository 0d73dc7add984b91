"""The simulated room with a pilot in it, for a loop of one's own."""

from __future__ import annotations

from dataclasses import replace

from housefly.lab.lockstep.lockstep_perception import LockstepPerception
from housefly.lab.lockstep.lockstep_room import LockstepRoom
from housefly.messages import Estimate, Inputs, Order, PilotStep
from housefly.pilot.assembly import make_pilot
from housefly.sites.loaded_site import LoadedSite
from housefly.twin.faults.fault import Fault
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.faults.parse import parse_fault
from housefly.twin.movable import Movable
from housefly.twin.people import load_scene
from housefly.twin.world import SimulatedWorld


class Simulation:
    """The simulated room and its pilot on a stepped clock.

    One round is ``advance``, ``inputs``, ``step``. In between, the world can be changed, and so can
    what the pilot is given; no round is skipped.

    Args:
        loaded: site, room and map.
        movables: things that no map shows.
        intruders: whether faults injected later may put people and things in the way.
        guarded: False flies without what keeps a flight safe, to show that a fault does harm.

    Attributes:
        world: the simulated room, its visitor and its movable things.
        pilot: the pilot that ``step`` asks.
    """

    def __init__(
        self,
        loaded: LoadedSite,
        movables: tuple[Movable, ...] = (),
        *,
        intruders: bool = False,
        guarded: bool = True,
    ) -> None:
        site = loaded.site
        scene = load_scene(site.twin.scene) if site.twin.scene else None
        faults = FaultInjector(site, intruders=intruders)
        self.world = SimulatedWorld(
            site, loaded.room, scene, (*movables, *faults.movables), faults.people
        )
        self.pilot = make_pilot(site, loaded.room, loaded.grid, guarded=guarded)
        self._room = LockstepRoom(self.world, site, faults, guarded=guarded)
        self._perception = LockstepPerception(loaded, self.world, faults)
        self._period = 1.0 / site.control.rate_hz
        self._estimate: Estimate | None = None
        self._sequence = 0

    @property
    def now(self) -> float:
        """World time [s]."""
        return self._room.now

    def inject(self, *faults: str | Fault) -> None:
        """Let faults happen, too: ``simulation.inject("mocap:off@20s+1s")``.

        Raises ConfigError for one that cannot be read or not be made here.
        """
        for fault in faults:
            self._room.inject(*(parse_fault(fault) if isinstance(fault, str) else (fault,)))

    def advance(self) -> None:
        """Let the world run for one period of the pilot."""
        self._room.advance(self._period)

    def inputs(self, *orders: Order) -> Inputs:
        """Return what the pilot is told now; the orders count as given now."""
        return Inputs(
            self._room.sightings(),
            self._room.telemetry(),
            tuple(replace(order, issued_at=self.now) for order in orders),
            self._perception.update(self.now, self._estimate),
            people_seen_at=self._perception.people_seen_at,
        )

    def step(self, inputs: Inputs) -> PilotStep:
        """Let the pilot decide, and hand its command to the drone."""
        outputs = self.pilot.step(self.now, inputs)
        self._estimate = outputs.estimate
        self._room.send(outputs.command, self.pilot.known_motion)
        step = PilotStep(self._sequence, self.now, inputs, outputs)
        self._sequence += 1
        return step
