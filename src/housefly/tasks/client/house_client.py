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
from housefly.tasks.api.json import task_answer_from_json
from housefly.tasks.api.questions import TaskQuestion
from housefly.tasks.client.http_tasks import HttpTasks
from housefly.tasks.client.task_queries import TaskQueries
from housefly.tasks.client.tasks_client import TasksClient

_TIMEOUT = 30.0
"""Of one question over HTTP; rehearsals take seconds [s]."""


class HouseClient(RoomClient, TaskQueries):
    """A client of one room and its tasks, on this machine or at an address; not thread-safe.

    Args:
        place: the run.
        by: who wants what is asked of the tasks, in words.
    """

    def __init__(self, place: RoomAddress, by: str = "a program") -> None:
        is_here = bool(place.socket or place.bus)
        self._far = None if is_here else HttpTasks(place.address, place.key, _TIMEOUT)
        self._tasks = TasksClient(place, by) if is_here else None
        super().__init__(place.address, place.key, socket=place.socket)
        self.by, self.owner = by, self._tasks.owner if self._tasks is not None else ""

    def ask_tasks(self, question: TaskQuestion) -> Any:
        """Return the answer; raises TaskError when it is refused, LinkError if nobody answers."""
        if self._far is not None:
            return task_answer_from_json(question, self._far.ask(question))
        assert self._tasks is not None
        return self._tasks.ask_tasks(question)

    def close(self) -> None:
        """Close the connections."""
        super().close()
        if self._tasks is not None:
            self._tasks.close()
