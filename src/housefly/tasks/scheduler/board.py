"""Why an open task does not run yet, in one sentence for people."""

from __future__ import annotations

from housefly.tasks.scheduler.scheduler import Scheduler
from housefly.tasks.scheduler.transitions import ACTIVE, QueueState
from housefly.tasks.scheduler.turns import order_of_flight
from housefly.tasks.scheduler.values import DroneAvailability, ScheduledTask

_WAITS_FOR_DRONE = frozenset({QueueState.QUEUED, QueueState.SUSPENDED})


def board_order(scheduler: Scheduler) -> tuple[ScheduledTask, ...]:
    """Return the open tasks in the order in which they run, as far as it is known now."""
    return order_of_flight(scheduler.tasks)


def waiting_words(scheduler: Scheduler, drone: DroneAvailability) -> dict[int, str]:
    """Return why each task that could run does not, by id."""
    ready = [task for task in board_order(scheduler) if task.state in _WAITS_FOR_DRONE]
    flights = [task for task in ready if task.traits.flies]
    words = {task.id: "other tasks run" for task in ready if not task.traits.flies}
    return words | {
        task.id: _why_on_ground(task, place, scheduler, drone) for place, task in enumerate(flights)
    }


def _why_on_ground(
    task: ScheduledTask, place: int, scheduler: Scheduler, drone: DroneAvailability
) -> str:
    ahead = f"{place} before it" if place else ""
    holder = next(
        (each for each in scheduler.tasks if each.traits.flies and each.state in ACTIVE), None
    )
    why = ""
    if holder is not None:
        why = f"'{holder.traits.title}' has the drone"
    elif not drone.is_ready:
        why = drone.words or "the drone is not ready"
    return "; ".join(filter(None, (why, ahead))) or "it is next"
