"""What tasks process and rehearsal worker tell each other, pickled over a socket pair of theirs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from housefly.errors import HouseflyError, LinkError, ThingError
from housefly.hub.api.questions import Question
from housefly.lab.rehearsal.room_now import RoomNow
from housefly.tasks.document.task_document import BoundTask


@dataclass(frozen=True, slots=True)
class RehearsalOrder:
    """To the worker: rehearse a task in the room as it is now, in at most so long [s]."""

    task: BoundTask
    now: RoomNow
    limit: float


@dataclass(frozen=True, slots=True)
class WorkerReady:
    """From the worker: everything is loaded and compiled."""


@dataclass(frozen=True, slots=True)
class MemoryQuestion:
    """From the worker: a question to the room's memory."""

    question: Question


@dataclass(frozen=True, slots=True)
class MemoryReply:
    """To the worker: the answer, or why there is none."""

    answer: Any = None
    refused: str = ""
    is_unknown: bool = False

    def unpacked(self) -> Any:
        """Return the answer; raises ThingError or LinkError when there is none."""
        if not self.refused:
            return self.answer
        raise (ThingError if self.is_unknown else LinkError)(self.refused)


def memory_refusal(error: HouseflyError) -> MemoryReply:
    """Return why a question has no answer, as a reply."""
    return MemoryReply(refused=str(error) or "no answer", is_unknown=isinstance(error, ThingError))
