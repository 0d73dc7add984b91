"""Answers every question to the tasks, JSON in and out, and drives what flies. Needs no bus.

The parts do the work: library, queue and runs, rules, clips, intents. Here stands who is asked.
"""

from __future__ import annotations

import logging
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from secrets import token_hex
from threading import Lock
from typing import Any

from housefly.errors import HouseflyError, TaskError
from housefly.evidence.clip_recorder import ClipRecorder
from housefly.evidence.clip_result import KEPT, ClipOrigin, ClipOutcome
from housefly.evidence.clip_values import (
    ClipsAnswer,
    ClipsQuestion,
    DeleteClip,
    KeepClip,
    TakeSnapshot,
)
from housefly.hub.client.room_queries import AskedRoom
from housefly.messages import Order, OrderKind
from housefly.messages.order_fault import NAME_LENGTH_MAX
from housefly.messages.words import Words, joined, literal
from housefly.tasks.api.answers import (
    FiringsAnswer,
    ModeAnswer,
    RehearsalAnswer,
    SentenceAnswer,
    ServicesAnswer,
    TaskAnswer,
    TaskBoard,
    TasksAnswer,
)
from housefly.tasks.api.json import (
    task_answer_to_json,
    task_question_from_json,
    task_refusal_to_json,
)
from housefly.tasks.api.questions import (
    BoardQuestion,
    CancelTask,
    ChangeRule,
    ContinueTask,
    DryRunQuestion,
    PauseTask,
    RehearseTask,
    ReplyToTask,
    RequestTask,
    RulesQuestion,
    Sentence,
    ServicesQuestion,
    SetMode,
    TakePhoto,
    TaskHistoryQuestion,
    TaskQuestion,
    Webhook,
)
from housefly.tasks.api.values import ATTENDED, ReasonCode, RequestSurface, TaskRequest, TaskStatus
from housefly.tasks.document.open_library import NO_DRONE, OpenLibrary
from housefly.tasks.document.task_document import BoundTask
from housefly.tasks.engine.drone_state import (
    LandedState,
    drone_words,
    landed_state,
)
from housefly.tasks.engine.task_actions import TaskActions
from housefly.tasks.engine.task_drones import TaskDrone, TaskDrones
from housefly.tasks.engine.task_engine import TaskEngine
from housefly.tasks.engine.task_outlet import TaskOutlet
from housefly.tasks.engine.task_rehearsals import TaskRehearsals
from housefly.tasks.execution.step_inbox import StepInbox
from housefly.tasks.intents.intent_reply import TaskAct
from housefly.tasks.intents.names import Names
from housefly.tasks.intents.stop_words import says_stop
from housefly.tasks.rules.dry_run import dry_run, stored_events
from housefly.tasks.rules.room_facts import AskedRoomFacts
from housefly.tasks.rules.rule_service import RuleService
from housefly.tasks.rules.trigger import WebhookTrigger
from housefly.tasks.scheduler.task_store import TaskStore
from housefly.tasks.scheduler.values import DroneAvailability
from housefly.tasks.service.rule_desk import RuleDesk
from housefly.tasks.service.sentences import SentenceEffects, Sentences
from housefly.tasks.service.task_desk import TaskDesk

_log = logging.getLogger(__name__)

_PHOTO_PATIENCE = 3.0
"""How long a person waits for the disk to keep a photo [s]."""

AT_ONCE = 20
"""So many requests, sentences and rehearsals of one surface after a pause."""
_PERIOD = 3.0
"""Then one more each [s]."""


@dataclass(frozen=True, slots=True)
class ServiceParts:
    """What the service is made of.

    Attributes:
        library: task documents by name, and what is wrong with one's own.
        engine: queue and runs.
        store: of the queue and the history.
        rehearsals: in lock step.
        actions: does and tells.
        drones: their pilots' steps, and the recorders of their cameras.
        rules: with the mode of the house.
        room: the memory.
        outlet: orders and events go out here.
        names: of the room, until its memory tells more.
        own_sentences: folder with sentence files of one's own, or None.
        has_drone: whether there is a drone.
    """

    library: OpenLibrary
    engine: TaskEngine
    store: TaskStore
    rehearsals: TaskRehearsals
    actions: TaskActions
    drones: TaskDrones
    rules: RuleService
    room: AskedRoom
    outlet: TaskOutlet
    names: Names
    own_sentences: Path | None = None
    has_drone: bool = True

    @property
    def inbox(self) -> StepInbox:
        """The steps of the first drone's pilot."""
        return self.drones.first.inbox

    @property
    def clips(self) -> ClipRecorder:
        """The first drone's recorder; the index is of all."""
        return self.drones.first.clips


