"""Who is next: by priority, then in turns between those who ask, then by time."""

from __future__ import annotations

from collections import defaultdict, deque
from collections.abc import Iterable, Iterator, Sequence

from housefly.tasks.api.values import Priority, TaskRequest
from housefly.tasks.scheduler.transitions import ACTIVE, NOT_BEGUN, QueueState
from housefly.tasks.scheduler.values import ScheduledTask

_RANKS = {priority: rank for rank, priority in enumerate(Priority)}
_READY = frozenset({QueueState.QUEUED, QueueState.SUSPENDED})


def is_more_urgent(one: Priority, other: Priority) -> bool:
    """Return whether the first goes strictly before the second."""
    return _RANKS[one] < _RANKS[other]


def turn_of(task: ScheduledTask, waiting: Iterable[ScheduledTask], queue: int) -> int:
    """Return the turn of a new task; among equals the smallest goes first.

    Each task that the same asker has waiting already puts it behind a whole queue of others: that
    is round robin. A turn never changes and ids only grow, so nobody is passed for ever.
    """
    earlier = sum(
        each.lane == task.lane
        and each.request.priority is task.request.priority
        and each.state not in ACTIVE
        for each in waiting
    )
    return task.id + earlier * queue


def next_task(tasks: Iterable[ScheduledTask], *, flies: bool) -> ScheduledTask | None:
    """Return the task whose turn it is, of those that could run now; what has begun goes first.

    The smallest turn says which asker is served; of theirs the oldest goes.
    """
    ready = [task for task in tasks if task.state in _READY and task.traits.flies is flies]
    return next(iter(_in_turns(ready)), None)


def order_of_flight(tasks: Iterable[ScheduledTask]) -> tuple[ScheduledTask, ...]:
    """Return open tasks in the order in which they run, as far as it is known now."""
    active, ready, others = list[ScheduledTask](), list[ScheduledTask](), list[ScheduledTask]()
    for task in tasks:
        group = active if task.state in ACTIVE else ready if task.state in _READY else others
        group.append(task)
    return (*_in_turns(active), *_in_turns(ready), *_in_turns(others))


def same_that_waits(request: TaskRequest, tasks: Iterable[ScheduledTask]) -> ScheduledTask | None:
    """Return the task that waits for the same service with the same parameters and drone."""
    wanted = (request.service, request.parameters, request.drone)
    return next(
        (
            task
            for task in tasks
            if task.state in NOT_BEGUN
            and (task.request.service, task.request.parameters, task.request.drone) == wanted
        ),
        None,
    )


def least_urgent(taker: ScheduledTask, tasks: Iterable[ScheduledTask]) -> ScheduledTask | None:
    """Return which waiting task makes way for a new one when there is no room; None for none.

    What no person asked for goes first, and no person's task goes for such a one.
    """
    lesser = (
        task
        for task in tasks
        if task.state in NOT_BEGUN and task.started_at is None and _makes_way(task, taker)
    )
    return max(lesser, key=lambda task: (not task.is_attended, _order(task)), default=None)


def _makes_way(task: ScheduledTask, taker: ScheduledTask) -> bool:
    if is_more_urgent(taker.request.priority, task.request.priority):
        return taker.is_attended or not task.is_attended
    is_equal = taker.request.priority is task.request.priority
    return is_equal and taker.is_attended and not task.is_attended


def _in_turns(tasks: Sequence[ScheduledTask]) -> Iterator[ScheduledTask]:
    """Yield tasks as they are served."""
    lanes = defaultdict[tuple[object, str], deque[ScheduledTask]](deque)
    for task in sorted(tasks, key=lambda task: task.id):
        lanes[_class_of(task), task.lane].append(task)
    for called in sorted(tasks, key=_order):
        yield lanes[_class_of(called), called.lane].popleft()


def _order(task: ScheduledTask) -> tuple[tuple[int, bool], int, int]:
    return _class_of(task), task.turn, task.id


def _class_of(task: ScheduledTask) -> tuple[int, bool]:
    return _RANKS[task.request.priority], task.state is not QueueState.SUSPENDED
