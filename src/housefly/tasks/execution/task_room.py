"""What a running task may ask about the room while it flies."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import Any, Protocol

from housefly.geometry import Vec2, Vec3
from housefly.hub.api.questions import Question
from housefly.tasks.vantage.thing_search import SearchLook, SearchSummary
from housefly.tasks.vantage.viewpoint import Viewpoint


@dataclass(frozen=True, slots=True)
class SeenPerson:
    """A person where sensors see them now: world position [m], velocity xy [m/s], age [s]."""

    id: str
    position: Vec3
    velocity: Vec2
    age: float


class SearchPlan(Protocol):
    """The looks of one search for one thing, planned anew after each: ``ThingSearch``."""

    def looks(
        self, drone: Vec3 | None = None, least: float = 0.03, budget: float = inf
    ) -> tuple[SearchLook, ...]:
        """Return the looks that are still worth a flight, in the order that finds it soonest."""
        ...

    def was_shown(self, look: SearchLook, *, nothing: bool) -> None:
        """Note that a picture was taken, and whether somebody saw nothing in it."""
        ...

    def leave_out(self, look: SearchLook) -> None:
        """Note that the drone cannot get to where a look is flown from."""
        ...

    def summary(self) -> SearchSummary:
        """Return what was looked at, and what was not."""
        ...


class TaskRoom(Protocol):
    """The room as a task sees it: live beside a pilot, simulated in a rehearsal."""

    def ask(self, question: Question) -> Any:
        """Return the memory's answer.

        Raises:
            ThingError: there is no such thing.
            LinkError: nobody remembers anything here.
        """
        ...

    def people(self) -> tuple[SeenPerson, ...]:
        """Return who is seen now."""
        ...

    def viewpoint(self, subject: str, drone: Vec3 | None = None) -> Viewpoint:
        """Return where to hover to see a place, a thing or a person.

        Args:
            subject: name of a place, or name, alias or id of a thing or person.
            drone: where the drone is; of equal viewpoints the nearer one is taken [m].

        Raises:
            TaskError: UNKNOWN_PLACE, UNKNOWN_THING or NO_VIEW, in one sentence.
        """
        ...

    def view_from(self, subject: str, place: Vec2) -> Viewpoint | None:
        """Return the viewpoint at a place [m] itself if it shows a subject well, else None.

        Raises:
            TaskError: as ``viewpoint``.
        """
        ...

    def round_names(self, *, whole: bool = False) -> tuple[str, ...]:
        """Return what a round looks at: named places, or else viewpoints that see the floor.

        With ``whole`` they are viewpoints that together see all of the floor.
        """
        ...

    def shown_share(self, poses: tuple[tuple[Vec2, float], ...]) -> float:
        """Return the share of the floor that pictures showed, of what can be seen at all.

        Args:
            poses: of the drone at each picture: world xy [m], heading [rad].
        """
        ...

    def search(self, thing: str, drone: Vec3 | None, look_time: float) -> SearchPlan:
        """Return a search for a lost thing.

        Args:
            thing: name, alias or id.
            drone: where the drone is [m]; None is at home.
            look_time: what each look takes beside the way to it [s].

        Raises:
            TaskError: BAD_PARAMETER for what is no thing that gets lost.
        """
        ...
