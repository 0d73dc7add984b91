"""Whether tasks may order the drone now, and what it does, in words."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from housefly.messages import DroneStatus, Phase
from housefly.messages.sensing import AIRBORNE_STATUSES
from housefly.messages.words import UNSAID, Words, said
from housefly.tasks.execution.step_inbox import SILENT_TIME, StepInbox
from housefly.tasks.scheduler.values import DroneAvailability

_NOT_SAID = Words("the pilot has not said yet whether it may take off")
_SILENT = Words("the pilot does not answer")


@dataclass(frozen=True, slots=True)
class TakeOffReadiness:
    """What the pilot's pre-flight list says; before the first look nothing is known."""

    is_ready: bool = False
    words: Words = _NOT_SAID


def drone_availability(
    inbox: StepInbox, readiness: TakeOffReadiness, now: float
) -> DroneAvailability:
    """Return whether tasks may order the drone.

    In the air only while a task has it: what a person flies is left to the person.

    Args:
        inbox: the pilot's steps.
        readiness: of its pre-flight list.
        now: the pilot's clock [s].
    """
    if inbox.age(now) > SILENT_TIME:
        return DroneAvailability(False, _SILENT)
    if inbox.status in AIRBORNE_STATUSES:
        by_task = inbox.is_flown_by_task
        return DroneAvailability(by_task, UNSAID if by_task else Words("a person flies the drone"))
    if inbox.status is not DroneStatus.LANDED:
        return DroneAvailability(False, Words("the drone does not say that it stands"))
    return DroneAvailability(readiness.is_ready, readiness.words)


class LandedState(Enum):
    """Whether the drone flies or stands, as far as its pilot tells."""

    IN_AIR = "in the air"
    ON_GROUND = "on the ground"
    UNKNOWN = "nobody knows"


def landed_state(inbox: StepInbox, now: float) -> LandedState:
    """Return whether the drone flies or stands; arguments as above."""
    if inbox.age(now) > SILENT_TIME:
        return LandedState.UNKNOWN
    if inbox.status in AIRBORNE_STATUSES:
        return LandedState.IN_AIR
    return LandedState.ON_GROUND if inbox.status is DroneStatus.LANDED else LandedState.UNKNOWN


def drone_words(inbox: StepInbox, readiness: TakeOffReadiness, now: float) -> Words:
    """Return what the drone does; arguments as above."""
    step = inbox.newest
    if step is None or inbox.age(now) > SILENT_TIME:
        return _SILENT
    outputs = step.outputs
    if outputs.reason:
        return outputs.reason
    if inbox.status in AIRBORNE_STATUSES:
        does = said(outputs.phase) if outputs.phase is not Phase.IDLE else Words("flying")
        goal = outputs.goal_name
        is_named = goal and not goal.startswith("(")  # a point is called by its coordinates
        return Words("{asked} {place}", asked=does, place=goal) if is_named else does
    if readiness.is_ready:
        return Words("on the ground, ready")
    return Words("on the ground; {why}", why=readiness.words)
