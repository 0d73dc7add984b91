"""Why a task ends, is asked about or refuses an order, in words for people."""

from __future__ import annotations

from housefly.messages.words import Words
from housefly.tasks.api.values import ReasonCode
from housefly.tasks.scheduler.transitions import TaskSignal

SOMEBODY = Words("somebody")
"""Who gives no name."""
END_REASONS: dict[TaskSignal, tuple[ReasonCode, Words]] = {
    TaskSignal.NO: (ReasonCode.DECLINED, Words("{who} said no", who=SOMEBODY)),
    TaskSignal.CANCEL: (ReasonCode.CANCELLED, Words("{who} cancelled it", who=SOMEBODY)),
    TaskSignal.UNANSWERED: (ReasonCode.NO_ANSWER, Words("nobody said yes in time")),
    TaskSignal.DEADLINE: (ReasonCode.DEADLINE, Words("it could not begin in time")),
    TaskSignal.MADE_WAY: (ReasonCode.QUEUE_FULL, Words("the queue was full, it made way")),
    TaskSignal.SET_ASIDE: (ReasonCode.CANCELLED, Words("it was cancelled")),
    TaskSignal.START_OVER: (ReasonCode.CANCELLED, Words("it was cancelled")),
    TaskSignal.BROKEN_OFF: (ReasonCode.PREEMPTED, Words("a more urgent task took the drone")),
    TaskSignal.RESTARTED: (
        ReasonCode.RESTARTED,
        Words("the program ended while it flew; nothing starts again without a fresh order"),
    ),
    TaskSignal.RESTARTED_BESIDE: (ReasonCode.RESTARTED, Words("the program ended while it ran")),
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
    TaskSignal.STALE: Words("It waited long"),
    TaskSignal.RESTARTED: Words("The program was started again"),
    TaskSignal.RESTARTED_BESIDE: Words("The program was started again"),
}
"""Why a person is asked again."""
