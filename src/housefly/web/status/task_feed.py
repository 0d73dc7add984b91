"""What the console shows of the tasks: their newest board, and whether anybody still keeps it."""

from __future__ import annotations

import asyncio
import logging
import threading
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

from housefly.bus.bus import Bus
from housefly.bus.topics import TASKS_QUERY
from housefly.clock import Clock
from housefly.config.house_mode import HouseMode
from housefly.errors import HouseflyError
from housefly.tasks.api.answers import TaskBoard
from housefly.tasks.api.json import task_answer_from_json, task_question_to_json
from housefly.tasks.api.questions import BoardQuestion
from housefly.tasks.api.topics import TASK_NEWS_TOPIC
from housefly.web.messages.server_messages import TasksMessage

_LOG = logging.getLogger(__name__)

BOARD_PERIOD = 1.0
"""How often the tasks are asked for their board, beside what they tell [s]."""
SILENCE = 4.0
"""Who has neither told nor answered anything for this long [s] is not running."""
_PATIENCE = 2.0


class TaskFeed:
    """The newest board; all methods are safe from any thread.

    Args:
        bus: where the tasks are.
        clock: the server's clock.
    """

    def __init__(self, bus: Bus, clock: Clock) -> None:
        self._bus, self._clock = bus, clock
        self._lock = threading.Lock()
        self._thread = ThreadPoolExecutor(1, "task-board")
        self._board: TaskBoard | None = None
        self._heard_at = float("-inf")
        self._told_at = 0.0

    def listen(self) -> None:
        """Subscribe to the tasks' news; the bus closes the subscription."""
        self._bus.subscribe(TASK_NEWS_TOPIC, self._take)

    def close(self) -> None:
        """Shut the thread down without waiting."""
        self._thread.shutdown(wait=False, cancel_futures=True)

    async def ask(self) -> None:
        """Ask for the board; silence is noticed by its age."""
        await asyncio.get_running_loop().run_in_executor(self._thread, self._ask)

    def message(self) -> TasksMessage:
        """Return what browsers are told; the same value as long as nothing has changed."""
        with self._lock:
            running = self._clock.now() - self._heard_at <= SILENCE
            return TasksMessage(running, self._told_at, self._board)

    def mode(self) -> HouseMode | None:
        """Return the mode of the house, or None while nobody tells it."""
        message = self.message()
        return message.board.mode if message.running and message.board is not None else None

    def _ask(self) -> None:
        question = BoardQuestion()
        try:
            text = self._bus.ask(TASKS_QUERY, task_question_to_json(question), _PATIENCE)
            self._take(task_answer_from_json(question, text))
        except HouseflyError as error:
            _LOG.debug("no board of the tasks: %s", error)

    def _take(self, board: TaskBoard) -> None:
        now = self._clock.now()
        with self._lock:
            self._heard_at = now
            if self._is_news(board):
                self._board, self._told_at = board, now

    def _is_news(self, board: TaskBoard) -> bool:
        """Return whether a board says something that the known one does not."""
        known = self._board
        if known is None or replace(board, at=known.at) != known:
            # An answer that was asked for earlier may come after newer news; a clock may be set.
            return known is None or board.at >= known.at or known.at - board.at > SILENCE
        return False
