"""Why the pilot may not be started again now, as far as the console knows."""

from __future__ import annotations

from housefly.tasks.api.values import TaskStage
from housefly.web.messages.server_messages import TasksMessage
from housefly.web.messages.verdict_message import ConsoleVerdict

_UNDER_WAY = frozenset({TaskStage.RUNNING, TaskStage.PAUSED, TaskStage.SUSPENDED})


def restart_objection(verdict: ConsoleVerdict, tasks: TasksMessage) -> str:
    """Return why not, in words, or ""; the pilot's own word is asked after that.

    Args:
        verdict: what is known of the drone now.
        tasks: what is known of the services.
    """
    if verdict.airborne:
        return "in the air the drone keeps the map that it took off with: land first"
    if verdict.may_be_airborne or verdict.airborne is None:
        return "nobody knows whether the drone flies"
    board = tasks.board if tasks.running else None
    if board is not None and any(task.state in _UNDER_WAY for task in board.tasks):
        return "a task is under way: wait for its end, or end it"
    return ""
