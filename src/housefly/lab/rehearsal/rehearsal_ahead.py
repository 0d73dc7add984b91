"""What was rehearsed ahead, and whether it still holds: only in the same room, and not for long."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

from housefly.errors import HouseflyError
from housefly.geometry import distance, wrap_angle
from housefly.lab.rehearsal.room_now import RoomNow
from housefly.tasks.api.values import Confirm, ParameterValue, RehearsalReport
from housefly.tasks.document.steps import ConditionKind, StepKind, TaskCondition, TaskStep
from housefly.tasks.document.task_document import BoundTask
from housefly.tasks.rules.rule import Rule

KEPT_TIME = 20.0
"""A rehearsal ahead counts for so long [s] ..."""
RENEW_TIME = 12.0
"""... and is done again after this [s]."""
_MOVED, _TURNED, _GROWN = 0.15, 0.15, 0.1
"""Who moved by more [m], turned by more [rad], or changed its size by more [m] is elsewhere."""
_REMEMBERED_STEPS = frozenset(
    {
        *(StepKind.FIND, StepKind.CONTENTS, StepKind.CHANGES, StepKind.CHECK_PEOPLE),
        StepKind.FOR_EACH,
    }
)
_REMEMBERED = frozenset({ConditionKind.IS, ConditionKind.STALE, ConditionKind.DOUBTFUL})
_CHARGE = 0.02
"""A battery that lost more than this, 0 to 1, is another one."""


@dataclass(frozen=True, slots=True)
class RehearsedAhead:
    """A task, the room in which it was rehearsed, and what was found."""

    task: BoundTask
    room: RoomNow
    report: RehearsalReport

    def counts(self, task: BoundTask, room: RoomNow) -> bool:
        """Return whether a task may fly in a room by it; a refusal is always looked at anew."""
        return self.report.may_fly and self.holds(task, room)

    def holds(self, task: BoundTask, room: RoomNow, longest: float = KEPT_TIME) -> bool:
        """Return whether it says what a rehearsal of a task in a room would say.

        Args:
            task: that is to be rehearsed.
            room: as it is now.
            longest: it may be so old [s].
        """
        age = room.at - self.room.at
        return 0.0 <= age <= longest and self.task == task and is_same_room(self.room, room)


def is_same_room(before: RoomNow, now: RoomNow) -> bool:
    """Return whether the drone stands where it stood, and nobody and nothing has moved."""
    if before.drone is None or now.drone is None or before.is_airborne or now.is_airborne:
        return False
    return (
        distance(before.drone, now.drone) < _MOVED
        and abs(wrap_angle(before.yaw - now.yaw)) < _TURNED
        and _has_the_charge(before.battery, now.battery)
        and _same_people(before, now)
        and _same_obstacles(before, now)
    )


def tasks_ahead(
    rules: Iterable[Rule],
    bind: Callable[[str, Mapping[str, ParameterValue]], BoundTask],
) -> tuple[BoundTask, ...]:
    """Return the flights that rules ask for without a question, as far as they are known before.

    One whose way depends on what the room remembers is not known before.

    Args:
        rules: of the house.
        bind: binds a service to its parameters; raises TaskError.
    """
    found = []
    for rule in rules:
        given = rule.then.parameters
        is_open = any(isinstance(value, str) and value.startswith("$") for value in given.values())
        if not rule.enabled or rule.confirm != Confirm.AUTO.value or is_open:
            continue
        try:
            task = bind(rule.then.service, given)
        except HouseflyError:
            continue  # it is told at the start, and when the rule fires
        is_unasked = task.flies and task.confirm is Confirm.AUTO
        if is_unasked and task not in found and not _is_up_to_memory(task.steps):
            found.append(task)
    return tuple(found)


def _is_up_to_memory(steps: Iterable[TaskStep]) -> bool:
    """Return whether what the room remembers decides the way: what fires a rule may change it."""
    every = [step for first in steps for step in first.every_step()]
    values = [value for step in every for value in step.arguments.values()]
    return any(step.kind in _REMEMBERED_STEPS for step in every) or any(
        isinstance(value, TaskCondition) and _asks_memory(value) for value in values
    )


def _asks_memory(condition: TaskCondition) -> bool:
    return condition.kind in _REMEMBERED or any(map(_asks_memory, condition.parts))


def _has_the_charge(before: float | None, now: float | None) -> bool:
    if before is None or now is None:
        return before is now
    return before - now < _CHARGE


def _same_people(before: RoomNow, now: RoomNow) -> bool:
    then = {person.id: person.position for person in before.people}
    here = {person.id: person.position for person in now.people}
    return then.keys() == here.keys() and all(
        distance(then[name], place) < _MOVED for name, place in here.items()
    )


def _same_obstacles(before: RoomNow, now: RoomNow) -> bool:
    then = {(one.source, one.id): one for one in before.obstacles}
    here = {(one.source, one.id): one for one in now.obstacles}
    return then.keys() == here.keys() and all(
        distance(then[key].position, one.position) < _MOVED
        and abs(wrap_angle(then[key].yaw - one.yaw)) < _TURNED
        and abs(then[key].radius - one.radius) + distance(then[key].size, one.size) < _GROWN
        and abs(then[key].top - one.top) + abs(then[key].bottom - one.bottom) < _GROWN
        for key, one in here.items()
    )
