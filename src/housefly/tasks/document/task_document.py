"""A task document: one service, as people wrote it, and a task bound to its parameters."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from housefly.tasks.api.values import Confirm, OnPreempt, ParameterValue, ServiceInfo
from housefly.tasks.document.parameters import TaskParameter
from housefly.tasks.document.step_forms import FORMS
from housefly.tasks.document.steps import StepKind, TaskStep

RETURN_HOME = (TaskStep(StepKind.RETURN_HOME),)
"""What a cancelled task does when its document does not say."""


@dataclass(frozen=True, slots=True)
class TaskDocument:
    """One service.

    Attributes:
        name: in requests.
        title, about: for people.
        parameters: what may be given.
        steps: what it does.
        on_cancel: what it does when it is cancelled in the air.
        confirm: whether a person is asked before it flies.
        on_preempt: what becomes of it when a more important task comes.
        time_limit: longest time for all of it [s]; None for none.
        overrides: it may stand for a shipped task of the same name.
        source: its file, or "".
        calls: the tasks that it calls, by name.
    """

    name: str
    title: str
    about: str
    parameters: tuple[TaskParameter, ...]
    steps: tuple[TaskStep, ...]
    on_cancel: tuple[TaskStep, ...] = RETURN_HOME
    confirm: Confirm = Confirm.AUTO
    on_preempt: OnPreempt = OnPreempt.RESUME
    time_limit: float | None = None
    overrides: bool = False
    source: str = field(default="", compare=False)
    calls: dict[str, TaskDocument] = field(default_factory=dict, compare=False)

    @property
    def flies(self) -> bool:
        """Whether any of its steps moves the drone."""
        return any(
            FORMS[step.kind].flies
            or (step.kind is StepKind.CALL and self._called_flies(str(step.arguments["task"])))
            for first in self.steps
            for step in first.every_step()
        )

    @property
    def looks(self) -> bool:
        """Whether any of its steps is of no use without the drone's camera."""
        return any(
            FORMS[step.kind].looks
            or (step.kind is StepKind.CALL and self._called_looks(str(step.arguments["task"])))
            for first in self.steps
            for step in first.every_step()
        )

    def every_step(self) -> Iterator[TaskStep]:
        """Yield all its steps, in order, without those of tasks that it calls."""
        for step in (*self.steps, *self.on_cancel):
            yield from step.every_step()

    def info(self) -> ServiceInfo:
        """Return what can be asked for."""
        parameters = tuple(parameter.info() for parameter in self.parameters)
        return ServiceInfo(self.name, self.title, self.about, parameters, self.flies)

    def _called_flies(self, name: str) -> bool:
        called = self.calls.get(name)
        return called is None or called.flies

    def _called_looks(self, name: str) -> bool:
        called = self.calls.get(name)
        return called is not None and called.looks


@dataclass(frozen=True, slots=True)
class BoundTask:
    """A task with its parameters, ready to run.

    Attributes:
        service, title: of its document.
        parameters: all that have a value.
        steps, on_cancel: what it does; only what a step finds on the way is still open.
        flies, confirm, on_preempt, time_limit: of its document.
    """

    service: str
    title: str
    parameters: dict[str, ParameterValue]
    steps: tuple[TaskStep, ...]
    on_cancel: tuple[TaskStep, ...]
    flies: bool
    confirm: Confirm
    on_preempt: OnPreempt
    time_limit: float | None = None
