"""What becomes of a sentence: understood, answered, and done what it asks for."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from threading import Lock
from typing import Any

from housefly.errors import HouseflyError
from housefly.messages import OrderKind
from housefly.tasks.api.answers import SentenceAnswer
from housefly.tasks.api.questions import (
    BoardQuestion,
    CancelTask,
    Sentence,
    SetMode,
    TaskQuestion,
)
from housefly.tasks.api.values import RequestSurface, TaskRequest, TaskStatus
from housefly.tasks.asked_room import AskedRoom
from housefly.tasks.intents.answer_tasks import words_of_answer
from housefly.tasks.intents.answering import answer_intent
from housefly.tasks.intents.intent import Intent
from housefly.tasks.intents.intent_reply import IntentReply, Notice, TaskAct
from housefly.tasks.intents.names import Names, names_of
from housefly.tasks.intents.not_understood import NotUnderstood
from housefly.tasks.intents.recognizer import recognize
from housefly.tasks.person_sender import person_sender

_NAMES_AGE = 5.0
"""Names of the room are asked for again after this [s]."""
_PEOPLE = frozenset({RequestSurface.CONSOLE, RequestSurface.COMMAND_LINE, RequestSurface.HTTP})
"""Where people ask."""
_ALWAYS = frozenset({OrderKind.STOP})
"""Orders that a sentence gives even where it may start nothing."""
_SAFER = frozenset({OrderKind.STOP, OrderKind.LAND})
"""Orders of people who may not fly."""


class SentenceEffects:
    """What a sentence may bring about, as functions of the service.

    Attributes:
        request: asks for a service.
        order: gives the pilot an order, in somebody's name.
        act: does something with the task that flies, or is next; None when there is none.
        ask: answers another question to the tasks.
        notice: keeps what somebody wants to be told.
    """

    def __init__(
        self,
        request: Callable[[TaskRequest], TaskStatus],
        order: Callable[[OrderKind, str], None],
        act: Callable[[TaskAct, str], TaskStatus | None],
        ask: Callable[[TaskQuestion], Any],
        notice: Callable[[Notice], None],
    ) -> None:
        self.request, self.order, self.act = request, order, act
        self.ask, self.notice = ask, notice


class Sentences:
    """Answers sentences; thread-safe.

    Args:
        room: the memory.
        effects: what they may bring about.
        wall: Unix time [s].
        names: of the room, until its memory tells more.
        own: folder with sentence files of one's own, or None.
    """

    def __init__(
        self,
        room: AskedRoom,
        effects: SentenceEffects,
        wall: Callable[[], float],
        names: Names,
        own: Path | None = None,
    ) -> None:
        self._room, self._do, self._wall, self._own = room, effects, wall, own
        self._names, self._names_at = names, float("-inf")
        self._lock = Lock()

    def answer(self, sentence: Sentence) -> SentenceAnswer:
        """Return what became of a sentence; raises TaskError when its task is refused."""
        names = self._names_now()
        meant = recognize(sentence.text, sentence.language, names, self._own)
        if isinstance(meant, NotUnderstood):
            return SentenceAnswer(False, "", meant.words, suggestions=meant.suggestions)
        reply = answer_intent(meant, names, self._room, self._wall(), self._own)
        answer = SentenceAnswer(True, meant.intent.value, reply.words, meant.given())
        return self._done(answer, reply, sentence, meant)

    def _done(
        self, answer: SentenceAnswer, reply: IntentReply, sentence: Sentence, meant: Intent
    ) -> SentenceAnswer:
        by = sentence.by or sentence.surface.value
        is_person = sentence.surface in _PEOPLE
        if not sentence.may_fly and sentence.fly and _needs_who_may_fly(reply):
            return self._ended_own(answer, reply, sentence.by)
        if reply.order is not None and (reply.order in _ALWAYS or (sentence.fly and is_person)):
            self._do.order(reply.order, person_sender(by))
        if not sentence.fly:
            return answer
        if reply.request is not None:
            return replace(answer, task=self._do.request(_of(reply.request, sentence)))
        if reply.offer is not None:
            return replace(answer, offer=_of(reply.offer, sentence))
        if not is_person and (reply.question is not None or reply.act is TaskAct.CONTINUE):
            # The mode of the house, and to go on after a pause, are for people.
            return replace(answer, words=_ONLY_PEOPLE)
        if reply.act is not None:
            task = self._do.act(reply.act, by)
            return replace(answer, task=task) if task else replace(answer, words=_NO_TASK)
        if reply.notice is not None:
            self._do.notice(reply.notice)
        if isinstance(reply.question, SetMode):
            self._do.ask(replace(reply.question, by=by))
        elif reply.question is not None:
            found = self._do.ask(reply.question)
            words = words_of_answer(meant, found, self._names, self._wall(), self._own)
            return replace(answer, words=words)
        return answer

    def _ended_own(self, answer: SentenceAnswer, reply: IntentReply, by: str) -> SentenceAnswer:
        """Let somebody who may not fly end a task that he asked for, and nothing else."""
        tasks = self._do.ask(BoardQuestion()).tasks if reply.act is TaskAct.CANCEL and by else ()
        own = next((task.id for task in tasks if task.asked_by == by), None)
        if own is None:
            return replace(answer, words=_ONLY_WHO_MAY_FLY)
        return replace(answer, task=self._do.ask(CancelTask(own, by)).tasks[0])

    def _names_now(self) -> Names:
        """Return the names of the room; old ones where nobody answers."""
        with self._lock:
            now = self._wall()
            if not 0.0 <= now - self._names_at <= _NAMES_AGE:
                try:
                    self._names, self._names_at = names_of(self._room.things()), now
                except HouseflyError:
                    self._names_at = now
            return self._names


_NO_TASK = "no task is open"
_ONLY_PEOPLE = "only a person may do that"
_ONLY_WHO_MAY_FLY = "ask somebody who may fly, or press cancel at your own task"


def _needs_who_may_fly(reply: IntentReply) -> bool:
    """Return whether a reply acts on what flies, or on the house."""
    orders = reply.order is not None and reply.order not in _SAFER
    return orders or reply.act is not None or isinstance(reply.question, SetMode)


def _of(request: TaskRequest, sentence: Sentence) -> TaskRequest:
    """Return a request in the name of whoever said the sentence."""
    return replace(
        request,
        asked_by=sentence.by,
        surface=sentence.surface,
        confirm=sentence.confirm,
    )
