"""The doorbell of a simulated room: the console presses it, and tells what the house does.

A room with real hardware has its own bell, and nobody rings there from a page.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

from housefly.bus.bus import Bus
from housefly.bus.simulated_bell import BELL_QUERY, BELL_WEBHOOK, BellPress, press_from_json
from housefly.bus.topics import TASKS_QUERY
from housefly.errors import HouseflyError
from housefly.tasks.api.answers import FiringsAnswer, RulesAnswer
from housefly.tasks.api.json import task_answer_from_json, task_question_to_json
from housefly.tasks.api.questions import RulesQuestion, Webhook
from housefly.tasks.rules.rule_engine import ASKS_FIRST, ASKS_FOR_TASK

_EVENT = "bell pressed/"
"""How the cause of whatever a bell sets off begins."""
_CALLER = "the simulated doorbell"
_SILENT = "the services of the house do not answer"
_TWIN_TIMEOUT, _TASKS_TIMEOUT = 3.0, 2.0
"""How long the simulated room and the tasks may take to answer [s]."""
_REACTION_TIMEOUT, _REACTION_PERIOD = 8.0, 0.3
"""How long after the press the house may take to do something [s], and how often it is asked."""


@dataclass(frozen=True, slots=True)
class BellView:
    """The simulated bell.

    Attributes:
        simulated: whether there is one.
        rung: whether it was pressed just now.
        words: what came of it, or why it was not pressed.
    """

    simulated: bool
    rung: bool = False
    words: str = ""


class SimulatedBell:
    """Presses the bell; all methods block, and are safe from any thread.

    Args:
        bus: where the simulated room and the tasks are.
        wall: reads Unix time [s].
    """

    def __init__(self, bus: Bus, wall: Callable[[], float] = time.time) -> None:
        self._bus, self._wall = bus, wall

    def press(self) -> BellView:
        """Let a visitor ring, and wait for what the rules of the house do about it."""
        try:
            press = press_from_json(self._bus.ask(BELL_QUERY, "", _TWIN_TIMEOUT))
        except HouseflyError:
            return BellView(True, False, "the simulated room does not answer")
        if not press.pressed:
            return BellView(True, False, press.words)
        came = self._reaction(press) if press.has_wire else self._told(press)
        return BellView(True, True, f"{press.words}; {came}")

    def _reaction(self, press: BellPress) -> str:
        """Return what a rule did because of the bell, which tells the house itself."""
        trouble = "no rule of the house has done anything about it"
        # The wall clock may be set back meanwhile.
        ends = time.monotonic() + 2.0 * _REACTION_TIMEOUT
        while self._wall() < press.at + _REACTION_TIMEOUT and time.monotonic() < ends:
            try:
                for rule in self._rules().rules:
                    is_new = rule.last_at is not None and rule.last_at >= press.at
                    if is_new and rule.last_cause.startswith(_EVENT):
                        return _rule_words(rule.name, rule.last_words)
            except HouseflyError:
                trouble = _SILENT
            time.sleep(_REACTION_PERIOD)
        return trouble

    def _rules(self) -> RulesAnswer:
        question = RulesQuestion()
        text = self._bus.ask(TASKS_QUERY, task_question_to_json(question), _TASKS_TIMEOUT)
        answer = task_answer_from_json(question, text)
        assert isinstance(answer, RulesAnswer)
        return answer

    def _told(self, press: BellPress) -> str:
        """Tell the house by a webhook, as a bell without MQTT does; return what the rules did."""
        time.sleep(min(max(0.0, press.at - self._wall()), _REACTION_TIMEOUT))
        question = Webhook(BELL_WEBHOOK, _CALLER)
        try:
            text = self._bus.ask(TASKS_QUERY, task_question_to_json(question), _TASKS_TIMEOUT)
            answer = task_answer_from_json(question, text)
        except HouseflyError:
            return _SILENT
        assert isinstance(answer, FiringsAnswer)
        told = [_rule_words(firing.rule, firing.words) for firing in answer.firings]
        return "; ".join(told) or f"no rule of the house waits for the webhook {BELL_WEBHOOK}"


def _rule_words(rule: str, words: str) -> str:
    """Return what a rule did; why it did nothing is told with its name."""
    return words if words in (ASKS_FIRST, ASKS_FOR_TASK) else f"rule {rule}: {words}"
