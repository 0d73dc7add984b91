"""What the world model says, in words."""

from __future__ import annotations

from housefly.hub.things.thing import Kind
from housefly.hub.things.whereabouts import Whereabouts
from housefly.hub.things.world import World

JUST_NOW = 2.0
"""Younger than this is now [s]."""
UNITS = ((86_400.0, "day"), (3600.0, "h"), (60.0, "min"), (1.0, "s"))
PLURAL = ("day",)
CARRIERS = (Kind.PERSON, Kind.ROBOT)
"""What is in their hands is with them, not in them."""
COARSEST = 2.0
"""A unit is used from this many of it on: 90 s, then 2 min."""


def age_words(age: float) -> str:
    """Return how long ago [s] in words: "now", "12 s ago", "3 min ago", "2 days ago"."""
    if age < JUST_NOW:
        return "now"
    length, unit = next(
        ((length, unit) for length, unit in UNITS if age >= COARSEST * length), UNITS[-1]
    )
    count = int(age / length)
    return f"{count} {unit}{'s' if unit in PLURAL else ''} ago"


def seen_words(found: Whereabouts, now: float) -> str:
    """Return who saw it last and when: "last seen 3 min ago by floor"; "seen now by vicon"; "never
    seen".
    """
    age = found.age(now)
    if age is None:
        return "never seen, as the catalogue says"
    sources = " and ".join(found.sources)
    return (
        f"seen now by {sources}" if age < JUST_NOW else f"last seen {age_words(age)} by {sources}"
    )


def _within(world: World, container: str) -> str:
    holder = world.thing(container)
    return f"{'with' if holder.kind in CARRIERS else 'in'} {holder.name}"


def where_words(world: World, thing: str, now: float) -> str:
    """Answer "where is it": "cup: in the cabinet, in the kitchen, at (9.30, 5.60, 0.82) m, last
    seen 3 min ago by floor".
    """
    found = world.where(thing)
    parts = [_within(world, container) for container in world.chain(thing)]
    if found.position is not None:
        parts.append("at ({:.2f}, {:.2f}, {:.2f}) m".format(*found.position))
    parts.append(seen_words(found, now))
    return f"{world.thing(thing).name}: {', '.join(parts)}"
