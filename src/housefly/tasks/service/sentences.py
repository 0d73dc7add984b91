"""What becomes of a sentence: understood, answered, and done what it asks for."""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from threading import Lock
from typing import Any, Protocol

from housefly.errors import ConfigError, HouseflyError, TaskError
from housefly.hub.client.room_queries import AskedRoom
from housefly.messages import OrderKind
from housefly.messages.words import literal
from housefly.tasks.api.answers import SentenceAnswer
from housefly.tasks.api.questions import BoardQuestion, Sentence, SetMode, TakePhoto, TaskQuestion
from housefly.tasks.api.values import ATTENDED, ReasonCode, TaskRequest, TaskStage, TaskStatus
from housefly.tasks.engine.drone_state import LandedState
from housefly.tasks.intents.answer_tasks import words_of_answer
from housefly.tasks.intents.answering import answer_intent
from housefly.tasks.intents.intent import LANGUAGES, Intent, Language
from housefly.tasks.intents.intent_reply import IntentReply, Notice, TaskAct
from housefly.tasks.intents.names import Names, names_of
from housefly.tasks.intents.not_understood import NotUnderstood, Recognition
from housefly.tasks.intents.phrases import Phrases, phrases
from housefly.tasks.intents.recognizer import recognize, recognizer
from housefly.tasks.service.drone_named import drone_named

_log = logging.getLogger(__name__)

_NAMES_AGE = 5.0
"""Names of the room are asked for again after this [s]."""
_MAY_BE_ANOTHER = frozenset({ReasonCode.NOT_UNDERSTOOD, ReasonCode.UNKNOWN_THING})
"""Why a sentence of another language is not understood."""
_SAFER = frozenset({OrderKind.STOP, OrderKind.LAND})
"""Orders of people who may not fly."""
_PLACES = {
    LandedState.IN_AIR: "drone_flies",
    LandedState.ON_GROUND: "drone_stands",
    LandedState.UNKNOWN: "drone_unknown",
}


class TaskActing(Protocol):
    """Does something with the task that flies, or is next; None when there is none."""

    def __call__(
        self, act: TaskAct, by: str, only_of: str = "", drone: str = ""
    ) -> TaskStatus | None:
        """Do it; ``only_of`` is the id of whose tasks count, ``drone`` with which; "" for all."""
        ...


@dataclass(frozen=True, slots=True)
class SentenceEffects:
    """What a sentence may bring about, as functions of the service.

    Attributes:
        request: asks for a service.
        order: gives an order, in somebody's name, to a drone or to all that it concerns; returns
            where they are.
        act: does something with a task.
        ask: answers another question to the tasks.
        notice: keeps what somebody, an id, wants to be told; False when that is too much.
    """

    request: Callable[[TaskRequest], TaskStatus]
    order: Callable[[OrderKind, str, str], LandedState]
    act: TaskActing
    ask: Callable[[TaskQuestion], Any]
    notice: Callable[[Notice, str], bool]


