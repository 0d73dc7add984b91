"""The board of the tasks for the live view: its channel, and the mode for the camera."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable, Sequence

from housefly.bus.bus import Bus, Subscription
from housefly.bus.topics import TASKS_QUERY
from housefly.clock import Clock, RealClock
from housefly.config.house_mode import HouseMode
from housefly.errors import HouseflyError
from housefly.foxglove.json_values import HouseTasks, TaskRow
from housefly.tasks.api.answers import TaskBoard
from housefly.tasks.api.json import task_answer_from_json, task_question_to_json
from housefly.tasks.api.questions import BoardQuestion
from housefly.tasks.api.topics import TASK_NEWS_TOPIC
from housefly.tasks.api.values import TaskStatus

_LOG = logging.getLogger(__name__)

_PERIOD, _PATIENCE = 1.0, 2.0
"""How often the tasks are asked, beside what they tell, and how long for [s]."""
_SILENCE = 4.0
"""Who has told nothing for this long is not running [s], as the console has it."""


class HouseBoard:
    """Asks the tasks for their board while somebody watches.

    Args:
        bus: where the tasks are.
        clock: of this machine.
    """

    def __init__(self, bus: Bus, clock: Clock | None = None) -> None:
        self._bus, self._clock = bus, clock or RealClock()
        self._lock = threading.Lock()
        self._mode: HouseMode | None = None
        self._heard_at = float("-inf")

    def mode(self) -> HouseMode | None:
        """Return the mode of the house; None while nobody tells it."""
        with self._lock:
            is_fresh = self._clock.now() - self._heard_at <= _SILENCE
            return self._mode if is_fresh else None

    def follow(
        self, tell: Callable[[TaskBoard], None] = lambda board: None
    ) -> Sequence[Subscription]:
        """Begin to listen and to ask.

        Args:
            tell: is given each board, on a thread of the bus or one of its own.
        """

        def heard(board: TaskBoard) -> None:
            with self._lock:
                self._mode, self._heard_at = board.mode, self._clock.now()
            tell(board)

        return self._bus.subscribe(TASK_NEWS_TOPIC, heard), _Asking(self._bus, heard)


class _Asking:
    """A thread that asks for the board once a second."""

    def __init__(self, bus: Bus, heard: Callable[[TaskBoard], None]) -> None:
        self._bus, self._heard, self._end = bus, heard, threading.Event()
        threading.Thread(target=self._run, name="task board", daemon=True).start()

    def close(self) -> None:
        """Ask no more."""
        self._end.set()

    def _run(self) -> None:
        question = BoardQuestion()
        while not self._end.is_set():
            try:
                text = self._bus.ask(TASKS_QUERY, task_question_to_json(question), _PATIENCE)
                board = task_answer_from_json(question, text)
            except HouseflyError as error:
                _LOG.debug("no board of the tasks: %s", error)
            else:
                if not self._end.is_set():
                    self._heard(board)
            self._end.wait(_PERIOD)


def house_tasks(board: TaskBoard) -> HouseTasks:
    """Return a board as it is told."""
    return HouseTasks(
        board.at,
        board.mode.value,
        board.records,
        tuple(map(_row, board.tasks)),
        tuple(map(_row, board.ended)),
    )


def _row(task: TaskStatus) -> TaskRow:
    return TaskRow(
        task.id,
        task.title,
        task.service,
        task.state.value,
        str(task.words),
        task.asked_by,
        task.asked_at,
        task.drone,
        str(task.question.words) if task.question else None,
    )
