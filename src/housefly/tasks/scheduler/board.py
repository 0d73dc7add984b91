"""Why an open task does not run yet, in one sentence for people."""

from __future__ import annotations

from housefly.messages.words import UNSAID, Words, figure, joined
from housefly.tasks.scheduler.scheduler import Scheduler
from housefly.tasks.scheduler.transitions import ACTIVE, QueueState
from housefly.tasks.scheduler.turns import order_of_flight
from housefly.tasks.scheduler.values import DroneAvailability, ScheduledTask

_WAITS_FOR_DRONE = frozenset({QueueState.QUEUED, QueueState.SUSPENDED})


def board_order(scheduler: Scheduler) -> tuple[ScheduledTask, ...]:
    """Return the open tasks in the order in which they run, as far as it is known now."""
    return order_of_flight(scheduler.tasks)


def waiting_words(scheduler: Scheduler, drone: DroneAvailability) -> dict[int, Words]:
    """Return why each task that could run does not, by id."""
    ready = [task for task in board_order(scheduler) if task.state in _WAITS_FOR_DRONE]
    flights = [task for task in ready if task.traits.flies]
    words = {task.id: Words("other tasks run") for task in ready if not task.traits.flies}
    return words | {
        task.id: _why_on_ground(task, place, scheduler, drone) for place, task in enumerate(flights)
    }


def _why_on_ground(
    task: ScheduledTask, place: int, scheduler: Scheduler, drone: DroneAvailability
) -> Words:
    ahead = Words("{n} before it", n=figure(place)) if place else UNSAID
    holder = next(
        (each for each in scheduler.tasks if each.traits.flies and each.state in ACTIVE), None
    )
    why = UNSAID
    if holder is not None:
        why = Words("'{title}' has the drone", title=holder.traits.title)
    elif not drone.is_ready:
        why = drone.words or Words("the drone is not ready")
    return joined("; ", filter(None, (why, ahead))) or Words("it is next")
