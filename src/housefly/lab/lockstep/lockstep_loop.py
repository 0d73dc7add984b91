"""World, driver, perception and pilot on one stepped clock, one control period at a time."""

from __future__ import annotations

from housefly.lab.lockstep.lockstep_perception import LockstepPerception
from housefly.lab.lockstep.lockstep_room import LockstepRoom
from housefly.messages import Estimate, Inputs, Obstacle, Order, PilotStep
from housefly.pilot.assembly import make_pilot
from housefly.record.truth import ContactRecord
from housefly.sites.loaded_site import LoadedSite
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.movable import Movable
from housefly.twin.people import Scene, load_scene
from housefly.twin.people.script import PersonScript
from housefly.twin.world import SimulatedWorld

SETTLING_TIME = 0.5
"""World time before the first order, so that tracking and telemetry are there [s]."""


class LockstepLoop:
    """The very pilot of a site in its simulated room.

    Args:
        loaded: site, room and map.
        movables: things that no map shows.
        people: people without a scene.
        scene: who moves how; None plays the site's own scene.
        origin_known: tracking and map were found to agree: the drone may begin off its pad.

    Attributes:
        world: the simulated room.
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
    ) -> None:
        site = loaded.site
        if scene is None and site.twin.scene:
            scene = load_scene(site.twin.scene)
        faults = FaultInjector(site)
        self.world = SimulatedWorld(
            site, loaded.room, scene, (*movables, *faults.movables), (*people, *faults.people)
        )
        self.people = tuple(
            one.name
            for one in (*(scene.script.people if scene else ()), *people, *faults.people)
            if not one.visitor
        )
        self.period = 1.0 / site.control.rate_hz
        self._room = LockstepRoom(self.world, site, faults)
        self._perception = LockstepPerception(loaded, self.world, faults)
        self._pilot = make_pilot(site, loaded.room, loaded.grid)
        self._origin_known = origin_known
        self._estimate: Estimate | None = None
        self._sequence = 0

    @property
    def now(self) -> float:
        """World time [s]."""
        return self._room.now

    def advance(self) -> None:
        """Let the world run for one control period."""
        self._room.advance(self.period)

    def step(
        self, orders: tuple[Order, ...] = (), obstacles: tuple[Obstacle, ...] = ()
    ) -> PilotStep:
        """Step the pilot and hand its command to the drone; return the whole step.

        Args:
            orders: given now.
            obstacles: seen now, besides those that the site's own sensors see.
        """
        now = self.now
        seen = self._perception.update(now, self._estimate)
        inputs = Inputs(
            self._room.sightings(),
            self._room.telemetry(),
            orders,
            (*seen, *obstacles),
            origin_known=self._origin_known,
            people_seen_at=self._perception.people_seen_at,
        )
        outputs = self._pilot.step(now, inputs)
        self._estimate = outputs.estimate
        self._room.send(outputs.command, self._pilot.known_motion)
        step = PilotStep(self._sequence, now, inputs, outputs)
        self._sequence += 1
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
