"""What the tasks may do to the world: orders, events, MQTT; nothing else."""

from __future__ import annotations

from concurrent.futures import Future
from typing import Protocol

from housefly.messages import Order, RoomEvent
from housefly.tasks.api.values import RehearsalReport
from housefly.tasks.document.task_document import BoundTask


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
