"""What came, went or moved between two times, as the room's memory has it."""

from __future__ import annotations

from housefly.errors import HouseflyError
from housefly.geometry import Vec3, distance
from housefly.hub.api.answers import PlacedThing
from housefly.hub.api.questions import EventsQuestion, PictureQuestion, WhereQuestion
from housefly.tasks.execution.run_context import RunContext

NEAR = 2.0
"""Things so near to a place are at it [m]."""
MOVED = 0.5
"""A thing that is this far from where it was has moved [m]."""
FIRST_TIME = 86_400.0
"""A service that never ended before compares with so long ago [s]."""
_COMPARED = frozenset({"object", "furniture"})


def last_time(context: RunContext) -> float:
    """Return when this service ended last [Unix time, s]."""
    now = context.inputs.unix
    try:
        ended = context.room.ask(EventsQuestion(max(0.0, now - 30 * FIRST_TIME), kind="task ended"))
    except HouseflyError:
        return now - FIRST_TIME
    times = [e.at for e in ended.events if e.facts.get("service") == context.service]
    return max(times, default=now - FIRST_TIME)


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
    return lines


def _is_at(thing: PlacedThing, container: str, point: Vec3 | None) -> bool:
    if thing.inside == container:
        return True
    return (
        point is not None
        and thing.position is not None
        and distance(thing.position[:2], point[:2]) < NEAR
    )


def _told(now: PlacedThing, old: PlacedThing | None, is_here: bool, was_here: bool) -> str:
    name = now.name[:1].upper() + now.name[1:]
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
