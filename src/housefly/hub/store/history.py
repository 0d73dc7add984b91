"""Questions about the past that need the fused view."""

from __future__ import annotations

from housefly.errors import ThingError
from housefly.hub.store.contract import Store
from housefly.hub.things.thing import Thing
from housefly.hub.things.whereabouts import Whereabouts
from housefly.hub.things.world import World


def world_at(store: Store, at: float) -> World:
    """Return the world model as it was at a time [s, Unix time]: what was in X, what was near Y."""
    world = World(store.things())
    _tell(world, store, at)
    return world


def where_was(store: Store, thing: str, at: float) -> Whereabouts:
    """Return the fused view of a thing, by its id, at a time [s, Unix time]; only what contains it
    is read besides.

    Raises:
        ThingError: neither the catalogue nor any source knows the thing.
    """
    world = World()
    asked = thing
    known: set[str] = set()
    while thing and thing not in known:
        known.add(thing)
        _know(world, store.things(thing))
        _tell(world, store, at, thing)
        thing = next((container for container in world.chain(asked) if container not in known), "")
    return world.where(asked)


def _know(world: World, things: tuple[Thing, ...]) -> None:
    for thing in things:
        try:
            world.know(thing)
        except ThingError:
            continue  # the catalogue has changed since: what was said then counts


def _tell(world: World, store: Store, at: float, thing: str = "") -> None:
    for sample in store.seen(at, thing):
        try:
            world.told(sample)
        except ThingError:
            continue  # two sources contradict each other: the one that is heard first counts, as it did then
