"""Where the drone flies to, as people call it: never a pair of numbers."""

from __future__ import annotations

import re
from collections.abc import Sequence
from math import dist

from housefly.geometry import Vec2
from housefly.hub.api.pilot_queries import PlaceView
from housefly.messages.words import Words
from housefly.tasks.api.answers import TaskBoard
from housefly.tasks.api.values import TaskStage, TaskStatus

UNNAMED_GOAL = Words("the chosen point")
_POINT = re.compile(r"\((-?\d+\.\d), (-?\d+\.\d)\)")
"""How the pilot calls a goal that is no place."""
_HAS_DRONE = (TaskStage.RUNNING, TaskStage.PAUSED)
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


def task_of_drone(board: TaskBoard | None, drone: str = "") -> TaskStatus | None:
    """Return the task that has a drone now, also while it is paused; "" for any drone.

    What only asks and remembers runs beside it: the first that flew counts.
    """
    has_drone = [
        task
        for task in (board.tasks if board is not None else ())
        if task.state in _HAS_DRONE and (not drone or task.drone in ("", drone))
    ]
    flown = (task for task in has_drone if task.took_off_at is not None)
    return next(flown, has_drone[0] if has_drone else None)


def subject_of_task(task: TaskStatus | None, places: Sequence[PlaceView]) -> str:
    """Return what a task is about: a place or thing that it was asked for, or its title."""
    if task is None:
        return ""
    titles = {place.name: place.title for place in places}
    words = [value for value in task.parameters.values() if isinstance(value, str) and value]
    named = next((titles[value] for value in words if value in titles), "")
    return named or (words[0] if words else f"“{task.title}”")
