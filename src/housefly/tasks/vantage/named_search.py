"""From the name of a lost thing to a search for it."""

from __future__ import annotations

from collections.abc import Iterable

from housefly.errors import LinkError, TaskError, ThingError
from housefly.geometry import Vec3
from housefly.hub.api.answers import WhereAnswer
from housefly.hub.api.questions import WhereQuestion
from housefly.hub.things.thing import ThingKind
from housefly.messages import Obstacle
from housefly.tasks.api.values import ReasonCode
from housefly.tasks.execution.task_room import SeenPerson
from housefly.tasks.vantage.named_subject import AskMemory
from housefly.tasks.vantage.search_places import belief_of
from housefly.tasks.vantage.thing_search import ThingSearch
from housefly.tasks.vantage.viewing_room import ViewingRoom

_NOT_LOST = {
    ThingKind.PERSON.value: "is a person: come, follow and all_right look after people",
    ThingKind.FURNITURE.value: "is furniture: ask to look at it",
    ThingKind.PLACE.value: "is a place: ask to look at it",
    ThingKind.STRUCTURE.value: "belongs to the building: ask to look at it",
}


def search_for(
    name: str,
    viewing: ViewingRoom,
    ask: AskMemory,
    people: Iterable[SeenPerson] = (),
    drone: Vec3 | None = None,
    obstacles: Iterable[Obstacle] = (),
    now: float = 0.0,
    look_time: float = 10.0,
) -> ThingSearch:
    """Return a search for a thing; of what the memory does not know, everywhere.

    Args:
        name: or alias or id of the thing.
        viewing: the room.
        ask: of the room's memory.
        people: who is seen now.
        drone: where the drone is [m]; None is at home.
        obstacles: people and things that no map shows.
        now: time of the obstacles [s].
        look_time: what each look takes beside the way to it [s].

    Raises:
        TaskError: BAD_PARAMETER for what is no thing that gets lost.
    """
    seen = tuple(people)
    answer: WhereAnswer | None = None
    try:
        answer = ask(WhereQuestion(name))
    except (ThingError, LinkError):
        answer = None
    if answer is not None and answer.kind in _NOT_LOST:
        words = f"{answer.name} {_NOT_LOST[answer.kind]}"
        raise TaskError(words, ReasonCode.BAD_PARAMETER.value)
    belief = belief_of(answer, viewing, seen)
    carriers = _carriers(answer)
    known = tuple(one for one in obstacles if one.id not in carriers)
    return ThingSearch(viewing, belief, drone, known, now, look_time)


def _carriers(answer: WhereAnswer | None) -> frozenset[str]:
    """Return the ids of who may hold the thing: they do not hide what is in their hands."""
    if answer is None:
        return frozenset()
    return frozenset((*answer.inside[:1], *(one.thing for one in answer.alternatives)))
