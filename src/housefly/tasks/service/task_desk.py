"""Takes requests, whoever makes them: bound to a document, allowed by the mode, then queued."""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from threading import RLock

from housefly.errors import HouseflyError, TaskError, ThingError
from housefly.hub.api.questions import WhereQuestion
from housefly.hub.api.told_events import ToldEventKind
from housefly.messages import RoomEvent
from housefly.messages.words import Words, error_words
from housefly.tasks.api.values import (
    ParameterValue,
    ReasonCode,
    RequestSurface,
    TaskRequest,
    TaskStage,
    TaskStatus,
)
from housefly.tasks.document.library import bind
from housefly.tasks.document.open_library import OpenLibrary
from housefly.tasks.document.parameters import ParameterType
from housefly.tasks.document.task_document import BoundTask
from housefly.tasks.engine.task_drones import TaskDrones
from housefly.tasks.engine.task_engine import TaskEngine
from housefly.tasks.engine.task_outlet import TaskOutlet, task_event
from housefly.tasks.rules.mode_table import launch_permit
from housefly.tasks.rules.rule_engine import RuleDecision
from housefly.tasks.rules.rule_service import RuleService
from housefly.tasks.rules.trigger import EventTrigger, Trigger
from housefly.tasks.scheduler.task_store import TaskStore
from housefly.tasks.service.notices import Notices

_log = logging.getLogger(__name__)

_HOUSE = "house"
"""To this happens what happens to no thing."""


class TaskDesk:
    """Takes requests of people, rules and assistants; thread-safe.

    Args:
        library: task documents by name.
        engine: queue and runs.
        rules: with the mode of the house.
        outlet: hears of events.
        store: keeps what people want to be told.
        wall: Unix time [s].
        drones: of the site.

    Attributes:
        lock: guards the engine and the store.
        notices: what people want to be told.
    """

    def __init__(
        self,
        library: OpenLibrary,
        engine: TaskEngine,
        rules: RuleService,
        outlet: TaskOutlet,
        store: TaskStore,
        wall: Callable[[], float],
        drones: TaskDrones,
    ) -> None:
        self._drones = drones
        self.lock = RLock()
        self.notices = Notices(store, self.lock, wall)
        self._library, self._engine, self._rules = library, engine, rules
        self._outlet, self._wall = outlet, wall

    def bound(self, service: str, parameters: Mapping[str, ParameterValue]) -> BoundTask:
        """Return a task; raises TaskError UNKNOWN_SERVICE or BAD_PARAMETER."""
        return bind(self._library.document(service), parameters)

    def request(self, request: TaskRequest) -> TaskStatus:
        """Queue a task.

        Raises:
            TaskError: UNKNOWN_SERVICE, BAD_PARAMETER, UNKNOWN_PLACE, MODE, or why the queue refuses
                it.
        """
        self._drones.check(request.drone)
        task = self.bound(request.service, request.parameters)
        permit = launch_permit(
            self._rules.mode,
            request.surface,
            confirm=request.confirm,
            priority=request.priority,
            # What a rule may do in a mode was looked at when it fired.
            names_mode=request.surface is RequestSurface.RULE,
            flies=task.flies,
        )
        if not permit.is_given:
            raise TaskError(permit.words, permit.code.value)
        self._check_places(request, task)
        asked = replace(request, parameters=dict(task.parameters), confirm=permit.confirm)
        with self.lock:
            status = self._engine.request(asked, task, self._wall())
        if status.state is TaskStage.REFUSED:
            raise TaskError(status.words, status.code.value)
        return status

    def _check_places(self, request: TaskRequest, task: BoundTask) -> None:
        """Raise TaskError for a place that this room has not: nobody is asked about such a task."""
        room = self._drones.or_first(request.drone).room
        for parameter in self._library.document(request.service).parameters:
            place = task.parameters.get(parameter.name)
            if parameter.type is not ParameterType.PLACE or not isinstance(place, str) or not place:
                continue
            try:
                room.ask(WhereQuestion(place))
            except ThingError as error:
                words = Words(
                    "this room has no place called {place}: make one in the room editor",
                    place=repr(place),
                )
                raise TaskError(words, ReasonCode.UNKNOWN_PLACE.value) from error
            except HouseflyError as error:
                _log.debug("nobody knows whether there is a place %r: %s", place, error)

    def heard(self, trigger: Trigger) -> tuple[RuleDecision, ...]:
        """Let the rules hear of a trigger, and do what they decide; return that."""
        if isinstance(trigger, EventTrigger):
            event = trigger.event
            for words in self.notices.due(event.kind, event.thing):
                self.say(words, event.kind)
        return self._decided(self._rules.heard(trigger, self._wall()))

    def looked_at_clock(self) -> None:
        """Let the rules and the notices look at the time; to be called about once a second."""
        for words in self.notices.due_by_time():
            self.say(words, "time")
        self._decided(self._rules.ticked(self._wall()))

    def say(self, words: str, cause: str) -> None:
        """Say something to whoever listens."""
        self.tell("said", cause, words=words)
        self._outlet.say(words)

    def tell(self, kind: ToldEventKind, cause: str, **facts: ParameterValue) -> RoomEvent:
        """Tell the room's memory what happened in the house."""
        event = task_event(kind, _HOUSE, self._wall(), cause, facts)
        self._outlet.tell(event)
        return event

    def _decided(self, decisions: Iterable[RuleDecision]) -> tuple[RuleDecision, ...]:
        done = tuple(self._asked_by_rule(decision) for decision in decisions)
        for decision in done:
            firing = decision.firing
            if firing.code is ReasonCode.OK or decision.request is not None:
                self.tell(
                    "rule fired",
                    firing.cause,
                    rule=firing.rule,
                    service=firing.service,
                    words=firing.words,
                )
        return done

    def _asked_by_rule(self, decision: RuleDecision) -> RuleDecision:
        """Ask for what a rule asks for; a refusal stands in what it is said to have done."""
        if decision.request is None:
            return decision
        try:
            self.request(decision.request)
        except TaskError as error:
            firing = replace(decision.firing, code=ReasonCode(error.code), words=error_words(error))
            return replace(decision, firing=firing)
        except HouseflyError as error:
            _log.error("rule %s: %s", decision.firing.rule, error)
        return decision
