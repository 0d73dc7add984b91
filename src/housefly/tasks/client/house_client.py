"""Ask a running room and its tasks from Python.

import housefly

with housefly.connect() as room:
    print(room.where("cup").words)
    task = room.request("look", subject="refrigerator")
    print(room.tasks().tasks, room.cancel(task.id))
"""

from __future__ import annotations

from typing import Any

from housefly.hub.client.discovery import RoomAddress
from housefly.hub.client.room_client import RoomClient
from housefly.tasks.api.questions import TaskQuestion
from housefly.tasks.client.task_queries import TaskQueries
from housefly.tasks.client.tasks_client import TasksClient


class HouseClient(RoomClient, TaskQueries):
    """A client of one room and its tasks, not thread-safe.

    Args:
        place: the run.
        by: who wants what is asked of the tasks, in words.
    """

    def __init__(self, place: RoomAddress, by: str = "a program") -> None:
        super().__init__(place.address, place.key, socket=place.socket)
        self.by = by
        self._tasks = TasksClient(place, by)

    def ask_tasks(self, question: TaskQuestion) -> Any:
        """Return the answer; raises TaskError when it is refused, LinkError if nobody answers."""
        return self._tasks.ask_tasks(question)

    def close(self) -> None:
        """Close the connections."""
        super().close()
        self._tasks.close()
