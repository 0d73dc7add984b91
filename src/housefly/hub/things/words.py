"""Answers of the world model in words."""

from __future__ import annotations

from housefly.hub.things.fused_pose import FusedPose
from housefly.hub.things.thing import ThingKind
from housefly.hub.things.world_model import WorldModel

_JUST_NOW = 2.0
"""Ages below this are "now" [s]."""
_UNITS = ((86_400.0, "day"), (3600.0, "h"), (60.0, "min"), (1.0, "s"))
_PLURAL = ("day",)
_CARRIERS = (ThingKind.PERSON, ThingKind.ROBOT)
"""What they carry is with them, not in them."""
_MIN_COUNT = 2.0
"""Smallest count in which a unit is used: 90 s, then 2 min."""


def age_words(age: float) -> str:
    """Return how long ago [s] in words: "now", "12 s ago", "3 min ago", "2 days ago"."""
    if age < _JUST_NOW:
        return "now"
    length, unit = next(
        ((length, unit) for length, unit in _UNITS if age >= _MIN_COUNT * length), _UNITS[-1]
    )
    count = int(age / length)
    return f"{count} {unit}{'s' if unit in _PLURAL else ''} ago"


def seen_words(found: FusedPose, now: float) -> str:
    """Return who saw it last and when: "seen now by vicon", "last seen 3 min ago by floor"."""
    age = found.age(now)
    if age is None:
        return "never seen, as the catalogue says"
    sources = " and ".join(found.sources)
    return (
        f"seen now by {sources}" if age < _JUST_NOW else f"last seen {age_words(age)} by {sources}"
    )


def _within(world: WorldModel, container: str) -> str:
    holder = world.thing(container)
    return f"{'with' if holder.kind in _CARRIERS else 'in'} {holder.name}"


def where_words(world: WorldModel, thing: str, now: float) -> str:
    """Answer "where is it" in words.

    For example "cup: in the cabinet, at (9.30, 5.60, 0.82) m, last seen 3 min ago by floor".
    """
    found = world.where(thing)
    parts = [_within(world, container) for container in world.chain(thing)]
    if found.position is not None:
        parts.append("at ({:.2f}, {:.2f}, {:.2f}) m".format(*found.position))
    parts.append(seen_words(found, now))
    return f"{world.thing(thing).name}: {', '.join(parts)}"
