"""Sentences and questions from ROS, answered as JSON."""

from __future__ import annotations

import json
from dataclasses import replace
from threading import BoundedSemaphore

from housefly.bus.bus import Bus
from housefly.bus.topics import HUB_QUERY, TASKS_QUERY
from housefly.errors import HouseflyError, TaskError, WireError
from housefly.hub.api.json import question_from_json
from housefly.ros2.ros_caller import FLIGHTS_ARE_OFF, RosCaller
from housefly.tasks.api.json import task_question_from_json, task_question_to_json
from housefly.tasks.api.questions import CancelTask, RequestTask, Sentence
from housefly.tasks.api.values import ReasonCode, RequestSurface
from housefly.tasks.rules.outside_question import outside_question

_MEMORY_PATIENCE = 1.0
"""How long memory may take [s]."""
_TASKS_PATIENCE = 120.0
"""How long the tasks may take, which rehearse first [s]."""
_ASKED_AT_ONCE = 2
"""A rehearsal takes seconds; who waits for one holds up nobody's STOP."""
_NO_QUESTIONS = "you may look, not ask: your role"


class QuestionDesk:
    """Answers one caller; thread-safe.

    Args:
        bus: of the run.
        caller: who asks.
    """

    def __init__(self, bus: Bus, caller: RosCaller) -> None:
        self._bus, self._caller, self._requests = bus, caller, caller.requests
        self._answering = BoundedSemaphore(_ASKED_AT_ONCE)

    def ask(self, text: str) -> str:
        """Return the answer, as JSON, to a sentence or to a question of memory or tasks as JSON."""
        if not self._caller.may_ask:
            return json.dumps({"error": _NO_QUESTIONS})
        if not self._answering.acquire(blocking=False):
            return json.dumps({"error": f"{_ASKED_AT_ONCE} questions are being answered already"})
        try:
            if not text.lstrip().startswith("{"):
                return self._sentence(text)
            return self._question_answered(text)
        except (HouseflyError, ValueError, RecursionError) as error:
            return json.dumps({"error": str(error)})
        finally:
            self._answering.release()

    def _sentence(self, text: str) -> str:
        # Checked like any question from outside: its length, its letters.
        said = task_question_from_json(json.dumps({"ask": "sentence", "text": text}))
        return self._asked_tasks(task_question_to_json(said))

    def _question_answered(self, text: str) -> str:
        tree = json.loads(text)
        if not isinstance(tree, dict):
            raise WireError("this is no JSON object")
        try:
            question_from_json(text)
        except WireError:
            return self._asked_tasks(json.dumps({"ask": "request", **tree}))
        return self._bus.ask(HUB_QUERY, text, _MEMORY_PATIENCE)

    def _asked_tasks(self, text: str) -> str:
        question = outside_question(
            text,
            by=self._caller.name,
            owner=self._caller.owner,
            surface=RequestSurface.ROS,
            is_trusted=self._requests == "auto",
        )
        if self._requests == "off" and isinstance(question, RequestTask):
            raise TaskError(FLIGHTS_ARE_OFF, ReasonCode.NOT_ALLOWED.value)
        if self._requests == "off" and isinstance(question, Sentence):
            question = replace(question, fly=False)
        if isinstance(question, CancelTask) and not self._caller.may_fly:
            question = replace(question, only_of=self._caller.owner)
        return self._bus.ask(TASKS_QUERY, task_question_to_json(question), _TASKS_PATIENCE)
