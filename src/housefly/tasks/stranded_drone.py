"""Looks after a drone that a task left in the air: no task has it, and it is sent home."""

from __future__ import annotations

from collections.abc import Iterable

from housefly.messages import Phase
from housefly.tasks.api.values import ENDED
from housefly.tasks.scheduler.values import RunReport
from housefly.tasks.task_actions import TaskActions
from housefly.tasks.task_drones import TaskDrone
from housefly.tasks.task_runs import TaskRuns

_LEFT_IN = frozenset({Phase.OUTBOUND, Phase.LOOKING, Phase.HOLDING})
"""Phases from which nobody would bring a drone home for a long time."""
_HOME_REPEAT = 3.0
"""It is sent home again after this [s]."""


class StrandedDrone:
    """Sends home what nobody flies any more.

    Args:
        drone: one of the site.
        actions: gives the order.
    """

    def __init__(self, drone: TaskDrone, actions: TaskActions) -> None:
        self._name, self._inbox, self._actions = drone.name, drone.inbox, actions
        self._sent_home_at = float("-inf")

    def let_go(self, reports: Iterable[RunReport], runs: TaskRuns) -> None:
        """After a flight that ended in the air the pilot has the drone, and no other task."""
        for report in reports:
            record = runs.record(report.id)
            has_run = record is not None and record.run is not None and record.task.flies
            is_ours = record is not None and record.drone == self._name
            if report.stage in ENDED and has_run and is_ours:
                self._inbox.give_up()

    def bring_home(self, now: float) -> None:
        """Send home a drone that a task left in the air, as when the next one was called off.

        Args:
            now: the pilot's clock [s]; no task has the drone then.
        """
        is_left = self._inbox.is_airborne and self._inbox.is_flown_by_task
        step, is_due = self._inbox.newest, now - self._sent_home_at > _HOME_REPEAT
        if is_left and is_due and step is not None and step.outputs.phase in _LEFT_IN:
            self._sent_home_at = now
            self._actions.send_home(self._name, now)
