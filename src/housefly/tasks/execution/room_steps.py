"""Steps that tell, ask, wait and record; none of them moves the drone."""

from __future__ import annotations

from housefly.tasks.api.values import ReasonCode
from housefly.tasks.document.steps import TaskCondition
from housefly.tasks.execution.conditions import holds
from housefly.tasks.execution.step_behavior import StepBehavior, StepFailed
from housefly.tasks.execution.values import (
    AskPerson,
    CloseQuestion,
    PublishMqtt,
    Report,
    Say,
)


class SaySomething(StepBehavior):
    """Tells people."""

    def begin(self) -> None:
        """Say it."""
        self.context.actions.append(Say(self.spoken("words")))


class Announce(StepBehavior):
    """Says it in the room and on every screen."""

    def begin(self) -> None:
        """Say it."""
        words = self.spoken("words")
        self.context.actions += [Say(words), PublishMqtt(self.text("topic"), words)]


class ReportLine(StepBehavior):
    """Adds a line to what the task found."""

    def begin(self) -> None:
        """Report it."""
        self.context.actions.append(Report(self.spoken("words")))


class Publish(StepBehavior):
    """Publishes to a device."""

    def begin(self) -> None:
        """Publish it."""
        self.context.actions.append(PublishMqtt(self.text("topic"), self.text("payload")))


class Snapshot(StepBehavior):
    """Keeps one picture."""

    def begin(self) -> None:
        """Take it."""
        self.context.actions.append(self.context.snapshot(self.text("subject")))


class RecordClip(StepBehavior):
    """Records a clip for a time."""

    TIMED_BY = "time"

    def begin(self) -> None:
        """Start the clip."""
        clip = self.context.clip(self.number("before"), self.text("subject"))
        self.context.start_clip(clip)

    def proceed(self) -> bool:
        """Wait until the time is over."""
        return self.elapsed >= self.number("time")

    def end(self) -> None:
        """End the clip."""
        if self._failure is None:
            self.context.stop_clip()

    def limit(self) -> float:
        """Return the longest time that it may take [s]."""
        return self.number("time") + 1.0


class WaitFor(StepBehavior):
    """Waits for a time, or until something is so."""

    TIMED_BY = "time"

    def begin(self) -> None:
        """Begin to wait."""
        self._asked = -1e9

    def proceed(self) -> bool:
        """Return whether it is over; the room is asked once a second."""
        until = self.argument("until")
        if isinstance(until, TaskCondition) and self.context.time - self._asked >= 1.0:
            self._asked = self.context.time
            if holds(until, self.context):
                return True
        return self.elapsed >= self.number("time")

    def limit(self) -> float:
        """Return the longest time that it may take [s]."""
        return self.number("time") + 1.0


class Ask(StepBehavior):
    """Asks people and waits for a reply."""

    TIMED_BY = "wait"

    def begin(self) -> None:
        """Ask."""
        self._id, choices = self.text("as") or "reply", self.argument("choices")
        texts = choices if isinstance(choices, tuple) else ()
        self._choices = tuple(self.context.text(str(choice)) for choice in texts)
        self._otherwise = self.text("otherwise") or self._choices[-1]
        self.context.results.pop(self._id, None)
        self._send(self.number("wait"))

    def _send(self, wait: float) -> None:
        words = self.spoken("question")
        self.context.actions.append(
            AskPerson(self._id, words, self._choices, wait, self._otherwise)
        )

    def proceed(self) -> bool:
        """Return whether somebody replied, or the time is over."""
        for reply in self.context.inputs.replies:
            if reply.question == self._id and reply.choice in self._choices:
                self.context.results[self._id] = reply.choice
                return True
        if self.elapsed < self.number("wait"):
            return False
        self.context.results[self._id] = self._otherwise
        return True

    def resume(self) -> None:
        """Ask again: what was left of the time is left yet."""
        self._send(max(0.0, self.number("wait") - self.elapsed))

    def end(self) -> None:
        """Nobody waits for a reply any more."""
        self.context.actions.append(CloseQuestion(self._id))

    def limit(self) -> float:
        """Return the longest time that it may take [s]."""
        return self.number("wait") + 1.0


class Fail(StepBehavior):
    """Ends the task as failed."""

    def proceed(self) -> bool:
        """Fail."""
        raise StepFailed(self.spoken("words"), ReasonCode.STEP_FAILED)
