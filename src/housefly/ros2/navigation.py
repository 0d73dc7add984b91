"""One goal of NavigateToPose: from the wish to the end, by the pilot's own steps. Pure."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from itertools import pairwise
from math import inf

from housefly.geometry import Vec2, distance
from housefly.messages import Estimate, Order, OrderKind, Phase, PilotStep
from housefly.tasks.api.answers import TaskBoard
from housefly.tasks.api.values import ENDED, TaskStage

ARRIVED_WITHIN = 0.6
"""A drone that holds so near to the goal has arrived [m]; the pilot itself is stricter."""
STRAY_TIME = 2.0
"""One that holds elsewhere, or stands, for so long does not get there [s]."""
START_TIME = 15.0
"""One that has not taken off after so long never does [s]."""
_GIVEN_UP = frozenset({Phase.RETURNING, Phase.LANDING, Phase.IDLE})
"""What a drone does after its flight to the goal is over."""


class NavigationEnd(Enum):
    """How a goal ended."""

    ARRIVED = "arrived"
    CANCELLED = "cancelled"
    FAILED = "failed"


@dataclass(frozen=True, slots=True)
class NavigationResult:
    """The end of a goal, and why, in words."""

    end: NavigationEnd
    words: str = ""


@dataclass(frozen=True, slots=True)
class NavigationProgress:
    """How far a drone is.

    Attributes:
        estimate: where it is.
        remaining: the way that is left, along the pilot's path where there is one [m].
        elapsed: since the goal was taken [s].
    """

    estimate: Estimate
    remaining: float
    elapsed: float


class Navigation:
    """Follows one goal.

    Args:
        goal: where to [m].
        order: id of the order that flies there; "" where a task does.
        task: number of the task that flies there; 0 where an order does.
        begun_at: when it was taken [s].

    Attributes:
        result: None until it has ended.
        progress: None before the pilot was heard.
    """

    def __init__(self, goal: Vec2, order: str, task: int, begun_at: float) -> None:
        self.result: NavigationResult | None = None
        self.progress: NavigationProgress | None = None
        self.order, self.task = order, task
        self._goal, self._begun_at = goal, begun_at
        self._is_flying, self._strayed_since = False, inf
        self._task_runs = task == 0

    def end(self, end: NavigationEnd, words: str = "") -> None:
        """End it, unless it has ended."""
        if self.result is None:
            self.result = NavigationResult(end, words)

    def add_step(self, step: PilotStep, holder: Order | None) -> None:
        """Take in a step of the pilot, and whose order flies the drone now."""
        estimate = step.outputs.estimate
        if estimate is not None:
            left = way_left(step, self._goal)
            self.progress = NavigationProgress(estimate, left, step.now - self._begun_at)
        if not self._task_runs:
            return
        if self.order and holder is not None and holder.id != self.order:
            self.end(NavigationEnd.FAILED, _taken(holder))
        elif estimate is not None:
            self._judge(step, distance(estimate.position[:2], self._goal))

    def add_board(self, board: TaskBoard) -> None:
        """Take in what the tasks do."""
        for one in (*board.tasks, *board.ended):
            if self.task and one.id == self.task:
                self._task_runs = one.state in (TaskStage.RUNNING, TaskStage.PAUSED)
                if one.state is TaskStage.DONE:
                    self.end(NavigationEnd.ARRIVED)
                elif one.state in ENDED:
                    words = f"task {one.id} was {one.state.value}: {one.words}"
                    self.end(NavigationEnd.FAILED, words)

    def _judge(self, step: PilotStep, away: float) -> None:
        phase, now = step.outputs.phase, step.now
        self._is_flying = self._is_flying or phase not in _GIVEN_UP
        if phase is Phase.HOLDING and away <= ARRIVED_WITHIN:
            self.end(NavigationEnd.ARRIVED)
        elif self._is_flying and (phase is Phase.HOLDING or phase in _GIVEN_UP):
            self._strayed_since = min(self._strayed_since, now)
            if now - self._strayed_since >= STRAY_TIME:
                why = str(step.outputs.reason) or f"it is {phase.value}"
                self.end(NavigationEnd.FAILED, f"{away:.2f} m from the goal: {why}")
        else:
            self._strayed_since = inf
            if not self._is_flying and not self.task and now - self._begun_at > START_TIME:
                self.end(NavigationEnd.FAILED, "it did not take off")


def way_left(step: PilotStep, goal: Vec2) -> float:
    """Return the way from the drone to a goal [m]: along the path in use where it leads there."""
    estimate, path = step.outputs.estimate, step.outputs.path
    if estimate is None:
        return inf
    here = estimate.position[:2]
    ahead = path.waypoints[step.outputs.waypoint :] if path is not None else ()
    if not ahead or distance(ahead[-1], goal) > ARRIVED_WITHIN:
        return distance(here, goal)
    return sum(distance(a, b) for a, b in pairwise((here, *ahead)))


def _taken(holder: Order) -> str:
    if holder.kind is OrderKind.STOP:
        return f"it was stopped by {holder.sender}"
    return f"another order flies it: {holder.kind.value} of {holder.sender or 'somebody'}"
