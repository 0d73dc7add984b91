"""The simulated room with a pilot for each of its drones, for a loop of one's own."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from housefly.lab.lockstep.lockstep_perception import LockstepPerception
from housefly.lab.lockstep.lockstep_room import LockstepRoom, advance_together
from housefly.lab.lockstep.pilot_loop import PilotLoop
from housefly.lab.lockstep.shared_tracking import SharedTracking
from housefly.messages import Estimate, Inputs, Obstacle, Order, PilotStep
from housefly.pilot.assembly import make_pilot
from housefly.pilot.pilot import Pilot
from housefly.record.truth import ContactRecord
from housefly.sites.loaded_site import LoadedSite, open_site
from housefly.twin.contact_log import Contact
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
    """The simulated room and its pilots on a stepped clock.

    One round is ``advance``, then ``inputs`` and ``step`` of each drone. In between, the world can
    be changed, and so can what a pilot is given; no round is skipped. What names no drone is about
    the first.

    Args:
        loaded: site, room and map.
        movables: things that no map shows.
        people: people without a scene.
        scene: who moves how; None plays the site's own scene.
        origin_known: tracking and map were found to agree: the drones may begin off their pads.
        intruders: whether faults injected later may put people and things in the way.
        guarded: False flies without what keeps a flight safe, to show that a fault does harm.

    Attributes:
        world: the simulated room, its visitor and its movable things.
        drones: names of those that fly, in the order of the site.
        loaded: site, room and map as each drone's chain sees them, by its name.
        people: names of those with a body of their own, in the order of the world's.
        period: of the pilots' steps [s].

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
        self.loaded = sites_of_drones(loaded)
        self.drones = tuple(self.loaded)
        faults = {
            name: FaultInjector(own.site, intruders=intruders) for name, own in self.loaded.items()
        }
        added = tuple(one for one in faults.values() if one.movables)[:1]
        movables = (*movables, *(thing for one in added for thing in one.movables))
        people = (*people, *(person for one in added for person in one.people))
        self.world = SimulatedWorld(site, loaded.room, scene, movables, people)
        self.people = tuple(
            one.name
            for one in (*(scene.script.people if scene else ()), *people)
            if not one.visitor
        )
        tracking = SharedTracking(self.world, tuple(faults.values()), len(faults))
        self._loops = {
            name: self._loop_of(name, faults[name], (tracking, number), guarded=guarded)
            for number, name in enumerate(self.drones)
        }
        self._first = self.drones[0]
        self.period = self._loops[self._first].period
        self._perception = LockstepPerception(loaded, self.world, faults[self._first])
        self._unseen: dict[str, tuple[Obstacle, ...]] = dict.fromkeys(self.drones, ())
        self._origin_known = origin_known
        self._estimates: dict[str, Estimate | None] = dict.fromkeys(self.drones)

    def _loop_of(
        self,
        name: str,
        faults: FaultInjector,
        tracking: tuple[SharedTracking, int],
        *,
        guarded: bool,
    ) -> PilotLoop:
        own, drone = self.loaded[name], self.world.drones[name]
        room = LockstepRoom(
            self.world, own.site, faults, guarded=guarded, drone=drone, tracking=tracking
        )
        pilot = make_pilot(own.site, own.room, own.grid, guarded=guarded)
        return PilotLoop(room, pilot, own.site.control.rate_hz)

    @property
    def now(self) -> float:
        """World time [s]."""
        return self.world.now

    def is_ready(self, drone: str) -> bool:
        """Return whether the pilot of a drone may take off, as of its last step."""
        checks = self._loops[drone].pilot.preflight()
        return bool(checks) and all(one.passed or not one.required for one in checks)

    @property
    def pilot(self) -> Pilot:
        """The pilot that ``step`` asks for the first drone; another may be put in its place."""
        return self._loops[self._first].pilot

    @pilot.setter
    def pilot(self, pilot: Pilot) -> None:
        self._loops[self._first].pilot = pilot

    def inject(self, *faults: str | Fault) -> None:
        """Let faults happen, too: ``simulation.inject("mocap:off@20s+1s")``.

        Raises ConfigError for one that cannot be read or not be made here.
        """
        for fault in faults:
            parsed = parse_fault(fault) if isinstance(fault, str) else (fault,)
            for loop in self._loops.values():
                loop.room.inject(*parsed)

    def advance(self) -> None:
        """Let the world run for one period of the pilots."""
        advance_together([loop.room for loop in self._loops.values()], self.period)

    def inputs(
        self, *orders: Order, obstacles: tuple[Obstacle, ...] = (), drone: str = ""
    ) -> Inputs:
        """Return what a pilot is told now.

        Args:
            orders: those that name no time count as given now.
            obstacles: seen now, besides those that the site's own sensors see.
            drone: whose pilot; "" for the first.
        """
        name = drone or self._first
        told = self._loops[name].inputs(*orders)
        fresh = self._perception.update(self.now, self._estimates.values())
        self._unseen = {one: (*unseen, *fresh) for one, unseen in self._unseen.items()}
        seen, self._unseen[name] = self._unseen[name], ()
        return replace(
            told,
            obstacles=(*seen, *obstacles),
            origin_known=self._origin_known,
            people_seen_at=self._perception.people_seen_at,
        )

    def step(self, inputs: Inputs, drone: str = "") -> PilotStep:
        """Let a pilot decide, and hand its command to its drone; "" is the first."""
        name = drone or self._first
        step = self._loops[name].step(inputs)
        self._estimates[name] = step.outputs.estimate
        return step

    def contacts(self, drone: str = "") -> tuple[ContactRecord, ...]:
        """Return what a drone touched so far, other than the floor; "" is the first."""
        return contact_records(self.world.drones[drone or self._first].contact_log)


def sites_of_drones(loaded: LoadedSite) -> Mapping[str, LoadedSite]:
    """Return the site as each drone's own chain sees it, by name, in the order of the site."""
    if not loaded.site.drones:
        return {loaded.site.drone.name: loaded}
    names = loaded.site.drone_names or (loaded.site.all_drones[0].name,)
    return {name: open_site(loaded.site.for_drone(name)) for name in names}


def contact_records(contacts: tuple[Contact, ...]) -> tuple[ContactRecord, ...]:
    """Return contacts as a recording keeps them."""
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
        for contact in contacts
    )
