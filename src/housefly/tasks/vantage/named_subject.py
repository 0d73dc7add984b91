"""From a name to what is to be seen: a place of the room, a person, or a thing."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from functools import lru_cache
from math import isfinite
from typing import Any

from housefly.errors import LinkError, TaskError, ThingError
from housefly.geometry import Vec2, Vec3, distance
from housefly.hub.api.answers import WhereAnswer
from housefly.hub.api.questions import PeopleQuestion, Question, WhereQuestion
from housefly.hub.things_of_room import place_id
from housefly.messages import Obstacle, ObstacleKind
from housefly.messages.words import Words
from housefly.room.model import Place, Room, Solid
from housefly.tasks.api.values import ReasonCode
from housefly.tasks.execution.task_room import SeenPerson
from housefly.tasks.vantage.patrol import FLOOR, WHOLE_FLOOR, patrol_viewpoints
from housefly.tasks.vantage.subject import (
    Subject,
    furniture_subject,
    person_subject,
    pieces_of,
    place_subject,
    small_subject,
)
from housefly.tasks.vantage.viewing_room import ViewingRoom
from housefly.tasks.vantage.viewpoint import Viewpoint
from housefly.tasks.vantage.viewpoints import find_viewpoint, is_reachable, viewpoint_at

AskMemory = Callable[[Question], Any]
"""Returns the memory's answer; raises ThingError or LinkError."""

_FLOOR = re.compile(rf"({FLOOR}|{WHOLE_FLOOR}) ([0-9]{{1,2}})")
_HOME = "home"
_VISITOR = "visitor"
_PERSON_KIND = "person"
_AT_THE_DOOR = 0.6
"""Who stands so near to where visitors stand faces as visitors do [m]."""


def viewpoint_of(
    name: str,
    viewing: ViewingRoom,
    ask: AskMemory,
    people: Iterable[SeenPerson] = (),
    drone: Vec3 | None = None,
    obstacles: Iterable[Obstacle] = (),
    now: float = 0.0,
) -> Viewpoint:
    """Return where to hover to see a place, a thing or a person.

    A named place keeps its own viewpoint while the drone can hover there; the others get one
    computed.

    Args:
        name: of a place, or name, alias or id of a thing or person; "floor 1", "floor 2" ... are
            the viewpoints of a round that sees the floor, "whole floor 1" ... of one that sees all
            of it.
        viewing: the room.
        ask: of the room's memory.
        people: who is seen now; they are kept away from as obstacles are.
        drone: where it is; of equal viewpoints the nearer one is taken [m].
        obstacles: what no map shows.
        now: time of the obstacles [s].

    Raises:
        TaskError: UNKNOWN_PLACE, UNKNOWN_THING or NO_VIEW, in one sentence.
    """
    seen = tuple(people)
    known = (*obstacles, *(_obstacle(person, viewing, now) for person in seen))
    if (floor := _FLOOR.fullmatch(name.strip().lower())) is not None:
        return _floor_view(viewing, floor[1], int(floor[2]), drone, known, now)
    place = _place(viewing.room, name)
    if place is None:
        subject = named_subject(name, viewing.room, ask, seen)
        return find_viewpoint(viewing, subject, drone, known, now)
    if is_reachable(viewing, place.viewpoint, drone, known, now):
        title = place.title or place.name
        flat = distance(place.viewpoint, place.look_at[:2])
        away = distance((*place.viewpoint, viewing.height), place.look_at)
        words = f"{title}: its own viewpoint, {flat:.1f} m away"
        return Viewpoint(place.name, place.viewpoint, place.look_at, away, words)
    return find_viewpoint(viewing, place_subject(place.name, place.look_at), drone, known, now)


def view_from(
    name: str,
    viewing: ViewingRoom,
    ask: AskMemory,
    place: Vec2,
    people: Iterable[SeenPerson] = (),
    obstacles: Iterable[Obstacle] = (),
    now: float = 0.0,
) -> Viewpoint | None:
    """Return the viewpoint at a place [m] itself when it shows somebody or something well, or None.

    The other arguments and errors as ``viewpoint_of``.
    """
    seen = tuple(people)
    known = (*obstacles, *(_obstacle(person, viewing, now) for person in seen))
    return viewpoint_at(viewing, named_subject(name, viewing.room, ask, seen), place, known)


def round_names(viewing: ViewingRoom, *, whole: bool = False) -> tuple[str, ...]:
    """Return the names of a room's places but home, or, where it has none, "floor 1" and on.

    With ``whole`` they are "whole floor 1" and on: together they see all of the floor.
    """
    if whole:
        return tuple(view.subject for view in _floor_views(viewing, WHOLE_FLOOR))
    places = tuple(place.name for place in viewing.room.places if place.name != _HOME)
    return places or tuple(view.subject for view in _floor_views(viewing, FLOOR))


