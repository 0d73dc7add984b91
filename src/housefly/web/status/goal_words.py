"""Where the drone flies to, as people call it: never a pair of numbers."""

from __future__ import annotations

import re
from collections.abc import Sequence
from math import dist

from housefly.geometry import Vec2
from housefly.hub.api.pilot_queries import PlaceView
from housefly.messages.words import Words
from housefly.tasks.api.answers import TaskBoard
from housefly.tasks.api.values import TaskStage

UNNAMED_GOAL = Words("the chosen point")
_POINT = re.compile(r"\((-?\d+\.\d), (-?\d+\.\d)\)")
"""How the pilot calls a goal that is no place."""
_SAME = 0.4
"""A point this near to where a place is looked at from is that place [m]."""


def goal_words(name: str, places: Sequence[PlaceView], task: str = "") -> str:
    """Return what people call a goal of the pilot; ``task``: what a task that flies looks at."""
    known = {place.name: place.title for place in places}
    if name in known:
        return known[name]
    found = _POINT.fullmatch(name)
    if found is None:
        return name
    point: Vec2 = (float(found[1]), float(found[2]))
    near = min(places, key=lambda place: dist(place.viewpoint, point), default=None)
    if near is not None and dist(near.viewpoint, point) <= _SAME:
        return near.title
    return task or UNNAMED_GOAL


def subject_of_task(board: TaskBoard | None, places: Sequence[PlaceView]) -> str:
    """Return what the task that flies is about: a place or thing that it was asked for, or it."""
    tasks = board.tasks if board is not None else ()
    running = next((task for task in tasks if task.state is TaskStage.RUNNING), None)
    if running is None:
        return ""
    titles = {place.name: place.title for place in places}
    words = [value for value in running.parameters.values() if isinstance(value, str) and value]
    named = next((titles[value] for value in words if value in titles), "")
    return named or (words[0] if words else f"“{running.title}”")
