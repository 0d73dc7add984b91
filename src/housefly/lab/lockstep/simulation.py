"""The simulated room with a pilot in it, for a loop of one's own."""

from __future__ import annotations

from dataclasses import replace

from housefly.lab.lockstep.lockstep_perception import LockstepPerception
from housefly.lab.lockstep.lockstep_room import LockstepRoom
from housefly.lab.lockstep.pilot_loop import PilotLoop
from housefly.messages import Estimate, Inputs, Obstacle, Order, PilotStep
from housefly.pilot.assembly import make_pilot
from housefly.pilot.pilot import Pilot
from housefly.record.truth import ContactRecord
from housefly.sites.loaded_site import LoadedSite
from housefly.twin.faults.fault import Fault
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.faults.parse import parse_fault
from housefly.twin.movable import Movable
from housefly.twin.people import Scene, load_scene
from housefly.twin.people.script import PersonScript
from housefly.twin.world import SimulatedWorld

SETTLING_TIME = 0.5
"""World time before the first order, so that tracking and telemetry are there [s]."""


class Simulation:
    """The simulated room and its pilot on a stepped clock.

    One round is ``advance``, ``inputs``, ``step``. In between, the world can be changed, and so can
    what the pilot is given; no round is skipped.

    Args:
        loaded: site, room and map.
        movables: things that no map shows.
        people: people without a scene.
        scene: who moves how; None plays the site's own scene.
        origin_known: tracking and map were found to agree: the drone may begin off its pad.
        intruders: whether faults injected later may put people and things in the way.
        guarded: False flies without what keeps a flight safe, to show that a fault does harm.

    Attributes:
        world: the simulated room, its visitor and its movable things.
        people: names of those with a body of their own, in the order of the world's.
        period: of the pilot's steps [s].

    Raises:
        ConfigError: a fault of the site that cannot be made in lock step.
    """

    def __init__(
        self,
        loaded: LoadedSite,
        movables: tuple[Movable, ...] = (),
        people: tuple[PersonScript, ...] = (),
        scene: Scene | None = None,
        *,
        origin_known: bool = False,
        intruders: bool = False,
        guarded: bool = True,
    ) -> None:
        site = loaded.site
        if scene is None and site.twin.scene:
            scene = load_scene(site.twin.scene)
        faults = FaultInjector(site, intruders=intruders)
        self.world = SimulatedWorld(
            site, loaded.room, scene, (*movables, *faults.movables), (*people, *faults.people)
        )
        self.people = tuple(
            one.name
            for one in (*(scene.script.people if scene else ()), *people, *faults.people)
            if not one.visitor
        )
        room = LockstepRoom(self.world, site, faults, guarded=guarded)
        pilot = make_pilot(site, loaded.room, loaded.grid, guarded=guarded)
        self._loop = PilotLoop(room, pilot, site.control.rate_hz)
        self.period = self._loop.period
        self._perception = LockstepPerception(loaded, self.world, faults)
        self._origin_known = origin_known
        self._estimate: Estimate | None = None

    @property
    def now(self) -> float:
        """World time [s]."""
        return self._loop.now

    @property
    def pilot(self) -> Pilot:
        """The pilot that ``step`` asks; another may be put in its place."""
        return self._loop.pilot

    @pilot.setter
    def pilot(self, pilot: Pilot) -> None:
        self._loop.pilot = pilot

    def inject(self, *faults: str | Fault) -> None:
        """Let faults happen, too: ``simulation.inject("mocap:off@20s+1s")``.

        Raises ConfigError for one that cannot be read or not be made here.
        """
        for fault in faults:
            parsed = parse_fault(fault) if isinstance(fault, str) else (fault,)
            self._loop.room.inject(*parsed)

    def advance(self) -> None:
        """Let the world run for one period of the pilot."""
        self._loop.advance()

    def inputs(self, *orders: Order, obstacles: tuple[Obstacle, ...] = ()) -> Inputs:
        """Return what the pilot is told now.

        Args:
            orders: those that name no time count as given now.
            obstacles: seen now, besides those that the site's own sensors see.
        """
        told = self._loop.inputs(*orders)
        seen = self._perception.update(self.now, self._estimate)
        return replace(
            told,
            obstacles=(*seen, *obstacles),
            origin_known=self._origin_known,
            people_seen_at=self._perception.people_seen_at,
        )

    def step(self, inputs: Inputs) -> PilotStep:
        """Let the pilot decide, and hand its command to the drone."""
        step = self._loop.step(inputs)
        self._estimate = step.outputs.estimate
        return step

    def contacts(self) -> tuple[ContactRecord, ...]:
        """Return what the drone touched so far, other than the floor."""
        return tuple(
            ContactRecord(
                at_s=contact.began_at,
                kind=contact.kind.value,
                name=contact.name,
                speed=contact.speed,
                height=contact.height,
                duration_s=contact.ended_at - contact.began_at,
                motors_turned=contact.motors_turned,
            )
            for contact in self.world.contact_log
        )
