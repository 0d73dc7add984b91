"""Tasks that fly nothing, behind the same contract as the real ones, for tests of the console."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from housefly.bus.bus import Bus
from housefly.bus.topics import TASKS_QUERY
from housefly.config.house_mode import HouseMode
from housefly.errors import HouseflyError, TaskError
from housefly.evidence.clip_index import ClipIndex
from housefly.evidence.clip_values import ClipInfo, ClipsAnswer, ClipsQuestion, DeleteClip, KeepClip
from housefly.messages.words import Words
from housefly.tasks.api.answers import (
    FiringsAnswer,
    ModeAnswer,
    RehearsalAnswer,
    RuleFiring,
    RulesAnswer,
    RuleStatus,
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
from housefly.tasks.api.topics import TASK_NEWS_TOPIC
from housefly.tasks.api.values import (
    ENDED,
    Confirm,
    ParameterInfo,
    ParameterValue,
    PersonQuestion,
    Priority,
    ReasonCode,
    RehearsalReport,
    RequestSurface,
    ServiceInfo,
    TaskStage,
    TaskStatus,
    TaskStepState,
    TaskStepStatus,
)

SERVICES = (
    ServiceInfo(
        "visitor", "See who is at the door", "Flies to the entrance and films the visitor."
    ),
    ServiceInfo(
        "look",
        "Look at a place or a thing",
        "Flies there, looks, and comes home.",
        (
            ParameterInfo("what", "place_or_thing", "what to look at", required=True),
            ParameterInfo("dwell", "number", "how long to look", "s", 5.0),
            ParameterInfo("record", "flag", "whether to record a clip", "", False),
        ),
    ),
    ServiceInfo("patrol", "Look around everywhere", "Visits every viewpoint of the room."),
    ServiceInfo("where", "Where is a thing", "Says where it was seen last.", flies=False),
)
REHEARSAL = RehearsalReport(
    True,
    ReasonCode.OK,
    "It flies 7.2 m in 41 s, keeps 0.42 m away from everything, and takes 4 % of the battery.",
    ((1.0, 1.0), (6.4, 1.0)),
    41.0,
    0.04,
    0.42,
    11.0,
    0.6,
)
RULE = RuleStatus(
    "bell",
    "when bell pressed: look after a yes",
    True,
    when=Words("When the bell rings"),
    title="Look at a place or a thing",
    modes=(HouseMode.HOME, HouseMode.AWAY),
    parameters=(replace(SERVICES[1].parameters[0], default="entrance"),),
)
_ENDED_SHOWN = 20
STEPS = ("Take off", "Fly to the entrance", "Look at the visitor", "Record", "Come home")


class StandInTasks:
    """Answers as the tasks do; ``advance`` lets what runs take its next step.

    Attributes:
        asked: every question it was asked, oldest first.
        rehearses: not set, rehearsals take long.
        clock_ahead: of the clock of the tasks [s].
        films: whether a photo can be kept.
        rule: the only one.
    """

    def __init__(self, bus: Bus) -> None:
        self._bus, self._lock = bus, threading.RLock()
        self.asked: list[TaskQuestion] = []
        self.rehearses = threading.Event()
        self.rehearses.set()
        self.tasks: dict[int, TaskStatus] = {}
        self.owners: dict[int, str] = {}
        self.mode, self.records, self.films = HouseMode.HOME, False, True
        self.clips: tuple[ClipInfo, ...] = ()
        self.notices: tuple[str, ...] = ()
        self.clock_ahead = 0.0
        self.rule = RULE
        self._answers: dict[type, Callable[[Any], TaskAnswer]] = {
            BoardQuestion: lambda _: self.board(),
            ServicesQuestion: lambda _: ServicesAnswer(SERVICES),
            RequestTask: self._request,
            RehearseTask: self._rehearse,
            ReplyToTask: self._reply,
            CancelTask: self._cancel,
            PauseTask: lambda one: self._turned(one.task, TaskStage.PAUSED),
            ContinueTask: lambda one: self._turned(one.task, TaskStage.RUNNING),
            TaskHistoryQuestion: self._history,
            Sentence: self._sentence,
            SetMode: self._set_mode,
            RulesQuestion: lambda _: RulesAnswer((self.rule,)),
            ChangeRule: self._change_rule,
            DryRunQuestion: lambda one: FiringsAnswer(
                (RuleFiring("bell", one.since, "doorbell rang", "visitor", ReasonCode.OK, "asked"),)
            ),
            ClipsQuestion: self._find_clips,
            Webhook: lambda _: FiringsAnswer(()),
            KeepClip: lambda one: self._clip(one.clip),
            DeleteClip: lambda one: self._clip(one.clip, gone=True),
            TakePhoto: self._photo,
        }
        self._answering = bus.answer(TASKS_QUERY, self.answer, 6)

    def close(self) -> None:
        """Fall silent."""
        self._answering.close()

    def answer(self, text: str) -> str:
        """Answer a question as JSON."""
        try:
            question = task_question_from_json(text)
            self.asked.append(question)
            if isinstance(question, RehearseTask):
                self.rehearses.wait(20.0)
            with self._lock:
                answer = self._answers[type(question)](question)
        except HouseflyError as error:
            return task_refusal_to_json(error)
        if not isinstance(question, BoardQuestion):
            self.tell()
        return task_answer_to_json(answer)

    def tell(self) -> None:
        """Publish the board."""
        self._bus.publish(TASK_NEWS_TOPIC, self.board())

    def board(self) -> TaskBoard:
        """Return what a screen shows."""
        with self._lock:
            every = tuple(self.tasks.values())
            return TaskBoard(
                time.time() + self.clock_ahead,
                self.mode,
                "on the pad",
                self.records,
                tuple(one for one in every if one.state not in ENDED),
                tuple(one for one in every if one.state in ENDED)[::-1][:_ENDED_SHOWN],
                self.notices,
            )

    def ring(self, seconds: float = 60.0) -> TaskStatus:
        """Let the bell ring: a task that asks whether to look."""
        with self._lock:
            question = PersonQuestion(
                "confirm",
                "Someone is at the entrance. Look?",
                ("look", "ignore"),
                time.time() + seconds,
                "ignore",
            )
            task = self._add(
                "visitor",
                {},
                "rule bell",
                RequestSurface.RULE,
                "rule:bell bell pressed/doorbell/doorbell/1795361883.280",
            )
            task = self._put(replace(task, state=TaskStage.WAITING, question=question))
        self.tell()
        return task

    def advance(self, task: int, step: int, *, records: bool = False) -> None:
        """Let a task be at a step; past the last it is done."""
        with self._lock:
            one = self.tasks[task]
            states = [
                TaskStepState.DONE
                if k < step
                else TaskStepState.RUNNING
                if k == step
                else TaskStepState.WAITING
                for k in range(len(STEPS))
            ]
            steps = tuple(
                TaskStepStatus(f"step-{k}", words, state)
                for k, (words, state) in enumerate(zip(STEPS, states, strict=True))
            )
            self.records = records
            self._put(replace(one, state=TaskStage.RUNNING, steps=steps, started_at=time.time()))
        self.tell()

    def finish(
        self, task: int, words: str, clips: tuple[str, ...] = (), flown: float = 0.0
    ) -> None:
        """End a task well, after it was in the air for some time [s]."""
        with self._lock:
            one, self.records = self.tasks[task], False
            steps = tuple(replace(step, state=TaskStepState.DONE) for step in one.steps)
            self._put(
                replace(
                    one,
                    state=TaskStage.DONE,
                    words=words,
                    steps=steps,
                    ended_at=time.time(),
                    clips=clips,
                    report=("The visitor was in view for 9 s.",),
                    took_off_at=one.started_at if flown else None,
                    flown=flown,
                    recording="/home/kim/flight 1" if flown else "",
                    rehearsal=REHEARSAL,
                )
            )
        self.tell()

    def refuse(self, task: int, words: str) -> None:
        """End a task before it flies, as a rehearsal does."""
        with self._lock:
            self._put(
                replace(
                    self.tasks[task],
                    state=TaskStage.REFUSED,
                    code=ReasonCode.NO_WAY,
                    words=words,
                    question=None,
                    ended_at=time.time(),
                )
            )
        self.tell()

    def _history(self, asked: TaskHistoryQuestion) -> TasksAnswer:
        older = [one for one in self.tasks.values() if not asked.before or one.id < asked.before]
        return TasksAnswer(tuple(older[::-1][: asked.limit]))

    def _find_clips(self, asked: ClipsQuestion) -> ClipsAnswer:
        of_task = [one for one in self.clips if asked.task in (0, one.task)]
        return ClipsAnswer(tuple(of_task[: asked.limit]))

    def keep_evidence(self, index: ClipIndex) -> None:
        """Answer about clips as their real index does."""
        self._answers |= dict.fromkeys((ClipsQuestion, KeepClip, DeleteClip), index.answer)

    def answers_with(self, kind: type, answer: Callable[[Any], TaskAnswer]) -> None:
        """Answer one kind of question otherwise."""
        self._answers[kind] = answer

    def flies_to_points(self) -> None:
        """Take the wish for a point, too, as one to look around."""
        self._answers[RequestTask] = lambda one: self._request(replace(one, service="patrol"))

    def keep_clip(self, info: ClipInfo) -> None:
        """Add a clip, the newest."""
        self.clips = (info, *self.clips)

    def _photo(self, asked: TakePhoto) -> ClipsAnswer:
        if not self.films:
            raise TaskError("the camera records only in flight", ReasonCode.NOT_READY.value)
        now = time.time()
        info = ClipInfo(
            *(f"photo-{len(self.clips)}", "snapshot", 0, "", "", "", (), asked.by, now, 0.0, 1000),
            keep_until=now + 30 * 86_400.0,
        )
        self.keep_clip(info)
        return ClipsAnswer((info,))

    def _clip(self, name: str, *, gone: bool = False) -> ClipsAnswer:
        found = tuple(one for one in self.clips if one.id == name)
        if not found:
            raise TaskError(f"there is no clip {name!r}", ReasonCode.BAD_PARAMETER.value)
        if gone:
            self.clips = tuple(one for one in self.clips if one.id != name)
        return ClipsAnswer(found)

    def _add(
        self,
        service: str,
        parameters: dict[str, Any],
        by: str,
        surface: RequestSurface,
        cause: str,
        priority: Priority = Priority.PERSON,
    ) -> TaskStatus:
        found = next((one for one in SERVICES if one.name == service), None)
        if found is None:
            raise TaskError(f"there is no service {service!r}", ReasonCode.UNKNOWN_SERVICE.value)
        return self._put(
            TaskStatus(
                len(self.tasks) + 1,
                service,
                found.title,
                parameters,
                TaskStage.QUEUED,
                ReasonCode.OK,
                "it is next",
                by,
                surface,
                cause,
                priority,
                time.time(),
                steps=tuple(
                    TaskStepStatus(f"step-{k}", words, TaskStepState.WAITING)
                    for k, words in enumerate(STEPS)
                ),
            )
        )

    def _put(self, task: TaskStatus) -> TaskStatus:
        self.tasks[task.id] = task
        return task

    def _known(self, task: int) -> TaskStatus:
        if task not in self.tasks:
            raise TaskError(f"there is no task {task}", ReasonCode.UNKNOWN_TASK.value)
        return self.tasks[task]

    def _request(self, asked: RequestTask) -> TasksAnswer:
        task = self._add(
            asked.service, asked.parameters, asked.by, asked.surface, asked.cause, asked.priority
        )
        if asked.confirm is Confirm.ASK:
            question = PersonQuestion("confirm", f"{asked.by} asks: {task.title}. Fly?")
            task = replace(task, state=TaskStage.WAITING, question=question, rehearsal=REHEARSAL)
        self.owners[task.id] = asked.owner
        return TasksAnswer((self._put(task),))

    def _rehearse(self, asked: RehearseTask) -> RehearsalAnswer:
        if asked.service not in {one.name for one in SERVICES}:
            raise TaskError("there is no such service", ReasonCode.UNKNOWN_SERVICE.value)
        if asked.parameters.get("what") == "the moon":
            words = "There is no place 'the moon'."
            return RehearsalAnswer(RehearsalReport(False, ReasonCode.UNKNOWN_PLACE, words))
        return RehearsalAnswer(REHEARSAL)

    def _reply(self, asked: ReplyToTask) -> TasksAnswer:
        task = self._known(asked.task)
        if task.question is None or task.question.id != asked.question:
            raise TaskError("nobody asks that any more", ReasonCode.BAD_PARAMETER.value)
        said_yes = asked.choice == task.question.choices[0]
        stage = TaskStage.QUEUED if said_yes else TaskStage.REFUSED
        code = ReasonCode.OK if said_yes else ReasonCode.DECLINED
        words = f"{asked.by} said {asked.choice}"
        ended = None if said_yes else time.time()
        return TasksAnswer(
            (
                self._put(
                    replace(
                        task, state=stage, question=None, code=code, words=words, ended_at=ended
                    )
                ),
            )
        )

    def _cancel(self, asked: CancelTask) -> TasksAnswer:
        ids = [asked.task] if asked.task else [one.id for one in self.board().tasks]
        if asked.only_of:
            ids = [one for one in ids if self.owners.get(one) == asked.only_of]
            if not ids:
                words = "you can end only what you asked for; STOP is for all"
                raise TaskError(words, ReasonCode.NOT_ALLOWED.value)
        ended = [
            self._put(
                replace(
                    self._known(one),
                    state=TaskStage.CANCELLED,
                    code=ReasonCode.CANCELLED,
                    words=f"{asked.by} ended it",
                    question=None,
                    ended_at=time.time(),
                )
            )
            for one in ids
        ]
        return TasksAnswer(tuple(ended))

    def _turned(self, task: int, stage: TaskStage) -> TasksAnswer:
        return TasksAnswer((self._put(replace(self._known(task), state=stage)),))

    def _sentence(self, asked: Sentence) -> SentenceAnswer:
        if "look" in asked.text and asked.fly:
            parameters: dict[str, ParameterValue] = {"what": asked.text.rpartition(" ")[2]}
            request = RequestTask("look", parameters, asked.by, asked.surface, "", asked.confirm)
            task = self._request(request).tasks[0]
            return SentenceAnswer(True, "look", "I go and look.", {}, task)
        if "where" in asked.text:
            return SentenceAnswer(True, "where", "The cup is in the cabinet, seen 3 min ago.")
        meant = ("look at the entrance", "where is the cup")
        return SentenceAnswer(False, "", "I do not understand that.", suggestions=meant)

    def _change_rule(self, asked: ChangeRule) -> RulesAnswer:
        if asked.parameters.get("what") == "the moon":
            raise TaskError("what: there is no 'the moon'", ReasonCode.UNKNOWN_THING.value)
        given = {"enabled": asked.enabled, "confirm": asked.confirm, "modes": asked.mode}
        changes: dict[str, Any] = {key: one for key, one in given.items() if one is not None}
        if (what := asked.parameters.get("what")) is not None:
            changes["parameters"] = (replace(self.rule.parameters[0], default=what),)
        changed = replace(self.rule, changed_by=asked.by, **changes)
        self.rule = RULE if asked.as_written else changed
        return RulesAnswer((self.rule,))

    def _set_mode(self, asked: SetMode) -> ModeAnswer:
        self.mode = asked.mode
        return ModeAnswer(asked.mode, f"The house is in mode {asked.mode.value}.")
