"""The room as a task sees it in lock step: people as they truly are, memory as it is given."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from housefly.errors import LinkError
from housefly.geometry import Vec2, Vec3, rotate
from housefly.hub.api.questions import Question
from housefly.messages import Obstacle, Pose
from housefly.sites.loaded_site import LoadedSite
from housefly.tasks.execution.task_room import SeenPerson
from housefly.tasks.vantage.named_search import search_for
from housefly.tasks.vantage.named_subject import round_names, view_from, viewpoint_of
from housefly.tasks.vantage.patrol import shown_share
from housefly.tasks.vantage.thing_search import ThingSearch
from housefly.tasks.vantage.viewing_room import ViewingRoom
from housefly.tasks.vantage.viewpoint import Viewpoint
from housefly.twin.contracts import AWAY_Z
from housefly.twin.world import SimulatedWorld

_HALF_BODY = 0.8
"""From the feet to the middle of a body [m]."""
_VELOCITY_TIME = 0.5
"""Velocities of people are measured over this time [s]."""


class LockstepTaskRoom:
    """Answers a task that is flown in lock step.

    Args:
        loaded: site, room and map.
        world: what is true.
        names: of the world's people, in its order.
        ask: of the room's memory; None remembers nothing.
        viewing: the same room, when it was prepared before.

    Attributes:
        obstacles: what no map shows, told from outside.
    """

    def __init__(
        self,
        loaded: LoadedSite,
        world: SimulatedWorld,
        names: tuple[str, ...],
        ask: Callable[[Question], Any] | None = None,
        viewing: ViewingRoom | None = None,
    ) -> None:
        self._world, self._names = world, names
        self._visitor = loaded.site.tracking.visitor
        self._door = loaded.room.visitor
        self._ask = ask or _nobody
        self._viewing = viewing or ViewingRoom(loaded.site, loaded.room, loaded.grid)
        self._before: tuple[float, dict[str, Vec3]] = (world.now, self._places())
        self._now = self._before
        self.obstacles: tuple[Obstacle, ...] = ()

    def look(self) -> None:
        """Note where everybody is, for their velocities; call it at every tick."""
        if self._world.now - self._now[0] >= _VELOCITY_TIME:
            self._before, self._now = self._now, (self._world.now, self._places())

    def ask(self, question: Question) -> Any:
        """Return the memory's answer; raises ThingError, or LinkError without a memory."""
        return self._ask(question)

    def people(self) -> tuple[SeenPerson, ...]:
        """Return who is really there."""
        (then, before), (at, _) = self._before, self._now
        lasted = max(self._world.now - then, 1e-6)
        found = []
        for name, place in self._places().items():
            x, y, _ = before.get(name, place)
            moved = at > then
            velocity = ((place[0] - x) / lasted, (place[1] - y) / lasted) if moved else (0.0, 0.0)
            found.append(SeenPerson(name, place, velocity, 0.0))
        return tuple(found)

    def viewpoint(self, subject: str, drone: Vec3 | None = None) -> Viewpoint:
        """Return where to hover to see a place, a thing or a person; raises TaskError."""
        now, people = self._world.now, self.people()
        return viewpoint_of(subject, self._viewing, self.ask, people, drone, self.obstacles, now)

    def view_from(self, subject: str, place: Vec2) -> Viewpoint | None:
        """Return the viewpoint at a place [m] itself if it shows a subject well, else None."""
        now, people = self._world.now, self.people()
        return view_from(subject, self._viewing, self.ask, place, people, self.obstacles, now)

    def round_names(self, *, whole: bool = False) -> tuple[str, ...]:
        """Return what a round looks at: named places, or else viewpoints that see the floor."""
        return round_names(self._viewing, whole=whole)

    def shown_share(self, poses: tuple[tuple[Vec2, float], ...]) -> float:
        """Return the share of the floor that pictures from poses showed, [m] and [rad]."""
        return shown_share(poses, self._viewing)

    def search(self, thing: str, drone: Vec3 | None, look_time: float) -> ThingSearch:
        """Return a search for a lost thing; raises TaskError."""
        now, people = self._world.now, self.people()
        return search_for(
            thing, self._viewing, self.ask, people, drone, self.obstacles, now, look_time
        )

    def _places(self) -> dict[str, Vec3]:
        """Return where everybody stands, world [m]; feet at height 0."""
        poses: dict[str, Pose] = dict(zip(self._names, self._world.people(), strict=True))
        there = {name: _place(pose) for name, pose in poses.items() if _is_there(pose)}
        if self._world.visitor_present and self._door is not None:
            there[self._visitor] = (*self._door, 0.0)
        return there


def _is_there(pose: Pose) -> bool:
    return pose.position[2] > AWAY_Z / 2


def _place(pose: Pose) -> Vec3:
    """Return where somebody is: the feet of who stands or sits, the middle of who lies [m]."""
    ahead, left, up = rotate(pose.orientation, (0.0, 0.0, _HALF_BODY))
    x, y, z = pose.position
    return x + ahead, y + left, z if up < _HALF_BODY / 2 else 0.0


def _nobody(question: Question) -> Any:
    raise LinkError("nobody remembers anything here")
