"""What can be named in a sentence: the places, things and people of a room."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from housefly.hub.api.answers import ThingAnswer
from housefly.hub.things.thing import ThingKind
from housefly.room.model import Room
from housefly.tasks.intents.intent import NameKind

_LONGEST_NAME = 80
_KINDS = {ThingKind.PLACE.value: NameKind.PLACE, ThingKind.PERSON.value: NameKind.PERSON}
_UNNAMED = frozenset({ThingKind.SENSOR.value})
"""Nobody asks for a camera of the tracking system by name."""

_BUILDING = frozenset({"wall", "floor", "ceiling", "window", "pad"})
"""Parts that nobody asks to be shown."""


@dataclass(frozen=True, slots=True)
class NamedSubject:
    """A place, thing or person.

    Attributes:
        id: what intents and services call it: the name of a place, the id of a thing or person.
        kind: which of them.
        names: what people call it; the first is shown.
        thing: its id at the hub.
    """

    id: str
    kind: NameKind
    names: tuple[str, ...]
    thing: str


@dataclass(frozen=True, slots=True)
class Names:
    """Everything that can be named."""

    subjects: tuple[NamedSubject, ...] = ()

    def of(self, id: str, kind: str | None = None) -> NamedSubject | None:
        """Return the subject with an id, of a kind or of any."""
        found = (one for one in self.subjects if one.id == id and kind in (None, one.kind))
        return next(found, None)

    def of_thing(self, thing: str) -> NamedSubject | None:
        """Return the subject with an id at the hub."""
        return next((one for one in self.subjects if one.thing == thing), None)


def names_of(things: Iterable[ThingAnswer]) -> Names:
    """Return the names of a catalogue: what ``RoomQueries.things`` returns."""
    return Names(tuple(_subject(thing) for thing in things if thing.kind not in _UNNAMED))


def _subject(thing: ThingAnswer) -> NamedSubject:
    kind = _KINDS.get(thing.kind, NameKind.THING)
    said = (thing.name, *thing.aliases, thing.thing)
    place = (thing.aliases or (thing.name,))[0]
    id = place if kind is NameKind.PLACE else thing.thing
    names = tuple(dict.fromkeys(name for name in said if 0 < len(name) <= _LONGEST_NAME))
    return NamedSubject(id, kind, names, thing.thing)


def names_of_room(room: Room) -> Names:
    """Return the names of a room without its memory."""
    places = tuple(
        NamedSubject(
            place.name,
            NameKind.PLACE,
            tuple(dict.fromkeys(filter(None, (place.title, place.name)))),
            f"place-{place.name}",
        )
        for place in room.places
    )
    known = {name.lower() for place in places for name in place.names}
    things = dict.fromkeys(solid.thing for solid in room.solids)
    return Names(
        (
            *places,
            *(
                NamedSubject(thing.replace(" ", "-"), NameKind.THING, (thing,), thing)
                for thing in things
                if thing and thing.lower() not in known | _BUILDING
            ),
        )
    )