class TaskService:
    """Answers from any thread; ``tick`` is called by one, at 10 to 20 Hz.

    Args:
        parts: what it is made of.
        clock: the pilot's clock [s].
        wall: Unix time [s].

    Attributes:
        desk: takes requests; the rules hear of triggers there.
    """

    def __init__(
        self, parts: ServiceParts, clock: Callable[[], float], wall: Callable[[], float]
    ) -> None:
        self._parts, self._clock, self._wall = parts, clock, wall
        self._pace = _RequestRate(clock)
        self.desk = TaskDesk(
            parts.library,
            parts.engine,
            parts.rules,
            parts.outlet,
            parts.store,
            wall,
            parts.drones,
        )
        effects = SentenceEffects(
            self.desk.request,
            self._order,
            self._act,
            self._ask,
            self.desk.notices.add,
        )
        self._sentences = Sentences(
            parts.room,
            effects,
            wall,
            parts.names,
            parts.own_sentences,
            has_drone=parts.has_drone,
            drones=parts.drones,
        )
        rule_desk = RuleDesk(parts.rules, parts.library, parts.room)
        self._by: dict[type[TaskQuestion], Callable[[Any], TaskAnswer]] = {
            RequestTask: self._request,
            RehearseTask: self._rehearse,
            ReplyToTask: self._reply,
            CancelTask: self._cancel,
            PauseTask: self._pause,
            ContinueTask: self._continue,
            BoardQuestion: lambda _: self.board(),
            ServicesQuestion: self._services,
            TaskHistoryQuestion: self._history,
            Sentence: self._sentence,
            SetMode: self._set_mode,
            RulesQuestion: rule_desk.answer,
            ChangeRule: rule_desk.change,
            DryRunQuestion: self._dry_run,
            ClipsQuestion: parts.clips.index.answer,
            Webhook: self._webhook,
            KeepClip: parts.clips.index.answer,
            DeleteClip: parts.clips.index.answer,
            TakePhoto: self._photo,
        }
        parts.engine.restore(self._bound, wall())

    def answer(self, text: str) -> str:
        """Return the answer to a question, both JSON; a refusal says why. Never raises."""
        try:
            return task_answer_to_json(self._ask(task_question_from_json(text)))
        except HouseflyError as error:
            return task_refusal_to_json(error)
        except Exception:
            _log.exception("a question could not be answered: %s", text[:500])
            return task_refusal_to_json(
                HouseflyError("the tasks could not answer that; their log says why")
            )

    def tick(self) -> None:
        """Do what is to be done now."""
        parts, now, unix = self._parts, self._clock(), self._wall()
        available = tuple(
            drone.availability(now)
            if parts.has_drone
            else DroneAvailability(False, literal(NO_DRONE), drone.name)
            for drone in parts.drones.values()
        )
        with self.desk.lock:
            parts.engine.tick(available, now, unix)
            for drone in parts.drones.values():
                self._tick_clips(drone, now, unix)

    def _tick_clips(self, drone: TaskDrone, now: float, unix: float) -> None:
        parts, status = self._parts, drone.inbox.fresh_status(now)
        for news in drone.clips.tick(now, unix, status, parts.rules.mode):
            if news.outcome not in KEPT:
                parts.engine.drop_clip(news.clip, news.words)
                continue
            task = parts.actions.tell_clip(drone, news.clip, unix)
            words = news.words if news.outcome is ClipOutcome.CUT_OFF else ""
            parts.engine.keep_clip(task, news.clip, words)

    def board(self) -> TaskBoard:
        """Return everything that a screen of the tasks shows."""
        parts = self._parts
        with self.desk.lock:
            return TaskBoard(
                self._wall(),
                parts.rules.mode,
                self._drone_words() if parts.has_drone else literal(NO_DRONE),
                any(drone.clips.is_recording for drone in parts.drones.values()),
                parts.engine.open,
                parts.engine.ended,
                self._notices(),
            )

    def _drone_words(self) -> Words:
        """Return what each drone does; the only one has no need of a name."""
        drones, now = self._parts.drones, self._clock()
        told = {one.name: drone_words(one.inbox, one.readiness, now) for one in drones.values()}
        if len(told) == 1:
            return told[drones.first.name]
        named = [joined(": ", (literal(name), words)) for name, words in told.items()]
        return joined("; ", named)

    def close(self, words: str) -> None:
        """End what runs, sending home what flies; then close clips and store."""
        parts = self._parts
        with self.desk.lock:
            parts.engine.close(words, self._clock(), self._wall())
            for drone in parts.drones.values():
                drone.clips.close()
            parts.store.close()

    def _notices(self) -> tuple[str, ...]:
        clips, engine = self._parts.clips, self._parts.engine
        unkept = f"the queue is not kept: {engine.problem}" if engine.problem else ""
        found = (*clips.index.notices, clips.problem, unkept)
        return tuple(words for words in found if words)

    def _ask(self, question: TaskQuestion) -> TaskAnswer:
        # STOP never waits for anything, whoever says it.
        if not (isinstance(question, Sentence) and says_stop(question.text)):
            self._pace.spend(getattr(question, "surface", RequestSurface.CONSOLE))
        return self._by[type(question)](question)

    def _bound(self, request: TaskRequest) -> BoundTask:
        return self.desk.bound(request.service, request.parameters)

    def _request(self, question: RequestTask) -> TasksAnswer:
        request = TaskRequest(
            question.service,
            dict(question.parameters),
            question.by,
            question.surface,
            question.cause,
            question.confirm,
            question.priority,
            question.deadline,
            question.owner,
            question.drone,
        )
        return TasksAnswer((self.desk.request(request),))

    def _rehearse(self, question: RehearseTask) -> RehearsalAnswer:
        task = self.desk.bound(question.service, question.parameters)
        self._parts.drones.check(question.drone)
        report = self._parts.rehearsals.rehearse_and_wait(task, question.surface, question.drone)
        return RehearsalAnswer(report)

    def _reply(self, question: ReplyToTask) -> TasksAnswer:
        with self.desk.lock:
            return TasksAnswer(
                (
                    self._parts.engine.reply(
                        question.task,
                        question.question,
                        question.choice,
                        question.by,
                        self._wall(),
                    ),
                )
            )

    def _cancel(self, question: CancelTask) -> TasksAnswer:
        with self.desk.lock:
            ended = self._parts.engine.cancel(
                question.task, question.by, self._wall(), question.only_of
            )
        return TasksAnswer(ended)

    def _pause(self, question: PauseTask) -> TasksAnswer:
        with self.desk.lock:
            return TasksAnswer(
                (self._parts.engine.pause(question.task, question.by, self._wall()),)
            )

    def _continue(self, question: ContinueTask) -> TasksAnswer:
        with self.desk.lock:
            return TasksAnswer(
                (self._parts.engine.resume(question.task, question.by, self._wall()),)
            )

    def _services(self, _: ServicesQuestion) -> ServicesAnswer:
        return ServicesAnswer(self._parts.library.services())

    def _history(self, question: TaskHistoryQuestion) -> TasksAnswer:
        with self.desk.lock:
            kept = self._parts.store.history(question)
            now = {task.id: task for task in (*self._parts.engine.open, *self._parts.engine.ended)}
        return TasksAnswer(tuple(now.get(task.id, task) for task in kept))

    def _sentence(self, question: Sentence) -> SentenceAnswer:
        return self._sentences.answer(question)

    def _set_mode(self, question: SetMode) -> ModeAnswer:
        change = self._parts.rules.set_mode(question.mode, question.by, self._wall())
        with self.desk.lock:
            self._parts.engine.change_mode(question.mode, self._wall())
        if change.event is not None:
            self._parts.outlet.tell(change.event)
        return change.answer

    def _dry_run(self, question: DryRunQuestion) -> FiringsAnswer:
        rules, room = self._parts.rules, self._parts.room
        until = self._wall() if question.until is None else question.until
        events = stored_events(room.ask, question.since, until)
        facts = AskedRoomFacts(room.ask, live=False)
        engine = rules.engine
        if question.off:
            on = (rule.model_copy(update={"enabled": True}) for rule in engine.rules)
            engine = engine.with_rules(on)
        return dry_run(engine, events, question.since, until, rules.mode, facts)

    def _photo(self, question: TakePhoto) -> ClipsAnswer:
        self._refuse_without_drone()
        drones = self._parts.drones
        self._parts.drones.check(question.drone)
        drone = drones.or_first(question.drone)
        clips, step = drone.clips, drone.looking_step
        wanted = TakeSnapshot(step.outputs.goal_name if step is not None else "")
        name = clips.snapshot(wanted, ClipOrigin(cause=question.by), question.at or None)
        clips.flush(_PHOTO_PATIENCE)
        try:
            return ClipsAnswer((clips.index.info(name),))
        except TaskError as error:
            words = "the photo could not be kept: the log of the tasks says why"
            raise TaskError(words, ReasonCode.NOT_READY.value) from error

    def _webhook(self, question: Webhook) -> FiringsAnswer:
        decisions = self.desk.heard(WebhookTrigger(question.name, self._wall(), question.by))
        return FiringsAnswer(tuple(decision.firing for decision in decisions))

    def _refuse_without_drone(self) -> None:
        if not self._parts.has_drone:
            raise TaskError(NO_DRONE, ReasonCode.NO_DRONE.value)

    def _order(self, kind: OrderKind, by: str, drone: str) -> LandedState:
        """Give an order of a person, for which the tasks make way; return what is true.

        The order is not done yet then: the pilot tells what became of it. Without a drone's name it
        is for all; what is not STOP is for those that may be in the air.
        """
        self._refuse_without_drone()
        self._parts.drones.check(drone)
        now, drones = self._clock(), self._parts.drones
        places = {
            name: landed_state(one.inbox, now)
            for name, one in drones.items()
            if drone in ("", name)
        }
        up = [name for name, place in places.items() if place is not LandedState.ON_GROUND]
        for name in places if kind is OrderKind.STOP or not up else up:
            sender, order_id = by[:NAME_LENGTH_MAX], token_hex(6)
            order = Order(kind, issued_at=now, sender=sender, id=order_id)
            self._parts.outlet.order(order, name)
        found = set(places.values())
        worst_first = (LandedState.IN_AIR, LandedState.UNKNOWN, LandedState.ON_GROUND)
        return next(place for place in worst_first if place in found)

    def _act(self, act: TaskAct, by: str, only_of: str = "", drone: str = "") -> TaskStatus | None:
        """Cancel, pause or continue the task that flies, or is next; None when there is none."""
        with self.desk.lock:
            engine = self._parts.engine
            task = engine.meant_task(only_of, drone)
            if task is None:
                return None
            unix = self._wall()
            match act:
                case TaskAct.CANCEL:
                    return engine.cancel(task, by, unix)[0]
                case TaskAct.PAUSE:
                    return engine.pause(task, by, unix)
                case TaskAct.CONTINUE:
                    return engine.resume(task, by, unix)


class _RequestRate:
    """A bucket of requests a surface on which nobody may be looking; thread-safe.

    Args:
        clock: monotonic time [s].
    """

    def __init__(self, clock: Callable[[], float]) -> None:
        self._clock, self._lock = clock, Lock()
        self._left: dict[RequestSurface, tuple[float, float]] = {}

    def spend(self, surface: RequestSurface) -> None:
        """Count a request; raises TaskError RATE_LIMIT when it is one too many."""
        if surface in ATTENDED:
            return
        with self._lock:
            now = self._clock()
            left, since = self._left.get(surface, (float(AT_ONCE), now))
            left = min(AT_ONCE, left + (now - since) / _PERIOD)
            is_over = left < 1.0
            self._left[surface] = (left if is_over else left - 1.0), now
        if is_over:
            words = f"too many requests over {surface.value}; wait {_PERIOD:.0f} s"
            raise TaskError(words, ReasonCode.RATE_LIMIT.value)
