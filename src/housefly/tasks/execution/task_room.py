"""What a running task may ask about the room while it flies."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol

from housefly.geometry import Vec2, Vec3
from housefly.hub.api.questions import Question
from housefly.tasks.vantage.viewpoint import Viewpoint


@dataclass(frozen=True, slots=True)
class SeenPerson:
    """A person where sensors see them now: world position [m], velocity xy [m/s], age [s]."""

    id: str
    position: Vec3
    velocity: Vec2
    age: float


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

    def round_names(self) -> tuple[str, ...]:
        """Return what a round looks at: named places, or else viewpoints that see the floor."""
        ...
