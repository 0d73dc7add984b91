"""A client of the tasks of one run: questions over the Unix socket of the tasks process."""

from __future__ import annotations

import os
import time
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from housefly.errors import LinkError
from housefly.hub.client.discovery import RoomAddress
from housefly.hub.client.hub_connection import HubConnection
from housefly.tasks.api.json import task_answer_from_json, task_question_to_json
from housefly.tasks.api.questions import TaskQuestion
from housefly.tasks.client.task_queries import TaskQueries

TASKS_SOCKET = "tasks"
"""Name of the socket, in the folder of the run's other sockets."""
_START_PATIENCE, _START_PAUSE = 20.0, 0.1
"""How long the first question waits for tasks that have just been started [s]."""


class TasksClient(TaskQueries):
    """Asks the tasks of a run on this machine; not thread-safe.

    Args:
        place: the run, as ``discovery.find`` returns it.
        by: who wants what is asked, in words.
        timeout: of one question [s]; rehearsals take seconds.
    """

    def __init__(self, place: RoomAddress, by: str = "a program", timeout: float = 30.0) -> None:
        self.by, self.owner = by, f"user {os.getuid()}"
        self._site = place.site
        endpoint = place.bus.partition("/")[2] if place.bus else place.socket
        path = tasks_socket(Path(endpoint)) if endpoint else None
        self._line = HubConnection(str(path), place.key, timeout) if path else None
        self._heard = False

    def ask_tasks(self, question: TaskQuestion) -> Any:
        """Return the answer.

        Raises:
            TaskError: it is refused; its code says why.
            LinkError: nobody answers.
        """
        return task_answer_from_json(question, self._asked(task_question_to_json(question)))

    def close(self) -> None:
        """Close the connection."""
        if self._line is not None:
            self._line.close()

    def _asked(self, text: str) -> str:
        deadline = time.monotonic() + _START_PATIENCE
        while self._line is not None:
            try:
                answer = self._line.ask(text)
            except OSError as error:
                if self._heard or time.monotonic() > deadline:
                    raise LinkError(
                        f"the services of {self._site} do not answer: a room that has just been"
                        " started may need a moment; else see whether [tasks] enabled is false in"
                        f" the site file, and tasks.log in the run's folder ({error})"
                    ) from error
                time.sleep(_START_PAUSE)
            else:
                self._heard = True
                return answer
        raise LinkError(f"the run of {self._site} does not say where to ask its tasks")

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()


def tasks_socket(neighbour: Path) -> Path:
    """Return where the tasks answer, given another socket of the same run."""
    return neighbour.with_name(TASKS_SOCKET)
