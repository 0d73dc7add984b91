"""Why an open task does not run yet, in one sentence for people."""

from __future__ import annotations

from collections.abc import Sequence

from housefly.tasks.scheduler.scheduler import Scheduler, holder_of
from housefly.tasks.scheduler.transitions import QueueState
from housefly.tasks.scheduler.turns import order_of_flight
from housefly.tasks.scheduler.values import DroneAvailability, ScheduledTask

_WAITS_FOR_DRONE = frozenset({QueueState.QUEUED, QueueState.SUSPENDED})


def board_order(scheduler: Scheduler) -> tuple[ScheduledTask, ...]:
    """Return the open tasks in the order in which they run, as far as it is known now."""
    return order_of_flight(scheduler.tasks)


def waiting_words(scheduler: Scheduler, *drones: DroneAvailability) -> dict[int, str]:
    """Return why each task that could run does not, by id."""
    ready = [task for task in board_order(scheduler) if task.state in _WAITS_FOR_DRONE]
    flights = [task for task in ready if task.traits.flies]
    words = {task.id: "other tasks run" for task in ready if not task.traits.flies}
    return words | {
        task.id: _why_on_ground(task, place, scheduler, drones)
        for place, task in enumerate(flights)
    }


def _why_on_ground(
    task: ScheduledTask, place: int, scheduler: Scheduler, drones: Sequence[DroneAvailability]
) -> str:
    ahead = f"{place} before it" if place else ""
    fit = [one for one in drones if task.wanted_drone in ("", one.name)]
    reasons = [_why_not(one, scheduler, several=len(drones) > 1) for one in fit]
    why = "" if "" in reasons else "; ".join(reasons)
    return "; ".join(filter(None, (why, ahead))) or "it is next"


def _why_not(drone: DroneAvailability, scheduler: Scheduler, *, several: bool) -> str:
    """Return why a drone is not to be had, in words; "" when it is."""
    holder = holder_of(drone.name, scheduler.tasks)
    if holder is not None:
        return f"'{holder.traits.title}' has {drone.name if several else 'the drone'}"
    if drone.is_ready:
        return ""
    words = drone.words or "the drone is not ready"
    return f"{drone.name}: {words}" if several else words
