"""Asks hub and tasks what is not told by itself: how sensors do, what devices reported last."""

from __future__ import annotations

import threading
from collections.abc import Iterable
from contextlib import suppress
from typing import Any

from housefly.bus.bus import Bus
from housefly.bus.topics import HUB_QUERY, TASKS_QUERY
from housefly.clock import Clock
from housefly.errors import LinkError, ThingError
from housefly.homeassistant.home_view import HomeView
from housefly.hub.api.answers import SensorsAnswer, WhereAnswer
from housefly.hub.api.json import answer_from_json, question_to_json
from housefly.hub.api.questions import PictureQuestion, Question, SensorsQuestion, WhereQuestion
from housefly.tasks.api.json import task_answer_from_json, task_question_to_json
from housefly.tasks.api.questions import BoardQuestion

_PATIENCE = 2.0
_SENSORS_PERIOD, _REPORTS_PERIOD = 2.0, 10.0
"""How often sensors and unchanged devices are asked about [s]."""
_TOUCHED_PERIOD = 0.5
"""A device that reports all the time is asked about at most so often [s]."""
_AT_ONCE = 20
"""So many devices are asked about at a time; who has waited longest goes first."""


class RoomReader:
    """Keeps a view current; ``read`` blocks, the rest is safe from any thread.

    Args:
        bus: where hub and tasks are.
        view: what is kept current.
        clock: for the periods.
        has_tasks: whether there are tasks to ask.
    """

    def __init__(self, bus: Bus, view: HomeView, clock: Clock, *, has_tasks: bool) -> None:
        self._bus, self._view, self._clock, self._has_tasks = bus, view, clock, has_tasks
        self._sensors_at = self._picture_at = float("-inf")
        self._asked_at: dict[str, float] = {}
        self._lock = threading.Lock()
        self._touched: set[str] = set()

    def touch(self, things: Iterable[str]) -> None:
        """Tell which things or devices have reported something."""
        with self._lock:
            self._touched.update(things)

    def read(self) -> None:
        """Ask what is due; raises HouseflyError while nobody answers."""
        now = self._clock.now()
        if now - self._sensors_at >= _SENSORS_PERIOD:
            self._sensors_at = now
            self._read_board()
            found: SensorsAnswer = self._ask(SensorsQuestion())
            self._view.hear_sensors(found.sensors)
        if now - self._picture_at >= _REPORTS_PERIOD:
            self._picture_at = now
            self._view.hear_situations(self._ask(PictureQuestion()).situations)
        for device in self._due(now):
            self._asked_at[device] = now
            self._read_report(device)

    def _due(self, now: float) -> list[str]:
        """Return the devices to ask about now; what came too soon after the last stays touched."""
        ages = {one: now - self._asked_at.get(one, float("-inf")) for one in self._view.devices}
        with self._lock:
            due = [
                one
                for one, age in sorted(ages.items(), key=lambda known: -known[1])
                if age >= (_TOUCHED_PERIOD if one in self._touched else _REPORTS_PERIOD)
            ][:_AT_ONCE]
            self._touched = (self._touched & ages.keys()) - set(due)
        return due

    def _read_report(self, device: str) -> None:
        try:
            found: WhereAnswer = self._ask(WhereQuestion(device))
        except ThingError:  # it has reported nothing yet
            self._view.hear_source(device, None)
            return
        source = next((one for one in found.said if one.source == device), None)
        self._view.hear_source(device, source)

    def _read_board(self) -> None:
        """Ask for the board; silence is noticed by its age."""
        question = BoardQuestion()
        with suppress(LinkError):
            if self._has_tasks:
                text = self._bus.ask(TASKS_QUERY, task_question_to_json(question), _PATIENCE)
                self._view.hear_board(task_answer_from_json(question, text))

    def _ask(self, question: Question) -> Any:
        text = self._bus.ask(HUB_QUERY, question_to_json(question), _PATIENCE)
        return answer_from_json(question, text)
