"""Why a task ends, is asked about or refuses an order, in words for people."""

from __future__ import annotations

from housefly.tasks.api.values import ReasonCode
from housefly.tasks.scheduler.transitions import TaskSignal

END_REASONS: dict[TaskSignal, tuple[ReasonCode, str]] = {
    TaskSignal.NO: (ReasonCode.DECLINED, "somebody said no"),
    TaskSignal.CANCEL: (ReasonCode.CANCELLED, "somebody cancelled it"),
    TaskSignal.UNANSWERED: (ReasonCode.NO_ANSWER, "nobody said yes in time"),
    TaskSignal.DEADLINE: (ReasonCode.DEADLINE, "it could not begin in time"),
    TaskSignal.MADE_WAY: (ReasonCode.QUEUE_FULL, "the queue was full, it made way"),
    TaskSignal.SET_ASIDE: (ReasonCode.CANCELLED, "it was cancelled"),
    TaskSignal.START_OVER: (ReasonCode.CANCELLED, "it was cancelled"),
    TaskSignal.BROKEN_OFF: (ReasonCode.PREEMPTED, "a more urgent task took the drone"),
    TaskSignal.RESTARTED: (
        ReasonCode.RESTARTED,
        "the program ended while it flew; nothing starts again without a fresh order",
    ),
    TaskSignal.RESTARTED_BESIDE: (ReasonCode.RESTARTED, "the program ended while it ran"),
}
"""Why a signal ends a task."""
ORDER_REFUSALS = {
    TaskSignal.YES: "it asks nothing now",
    TaskSignal.NO: "it asks nothing now",
    TaskSignal.PAUSE: "there is nothing to pause",
    TaskSignal.CONTINUE: "it is not paused",
}
"""Why an order is refused."""
ASKING_REASONS = {
    TaskSignal.STALE: "It waited long",
    TaskSignal.RESTARTED: "The program was started again",
    TaskSignal.RESTARTED_BESIDE: "The program was started again",
}
"""Why a person is asked again."""
