"""The room as it is now, set up as the simulated one of a rehearsal."""

from __future__ import annotations

from dataclasses import replace

from housefly.geometry import distance
from housefly.lab.rehearsal.room_now import RoomNow
from housefly.messages import Obstacle, ObstacleKind
from housefly.pilot.planning.furniture import FURNITURE_SOURCE
from housefly.room.tracked import body_pose_of
from housefly.sites.loaded_site import LoadedSite
from housefly.tasks.execution.task_room import SeenPerson
from housefly.twin.movable import Movable
from housefly.twin.people.script import PersonScript
from housefly.twin.world import SimulatedWorld

_PERSON_HEIGHT = 1.7


class RehearsedStage:
    """People and things of the room as it is now, as bodies of the simulated one."""

    def __init__(self, loaded: LoadedSite, now: RoomNow) -> None:
        site = loaded.site
        self._visitor = any(person.id == site.tracking.visitor for person in now.people)
        self._people = {
            f"person-{number}": person
            for number, person in enumerate(now.people)
            if person.id != site.tracking.visitor
        }
        self.people = tuple(
            PersonScript(name=name, height=_PERSON_HEIGHT, steps=()) for name in self._people
        )
        self.ids = {name: person.id for name, person in self._people.items()}
        pieces = {piece.name: piece for piece in site.furniture if piece.model}
        self._furniture = {
            pieces[one.id].body: body_pose_of(pieces[one.id], one.position, one.yaw)
            for one in now.obstacles
            if one.source == FURNITURE_SOURCE and one.id in pieces
        }
        self._things = {
            f"{number} {one.source} {one.id}"[:100]: one
            for number, one in enumerate(now.obstacles)
            if not (one.source == FURNITURE_SOURCE and one.id in pieces)
            and not _is_one_of(one, now.people)
        }
        self.movables = tuple(
            Movable(name, max(0.05, one.radius + max(one.size) / 2), max(0.1, one.top))
            for name, one in self._things.items()
        )
        self.told = (
            *(replace(one, velocity=(0.0, 0.0), confidence=1.0) for one in self._things.values()),
            *(
                _obstacle_of(name, one, site.people.body_radius)
                for name, one in self._people.items()
            ),
        )
        self._is_set = False

    def set(self, world: SimulatedWorld) -> None:
        """Put everybody and everything where they are, once."""
        if self._is_set:
            return
        self._is_set = True
        world.set_visitor(self._visitor)
        for name, person in self._people.items():
            world.put_person(name, person.position[:2])
        for body, pose in self._furniture.items():
            world.put(body, pose.position[:2], pose.yaw)
        for name, one in self._things.items():
            world.put(name, one.position, one.yaw)


def _is_one_of(obstacle: Obstacle, people: tuple[SeenPerson, ...]) -> bool:
    return any(distance(obstacle.position, person.position[:2]) < 0.5 for person in people)


def _obstacle_of(name: str, person: SeenPerson, radius: float) -> Obstacle:
    return Obstacle(name, person.position[:2], radius, source="people", kind=ObstacleKind.PERSON)
