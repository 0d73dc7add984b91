"""How long ago somebody was seen: now by sensors, else as the room's memory has it."""

from __future__ import annotations

from math import isfinite

from housefly.errors import HouseflyError
from housefly.hub.api.questions import WhereQuestion
from housefly.tasks.execution.run_context import RunContext

ANYBODY = "anybody"
"""The subject that means whoever is seen nearest."""


def age_of(name: str, context: RunContext) -> float | None:
    """Return how long ago a person or thing was seen [s]; None when nobody can say.

    Args:
        name: or alias or id; ``anybody`` is whoever is faced, or else who was seen last.
        context: of the task.
    """
    ages = {person.id: person.age for person in context.room.people()}
    if name == ANYBODY:
        if not context.faced:
            return min(ages.values(), default=None)
        name = context.faced
    if name in ages:
        return ages[name]
    try:
        answer = context.room.ask(WhereQuestion(name))
    except HouseflyError:
        return None
    if answer.thing in ages:
        return ages[answer.thing]
    age: float | None = answer.age
    return age if age is not None and isfinite(age) else None
