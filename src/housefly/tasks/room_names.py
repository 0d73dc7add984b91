"""What can be named in a room that remembers nothing: its places, and the things of its model."""

from __future__ import annotations

from housefly.room.model import Room
from housefly.tasks.intents.intent import NameKind
from housefly.tasks.intents.names import NamedSubject, Names

_BUILDING = frozenset({"wall", "floor", "ceiling", "window", "pad"})
"""Parts that nobody asks to be shown."""


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
