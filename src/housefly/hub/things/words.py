"""Answers of the world model in words."""

from __future__ import annotations

from housefly.geometry import Vec3
from housefly.hub.things.beliefs import CARRIERS
from housefly.hub.things.fused_pose import FusedPose
from housefly.hub.things.hypothesis import SURE, Belief, Hypothesis
from housefly.hub.things.world_model import WorldModel

_JUST_NOW = 2.0
"""Ages below this are "now" [s]."""
_UNITS = ((86_400.0, "day"), (3600.0, "h"), (60.0, "min"), (1.0, "s"))
_PLURAL = ("day",)
_MIN_COUNT = 2.0
"""Smallest count in which a unit is used: 90 s, then 2 min."""


def age_words(age: float) -> str:
    """Return how long ago [s] in words: "now", "12 s ago", "3 min ago", "2 days ago"."""
    return "now" if age < _JUST_NOW else f"{span_words(age)} ago"


def lasting_words(seconds: float) -> str:
    """Return how long something lasts [s]: " for 12 s", " for 3 min", "" for a moment."""
    return "" if seconds < _JUST_NOW else f" for {span_words(seconds)}"


def span_words(seconds: float) -> str:
    """Return a span of time [s] in one unit: "12 s", "3 min", "2 days"."""
    length, unit = next(
        ((length, unit) for length, unit in _UNITS if seconds >= _MIN_COUNT * length), _UNITS[-1]
    )
    count = int(seconds / length)
    return f"{count} {unit}{'s' if unit in _PLURAL else ''}"


def seen_words(found: FusedPose, now: float) -> str:
    """Return who saw it last and when: "seen now by vicon", "last seen 3 min ago by floor"."""
    age = found.age(now)
    if age is None:
        return "never seen by a sensor"
    sources = " and ".join(found.sources)
    return (
        f"seen now by {sources}" if age < _JUST_NOW else f"last seen {age_words(age)} by {sources}"
    )


def _within(world: WorldModel, container: str) -> str:
    holder = world.thing(container)
    return f"{'with' if holder.kind in CARRIERS else 'in'} {holder.name}"


def where_words(world: WorldModel, thing: str, now: float, belief: Belief = SURE) -> str:
    """Answer "where is it" in words, with what else may be.

    For example "cup: in the cabinet, at (9.30, 5.60, 0.82) m, last seen 3 min ago by floor".
    """
    found = world.where(thing)
    parts = [_within(world, container) for container in world.chain(thing)]
    if found.position is not None:
        told = ", as the catalogue has it" if found.age(now) is None else ""
        parts.append(_place_words(found.position) + told)
    if belief.alternatives and parts:
        parts[-1] += f" ({_percent(belief.confidence)})"
    parts += [_alternative_words(one) for one in belief.alternatives]
    parts.append(seen_words(found, now))
    return f"{world.thing(thing).name}: {', '.join(parts)}"


def _alternative_words(one: Hypothesis) -> str:
    place = "" if one.position is None else f" {_place_words(one.position)}"
    return f"or {one.words}{place} ({_percent(one.confidence)})"


def _place_words(position: Vec3) -> str:
    return "at ({:z.2f}, {:z.2f}, {:z.2f}) m".format(*position)


def _percent(confidence: float) -> str:
    return f"{max(1, round(100 * confidence))} %"
