"""What came, went or moved between two times, as the room's memory has it."""

from __future__ import annotations

from housefly.geometry import Vec3, distance
from housefly.hub.api.answers import PlacedThing
from housefly.hub.api.questions import EventsQuestion, PictureQuestion, WhereQuestion
from housefly.tasks.api.values import TaskStage
from housefly.tasks.execution.run_context import RunContext

NEAR = 2.0
"""Things so near to a place are at it [m]."""
MOVED = 0.5
"""A thing that is this far from where it was has moved [m]."""
REACH = 30 * 86_400.0
"""A service that ended longer ago than this [s] compares with nothing."""
_DONE = TaskStage.DONE.value
_COMPARED = frozenset({"object", "furniture"})


def last_time(context: RunContext) -> float | None:
    """Return when this service was done last [Unix time, s]; None when it never was.

    One that was cancelled or failed told nobody what had changed.
    """
    since = max(0.0, context.inputs.unix - REACH)
    ended = context.room.ask(EventsQuestion(since, kind="task ended"))
    times = [
        event.at
        for event in ended.events
        if event.facts.get("service") == context.service
        and event.facts.get("outcome", _DONE) == _DONE
    ]
    return max(times, default=None)


def changes_between(context: RunContext, then: float, thing: str = "") -> list[str]:
    """Return one line for each thing that came, went or moved since a time.

    Args:
        context: of the task.
        then: Unix time [s].
        thing: only what is in it or near it; "" is everything.

    Raises:
        HouseflyError: the memory does not answer.
    """
    ask = context.room.ask
    before = {each.thing: each for each in ask(PictureQuestion(max(0.0, then))).things}
    after = {each.thing: each for each in ask(PictureQuestion()).things}
    where = ask(WhereQuestion(thing)) if thing else None
    container = "" if where is None else where.thing
    point = None if where is None else where.position
    lines = []
    for name, now in after.items():
        old = before.get(name)
        if now.kind not in _COMPARED or name == container:
            continue
        is_here = not thing or _is_at(now, container, point)
        was_here = old is not None and (not thing or _is_at(old, container, point))
        if line := _told(now, old, is_here, was_here):
            lines.append(line)
    gone = (old for name, old in before.items() if name not in after)
    return lines + [
        f"{_capital(old.name)} is gone"
        for old in gone
        if old.kind in _COMPARED and (not thing or _is_at(old, container, point))
    ]


def _is_at(thing: PlacedThing, container: str, point: Vec3 | None) -> bool:
    if thing.inside == container:
        return True
    return (
        point is not None
        and thing.position is not None
        and distance(thing.position[:2], point[:2]) < NEAR
    )


def _told(now: PlacedThing, old: PlacedThing | None, is_here: bool, was_here: bool) -> str:
    name = _capital(now.name)
    if is_here and not was_here:
        return f"{name} is new here"
    if was_here and not is_here:
        return f"{name} is gone from here"
    if not is_here or old is None:
        return ""
    if now.inside != old.inside:
        return f"{name} was taken out of {old.inside}" if old.inside else f"{name} was put away"
    if now.position is None or old.position is None:
        return ""
    moved = distance(now.position[:2], old.position[:2])
    return f"{name} moved by {moved:.1f} m" if moved > MOVED else ""


def _capital(words: str) -> str:
    return words[:1].upper() + words[1:]
