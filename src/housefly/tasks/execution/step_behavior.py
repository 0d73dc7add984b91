"""The base of all steps as behaviors of a tree: begin, go on, end, each within its time."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.common import Status

from housefly.errors import HouseflyError, TaskError
from housefly.messages.words import Words, error_words, figure
from housefly.tasks.api.values import ReasonCode, TaskStepState
from housefly.tasks.document.step_forms import default_of
from housefly.tasks.document.steps import ArgumentValue, TaskStep
from housefly.tasks.execution.run_context import RunContext, StepNote

_STATES = {
    Status.RUNNING: TaskStepState.RUNNING,
    Status.SUCCESS: TaskStepState.DONE,
    Status.FAILURE: TaskStepState.FAILED,
    Status.INVALID: TaskStepState.SKIPPED,
}


class StepFailed(Exception):
    """A step cannot do what it should; ``code`` says why."""

    def __init__(self, words: str, code: ReasonCode = ReasonCode.STEP_FAILED) -> None:
        self.code = code
        super().__init__(words)


class StepBehavior(Behaviour):
    """One step; subclasses say how it begins, goes on and ends.

    ``proceed`` returns whether the step is done and raises StepFailed, TaskError or any other
    HouseflyError of the room when it cannot be done.
    """

    LIMIT = 60.0
    """Longest time of a step whose document does not say [s]."""
    TIMED_BY = ""
    """The argument that says after which time it ends by itself [s]; "" where none does."""

    def __init__(self, step: TaskStep, context: RunContext) -> None:
        super().__init__(step.name or step.kind.value)
        self.step, self.context = step, context
        self.note = StepNote(self.name, "")
        self.template = ""
        self.began, self._round = 0.0, 0

    def begin(self) -> None:
        """Set the step going."""

    def proceed(self) -> bool:
        """Go on; return whether it is done."""
        return True

    def resume(self) -> None:
        """Go on after a pause: give the order again."""

    def end(self) -> None:
        """Leave the step, done or not."""

    def limit(self) -> float:
        """Return the longest time that it may take [s]."""
        timeout = self.step.timeout
        return timeout if isinstance(timeout, float) else self.LIMIT

    @property
    def elapsed(self) -> float:
        """Time since the step began, pauses left out [s]."""
        return self.context.time - self.began

    @property
    def left(self) -> float | None:
        """Time until it ends by itself [s]; None where nobody can say."""
        return max(0.0, self.number(self.TIMED_BY) - self.elapsed) if self.TIMED_BY else None

    def argument(self, name: str) -> ArgumentValue | None:
        """Return an argument, or its default."""
        found = self.step.arguments.get(name)
        return default_of(self.step.kind, name) if found is None else found

    def text(self, name: str) -> str:
        """Return an argument as text, with what steps found filled in."""
        value = self.argument(name)
        return self.context.text(value) if isinstance(value, str) else ""

    def spoken(self, name: str) -> str:
        """Return an argument as text for people."""
        value = self.argument(name)
        return self.context.words(value) if isinstance(value, str) else ""

    def number(self, name: str) -> float:
        """Return an argument as a number; 0 when it is not given."""
        value = self.argument(name)
        return value if isinstance(value, (int, float)) else 0.0

    def initialise(self) -> None:
        """Begin; called by the tree."""
        self.began, self._round = self.context.time, self.context.round
        self._failure: StepFailed | None = None
        self.note.state = TaskStepState.RUNNING
        self.note.words = self.context.words(self.template) or self.note.words
        try:
            self.begin()
        except HouseflyError as error:
            self._failure = _failed(error)
        except StepFailed as error:
            self._failure = error

    def update(self) -> Status:
        """Go on; called by the tree."""
        try:
            if self._failure is not None:
                raise self._failure
            if self._round != self.context.round:
                self._round = self.context.round
                self.resume()
            if self.proceed():
                return Status.SUCCESS
            if self.elapsed > self.limit():
                words = Words(
                    "{what} took longer than {n} s",
                    what=self.note.words or self.name,
                    n=figure(self.limit(), ".3g"),
                )
                raise StepFailed(words, ReasonCode.TIMEOUT)
        except StepFailed as error:
            self.context.failure = (error.code, error_words(error))
            return Status.FAILURE
        except HouseflyError as error:
            failed = _failed(error)
            self.context.failure = (failed.code, error_words(failed))
            return Status.FAILURE
        return Status.RUNNING

    def terminate(self, new_status: Status) -> None:
        """Leave; called by the tree."""
        if self.status is Status.RUNNING or new_status is not Status.INVALID:
            self.note.state = _STATES[new_status]
            self.end()


def _failed(error: HouseflyError) -> StepFailed:
    codes = {code.value: code for code in ReasonCode}
    code = codes.get(error.code) if isinstance(error, TaskError) else None
    return StepFailed(error_words(error), code or ReasonCode.STEP_FAILED)