def _floor_view(
    viewing: ViewingRoom,
    name: str,
    number: int,
    drone: Vec3 | None,
    known: tuple[Obstacle, ...],
    now: float,
) -> Viewpoint:
    """Return one viewpoint of the round over the floor."""
    views = _floor_views(viewing, name)
    if not 1 <= number <= len(views):
        words = (
            f"the round over the {name} has {len(views)} viewpoints: there is no {name} {number}"
        )
        raise TaskError(words, ReasonCode.UNKNOWN_PLACE.value)
    view = views[number - 1]
    if is_reachable(viewing, view.position, drone, known, now):
        return view
    words = Words("there is no free way to where {name} can be seen from", name=view.subject)
    raise TaskError(words, ReasonCode.NO_WAY.value)


@lru_cache(maxsize=4)
def _floor_views(viewing: ViewingRoom, name: str) -> tuple[Viewpoint, ...]:
    """Return the round from the pad through the room as it was built: its numbers stay."""
    return patrol_viewpoints(viewing, whole=name == WHOLE_FLOOR)


def named_subject(
    name: str, room: Room, ask: AskMemory, people: Iterable[SeenPerson] = ()
) -> Subject:
    """Return the person or thing with a name, where it is now.

    Raises:
        TaskError: UNKNOWN_THING, or NO_VIEW when nobody knows where it is.
    """
    seen = {person.id: person for person in people}
    if name in seen:
        return _person(name, seen[name].position, room, ask)
    try:
        answer: WhereAnswer = ask(WhereQuestion(name))
    except ThingError as error:
        return _modelled(name, room, str(error))
    except LinkError:
        return _modelled(name, room, Words("nobody knows where {name} is", name=name))
    if answer.thing in seen:
        return _person(answer.name, seen[answer.thing].position, room, ask, answer.thing)
    holder = next((seen[one] for one in answer.inside if one in seen), None)
    if holder is not None:
        return _person(answer.name, holder.position, room, ask, holder.id)
    place = _place(room, answer.thing)
    if place is not None:
        return place_subject(answer.name, place.look_at)
    if answer.position is None or not all(map(isfinite, answer.position)):
        words = Words("nobody knows where {name} is", name=answer.name)
        raise TaskError(words, ReasonCode.NO_VIEW.value)
    if answer.kind == _PERSON_KIND:
        return _person(answer.name, answer.position, room, ask, answer.thing)
    pieces = _pieces(answer.thing, room)
    if pieces and not answer.inside:
        return furniture_subject(answer.name, _nearest(pieces, answer.position), room)
    return small_subject(answer.name, answer.position, room)


def _modelled(name: str, room: Room, problem: str) -> Subject:
    """Return a thing of the room model, of which the memory knows nothing."""
    if name.lower() == _VISITOR and room.visitor is not None:
        return _person("the visitor", (*room.visitor, 0.0), room, _nobody)
    pieces = _pieces(name, room)
    if not pieces:
        raise TaskError(problem, ReasonCode.UNKNOWN_THING.value)
    return furniture_subject(f"the {name}", pieces[0], room)


def _person(name: str, position: Vec3, room: Room, ask: AskMemory, person: str = "") -> Subject:
    """Return somebody as they are now; the memory may know their posture."""
    posture = ""
    try:
        for one in ask(PeopleQuestion(person or name)).people:
            posture = one.posture
    except (ThingError, LinkError):
        posture = ""
    at_door = room.visitor is not None and distance(position[:2], room.visitor) < _AT_THE_DOOR
    return person_subject(name, position, room, posture, room.visitor_yaw if at_door else None)


def _nobody(question: Question) -> Any:
    raise LinkError("nobody remembers")


def _place(room: Room, name: str) -> Place | None:
    """Return the place with a name, a title, or the id that the memory gives it."""
    wanted = name.strip().lower()
    names = ((place, (place.name, place.title.lower(), place_id(place))) for place in room.places)
    return next((place for place, known in names if wanted in known), None)


def _pieces(name: str, room: Room) -> tuple[tuple[Solid, ...], ...]:
    """Return the pieces of furniture of a name or of a thing's id, the whole ones first."""
    slug = name.strip().lower().replace(" ", "-")
    parts = tuple(one for one in room.solids if one.thing.replace(" ", "-") == slug)
    return pieces_of(parts)


def _nearest(pieces: tuple[tuple[Solid, ...], ...], position: Vec3) -> tuple[Solid, ...]:
    return min(
        pieces,
        key=lambda piece: min(distance(solid.position[:2], position[:2]) for solid in piece),
    )


def _obstacle(person: SeenPerson, viewing: ViewingRoom, now: float) -> Obstacle:
    return Obstacle(
        person.id,
        person.position[:2],
        viewing.site.people.body_radius,
        velocity=person.velocity,
        seen_at=now - person.age,
        source="people",
        kind=ObstacleKind.PERSON,
    )