class Sentences:
    """Answers sentences; thread-safe.

    Args:
        room: the memory.
        effects: what they may bring about.
        wall: Unix time [s].
        names: of the room, until its memory tells more.
        own: folder with sentence files of one's own, or None.
        has_drone: whether a flight can be offered.
        drones: their names; a sentence may name one.
    """

    def __init__(
        self,
        room: AskedRoom,
        effects: SentenceEffects,
        wall: Callable[[], float],
        names: Names,
        own: Path | None = None,
        *,
        has_drone: bool = True,
        drones: Iterable[str] = (),
    ) -> None:
        self._has_drone, self._drones = has_drone, tuple(drones)
        self._room, self._do, self._wall, self._own = room, effects, wall, own
        self._names, self._names_at = names, float("-inf")
        self._lock = Lock()

    def answer(self, sentence: Sentence) -> SentenceAnswer:
        """Return what became of a sentence; raises TaskError when its task is refused."""
        text, drone = drone_named(sentence.text, self._drones)
        sentence = replace(sentence, text=text, drone=drone or sentence.drone)
        own = self._own_sentences(sentence.language)
        # STOP waits for no memory.
        is_stop = recognizer(sentence.language, own).is_only_stop(sentence.text)
        names = self._names if is_stop else self._names_now()
        meant = recognize(sentence.text, sentence.language, names, own)
        if isinstance(meant, NotUnderstood) and meant.code in _MAY_BE_ANOTHER:
            meant = self._in_another_language(meant, names)
        if isinstance(meant, NotUnderstood):
            return SentenceAnswer(
                False, "", literal(meant.words), suggestions=meant.suggestions, code=meant.code
            )
        if meant.language != sentence.language:
            sentence = replace(sentence, language=meant.language)
            own = self._own_sentences(meant.language)
        reply = answer_intent(meant, names, self._room, self._wall(), own)
        if reply.offer is not None and not self._has_drone:
            reply = replace(reply, words=reply.without_offer, offer=None)
        answer = SentenceAnswer(True, meant.intent.value, literal(reply.words), meant.given())
        try:
            return self._done(answer, reply, sentence, meant)
        except TaskError as error:
            raise TaskError(_refusal(sentence.language, error), error.code) from error

    def _done(
        self, answer: SentenceAnswer, reply: IntentReply, sentence: Sentence, meant: Intent
    ) -> SentenceAnswer:
        say = phrases(sentence.language)
        objection = _objection(reply, sentence)
        if objection == "only_who_may_fly" and reply.act is TaskAct.CANCEL and sentence.owner:
            task = self._do.act(TaskAct.CANCEL, _by(sentence), sentence.owner, sentence.drone)
            if task is not None:
                return replace(answer, task=task)
        if objection:
            code = ReasonCode.NOT_ALLOWED
            return replace(answer, words=literal(say(objection)), code=code)
        if reply.order is not None:
            place = self._do.order(reply.order, _by(sentence), sentence.drone)
            return replace(answer, words=literal(say.joined(reply.words, say(_PLACES[place]))))
        if reply.request is not None:
            return _asked(answer, self._do.request(_of(reply.request, sentence)), say)
        if reply.offer is not None and sentence.fly:
            return replace(answer, offer=replace(_of(reply.offer, sentence), owner=""))
        if reply.act is not None:
            task = self._do.act(reply.act, _by(sentence), drone=sentence.drone)
            return (
                replace(answer, task=task)
                if task
                else replace(answer, words=literal(say("no_task")))
            )
        if reply.notice is not None:
            is_kept = self._do.notice(reply.notice, sentence.owner or _by(sentence))
            return answer if is_kept else replace(answer, words=literal(say("too_many_notices")))
        if isinstance(reply.question, SetMode):
            self._do.ask(replace(reply.question, by=_by(sentence)))
        elif reply.question is not None:
            question = reply.question
            if isinstance(question, TakePhoto):
                question = replace(question, drone=sentence.drone)
            found = self._do.ask(question)
            words = words_of_answer(meant, found, self._names, self._wall(), self._own)
            return replace(answer, words=literal(words))
        return answer

    def _in_another_language(self, meant: NotUnderstood, names: Names) -> Recognition:
        """Return what a sentence means in another language than that of the page, if anything.

        Whoever reads a page in one language may speak another: they are answered in that.
        """
        for language in LANGUAGES:
            if language == meant.language:
                continue
            own = self._own_sentences(language)
            found = recognize(meant.sentence, language, names, own)
            if isinstance(found, Intent):
                return found
            is_nearer = found.code is ReasonCode.UNKNOWN_THING and not meant.suggestions
            if is_nearer and meant.code is ReasonCode.NOT_UNDERSTOOD:
                meant = found
        return meant

    def _own_sentences(self, language: Language) -> Path | None:
        """Return the folder of one's own sentences, None when a file there is wrong.

        A wrong file takes nobody the sentences that are shipped, STOP least of all.
        """
        try:
            recognizer(language, self._own)
        except ConfigError as error:
            _log.error("own sentences are left aside until the next start: %s", error)
            self._own = None
        return self._own

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


def _objection(reply: IntentReply, sentence: Sentence) -> str:
    """Return the phrase that says why what a sentence asks for is not done, "" when it is."""
    is_person = sentence.surface in ATTENDED
    if reply.order is OrderKind.STOP:
        return ""
    if not sentence.fly and _changes(reply):
        return "nothing_started"
    if not sentence.may_fly and _needs_who_may_fly(reply):
        return "only_who_may_fly"
    if is_person:
        return ""
    # Orders, the mode of the house, pictures, and to go on after a pause, are for people.
    of_people = reply.order is not None or reply.act is TaskAct.CONTINUE
    is_private = reply.question is not None and not isinstance(reply.question, BoardQuestion)
    return "only_people" if of_people or is_private else ""


def _changes(reply: IntentReply) -> bool:
    """Return whether a reply does more than to answer."""
    done = (reply.request, reply.act, reply.order, reply.notice)
    return any(one is not None for one in done) or isinstance(reply.question, SetMode)


def _needs_who_may_fly(reply: IntentReply) -> bool:
    """Return whether a reply acts on what flies, or on the house."""
    orders = reply.order is not None and reply.order not in _SAFER
    return orders or reply.act is not None or isinstance(reply.question, SetMode)


def _asked(answer: SentenceAnswer, task: TaskStatus, say: Phrases) -> SentenceAnswer:
    """Return an answer with its task; while somebody must say yes, it says so."""
    if task.state is TaskStage.WAITING:
        answer = replace(answer, words=literal(say("waits_for_yes")))
    return replace(answer, task=task)


def _refusal(language: Language, error: TaskError) -> str:
    """Return why a task is refused, in the language of who asked."""
    key = f"reason {error.code}"
    texts = phrases(language).texts
    return str(error) if language == "en" or key not in texts else texts[key]


def _by(sentence: Sentence) -> str:
    return sentence.by or sentence.surface.value


def _of(request: TaskRequest, sentence: Sentence) -> TaskRequest:
    """Return a request in the name of whoever said the sentence."""
    return replace(
        request,
        asked_by=sentence.by,
        surface=sentence.surface,
        confirm=sentence.confirm,
        owner=sentence.owner,
        drone=sentence.drone,
        sentence=sentence.text,
    )
