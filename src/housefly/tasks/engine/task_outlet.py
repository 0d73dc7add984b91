"""What the tasks may do to the world: orders, events, MQTT; nothing else.

Each thing that happens is one event with its cause:

    trigger -> "task asked" -> "task started" -> "clip kept" -> "task ended"

The cause of "task asked" is the trigger; that of all others is their task, as "task 12".
"""

from __future__ import annotations

from collections.abc import Mapping
from concurrent.futures import Future
from typing import Protocol

from housefly.hub.api.told_events import TOLD_EVENT_SOURCE, ToldEventKind
from housefly.messages import Order, RoomEvent
from housefly.tasks.api.values import ParameterValue, RehearsalReport
from housefly.tasks.document.task_document import BoundTask

_MAX_WORDS, _MAX_THING = 200, 100


class TaskOutlet(Protocol):
    """Takes what the tasks want done; quick, thread-safe, never raises."""

    def order(self, order: Order, drone: str) -> None:
        """Give a drone's pilot an order."""
        ...

    def tell(self, event: RoomEvent) -> None:
        """Tell the room's memory what happened."""
        ...

    def say(self, words: str) -> None:
        """Say something to whoever listens in the room."""
        ...

    def publish_mqtt(self, topic: str, payload: str) -> None:
        """Publish to a device of the room."""
        ...


class TaskRehearser(Protocol):
    """Flies a task in lock step, elsewhere."""

    def rehearse(self, task: BoundTask, drone: str) -> Future[RehearsalReport]:
        """Begin a rehearsal with a drone in the room as it is now."""
        ...


def task_name(task: int) -> str:
    """Return what a task is called as a cause and as a sender of orders."""
    return f"task {task}"


def task_event(
    kind: ToldEventKind,
    thing: str,
    at: float,
    cause: str,
    facts: Mapping[str, ParameterValue],
) -> RoomEvent:
    """Return an event of the tasks; long words are cut, odd letters shown as "?".

    Args:
        kind: what happened.
        thing: what it happened to: the drone, or what the task is about.
        at: Unix time [s].
        cause: id of what brought it about, or "".
        facts: the evidence; empty words are left out.
    """
    told = tuple(
        (key, _plain(value, _MAX_WORDS) if isinstance(value, str) else value)
        for key, value in facts.items()
        if value != ""
    )
    name = _plain(thing, _MAX_THING) or "tasks"
    return RoomEvent(kind, name, at, TOLD_EVENT_SOURCE, _plain(cause, _MAX_WORDS), facts=told)


def _plain(text: str, length: int) -> str:
    return "".join(letter if letter.isprintable() else "?" for letter in text[:length])
