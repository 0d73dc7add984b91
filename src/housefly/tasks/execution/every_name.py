"""The names that "every place", "every person" and "whole floor" stand for."""

from __future__ import annotations

from housefly.errors import LinkError
from housefly.geometry import Vec2, distance
from housefly.hub.api.answers import ThingAnswer
from housefly.hub.api.questions import CatalogueQuestion, PeopleQuestion
from housefly.tasks.execution.run_context import RunContext

NAMES_MAX = 30
"""Most names that one step goes through."""
_PLACE, _HOME = "place-", "home"


def every_name(every: str, context: RunContext) -> list[str]:
    """Return ids: of places, each the nearest to the one before; or of people who are here.

    A room without named places is gone round by viewpoints that together see its floor; "whole
    floor" is gone round by viewpoints that see all of it.
    """
    if every == "whole floor":
        return list(context.room.round_names(whole=True))[:NAMES_MAX]
    if every == "every person":
        people = context.room.ask(PeopleQuestion()).people
        found = [each for each in people if each.present != "no"]
        context.titles.update({each.person: each.name for each in found})
        return [each.person for each in found][:NAMES_MAX]
    try:
        known = context.room.ask(CatalogueQuestion("place")).things
    except LinkError:
        known = ()  # the room itself has names, too
    places = [each for each in known if each.thing.removeprefix(_PLACE) != _HOME]
    if not places:
        return list(context.room.round_names())[:NAMES_MAX]
    context.titles.update({each.thing: each.name for each in places})
    here = context.inputs.position
    return [each.thing for each in _in_order(places, (0.0, 0.0) if here is None else here[:2])]


def _in_order(places: list[ThingAnswer], here: Vec2) -> list[ThingAnswer]:
    left, order = list(places), list[ThingAnswer]()
    while left and len(order) < NAMES_MAX:
        nearest = min(left, key=lambda each: _away(each, here))
        left.remove(nearest)
        order.append(nearest)
        here = here if nearest.position is None else nearest.position[:2]
    return order


def _away(place: ThingAnswer, here: Vec2) -> float:
    return 1e6 if place.position is None else distance(place.position[:2], here)
