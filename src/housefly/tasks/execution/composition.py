"""Steps made of steps: what py_trees has not, on the task's own clock instead of the wall's."""

from __future__ import annotations

from collections.abc import Iterator

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Composite
from py_trees.decorators import Decorator

from housefly.errors import HouseflyError
from housefly.messages.words import Words, error_words, figure
from housefly.tasks.api.values import ReasonCode
from housefly.tasks.document.step_parser import EACH
from housefly.tasks.document.steps import TaskCondition
from housefly.tasks.execution.conditions import holds
from housefly.tasks.execution.every_name import every_name
from housefly.tasks.execution.run_context import RunContext


class Branch(Composite):  # type: ignore[misc, unused-ignore]
    """Does one of two: the first when a condition holds as it begins, else the second, if any."""

    def __init__(
        self, name: str, condition: TaskCondition, children: list[Behaviour], context: RunContext
    ) -> None:
        super().__init__(name, children)
        self._condition, self._context = condition, context

    def tick(self) -> Iterator[Behaviour]:
        """Choose when it begins, then tick the chosen one."""
        if self.status is not Status.RUNNING:
            for child in self.children:
                if child.status is not Status.INVALID:
                    child.stop(Status.INVALID)
            is_first = holds(self._condition, self._context)
            chosen = self.children[:1] if is_first else self.children[1:]
            self.current_child = chosen[0] if chosen else None
        if self.current_child is None:
            self.stop(Status.SUCCESS)
            yield self
            return
        yield from self.current_child.tick()
        status = self.current_child.status
        if status is not Status.RUNNING:
            self.stop(status)
        self.status = status
        yield self


class TimeLimit(Decorator):
    """Gives up what is inside when it takes longer than a time."""

    def __init__(self, name: str, child: Behaviour, limit: float, context: RunContext) -> None:
        super().__init__(name, child)
        self._limit, self._context, self._began = limit, context, 0.0
        self.has_expired = False

    def initialise(self) -> None:
        """Note when it begins."""
        self._began, self.has_expired = self._context.time, False

    def update(self) -> Status:
        """Fail when the time is over."""
        is_late = self._context.time - self._began > self._limit
        if self.decorated.status is Status.RUNNING and is_late:
            self.has_expired = True
            words = Words(
                "{what} took longer than {n} s", what=self.name, n=figure(self._limit, "g")
            )
            self._context.failure = (ReasonCode.TIMEOUT, words)
            return Status.FAILURE
        return self.decorated.status


class Otherwise(Composite):  # type: ignore[misc, unused-ignore]
    """Does the second when the time of the first is over."""

    def __init__(self, name: str, limited: TimeLimit, otherwise: Behaviour) -> None:
        super().__init__(name, [limited, otherwise])
        self._limited = limited

    def tick(self) -> Iterator[Behaviour]:
        """Tick the first until its time is over, then the second."""
        if self.status is not Status.RUNNING:
            for child in self.children:
                if child.status is not Status.INVALID:
                    child.stop(Status.INVALID)
            self.current_child = self.children[0]
        assert self.current_child is not None
        yield from self.current_child.tick()
        if self.current_child is self._limited and self._limited.has_expired:
            self.current_child = self.children[1]
            self._limited.has_expired = False
            self.status = Status.RUNNING
            yield self
            return
        status = self.current_child.status
        if status is not Status.RUNNING:
            self.stop(status)
        self.status = status
        yield self


class Rounds(Decorator):
    """Does what is inside several times, or until a condition holds after a round."""

    def __init__(
        self,
        name: str,
        child: Behaviour,
        times: int,
        until: TaskCondition | None,
        context: RunContext,
    ) -> None:
        super().__init__(name, child)
        self._times, self._until, self._context = times, until, context
        self._done = 0

    def initialise(self) -> None:
        """Count from the beginning."""
        self._done = 0

    def update(self) -> Status:
        """Count; go on until the rounds are done."""
        if self.decorated.status is not Status.SUCCESS:
            return self.decorated.status
        self._done += 1
        is_so = self._until is not None and holds(self._until, self._context)
        return Status.SUCCESS if is_so or self._done >= self._times else Status.RUNNING


class ForEach(Decorator):
    """Does what is inside once for each name that the room's memory has as it begins."""

    def __init__(self, name: str, child: Behaviour, every: str, context: RunContext) -> None:
        super().__init__(name, child)
        self._every, self._context = every, context
        self._left: list[str] = []

    def initialise(self) -> None:
        """Ask for the names."""
        self._failed = False
        try:
            self._left = every_name(self._every, self._context)
        except HouseflyError as error:
            self._left, self._failed = [], True
            self._context.failure = (ReasonCode.STEP_FAILED, error_words(error))
        self._context.results[EACH] = self._left[0] if self._left else ""

    def tick(self) -> Iterator[Behaviour]:
        """Tick what is inside; without a name there is nothing to do."""
        if self.status is not Status.RUNNING:
            self.initialise()
            self.status = Status.RUNNING
        if not self._left:
            self.stop(Status.FAILURE if self._failed else Status.SUCCESS)
            yield self
            return
        yield from super().tick()

    def update(self) -> Status:
        """Go on to the next name."""
        if self.decorated.status is not Status.SUCCESS:
            return self.decorated.status
        self._left.pop(0)
        self._context.results[EACH] = self._left[0] if self._left else ""
        return Status.RUNNING if self._left else Status.SUCCESS


class Recording(Decorator):
    """Records a clip for as long as what is inside takes."""

    def __init__(
        self, name: str, child: Behaviour, before: float, subject: str, context: RunContext
    ) -> None:
        super().__init__(name, child)
        self._before, self._subject, self._context = before, subject, context
        self._records = False

    def initialise(self) -> None:
        """Start the clip."""
        subject = self._context.text(self._subject)
        self._context.start_clip(self._context.clip(self._before, subject))
        self._records = True

    def update(self) -> Status:
        """Go on as long as what is inside does."""
        return self.decorated.status

    def terminate(self, new_status: Status) -> None:
        """End the clip."""
        if self._records:
            self._records = False
            self._context.stop_clip()
