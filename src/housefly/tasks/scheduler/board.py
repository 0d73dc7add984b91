"""Why an open task does not run yet, in one sentence for people."""

from __future__ import annotations

from collections.abc import Sequence

from housefly.messages.words import UNSAID, Words, figure, joined, literal
from housefly.tasks.scheduler.scheduler import Scheduler, holder_of
from housefly.tasks.scheduler.transitions import QueueState
from housefly.tasks.scheduler.turns import order_of_flight
from housefly.tasks.scheduler.values import DroneAvailability, ScheduledTask

_WAITS_FOR_DRONE = frozenset({QueueState.QUEUED, QueueState.SUSPENDED})


def board_order(scheduler: Scheduler) -> tuple[ScheduledTask, ...]:
    """Return the open tasks in the order in which they run, as far as it is known now."""
    return order_of_flight(scheduler.tasks)


def waiting_words(scheduler: Scheduler, *drones: DroneAvailability) -> dict[int, Words]:
    """Return why each task that could run does not, by id."""
    ready = [task for task in board_order(scheduler) if task.state in _WAITS_FOR_DRONE]
    flights = [task for task in ready if task.traits.flies]
    words = {task.id: Words("other tasks run") for task in ready if not task.traits.flies}
    return words | {
        task.id: _why_on_ground(task, place, scheduler, drones)
        for place, task in enumerate(flights)
    }


def _why_on_ground(
    task: ScheduledTask, place: int, scheduler: Scheduler, drones: Sequence[DroneAvailability]
) -> Words:
    ahead = Words("{n} before it", n=figure(place)) if place else UNSAID
    fit = [one for one in drones if task.wanted_drone in ("", one.name)]
    reasons = [_why_not(one, scheduler, several=len(drones) > 1) for one in fit]
    why = UNSAID if UNSAID in reasons else joined("; ", reasons)
    return joined("; ", filter(None, (why, ahead))) or Words("it is next")


def _why_not(drone: DroneAvailability, scheduler: Scheduler, *, several: bool) -> Words:
    """Return why a drone is not to be had, in words; "" when it is."""
    holder = holder_of(drone.name, scheduler.tasks)
    if holder is not None:
        why = Words("'{title}' has the drone", title=holder.traits.title)
    elif drone.is_ready:
        return UNSAID
    else:
        why = drone.words or Words("the drone is not ready")
    return joined(": ", (literal(drone.name), why)) if several else why
