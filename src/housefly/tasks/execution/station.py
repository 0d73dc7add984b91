"""The way back to where a paused task hovered, when the drone was flown elsewhere meanwhile."""

from __future__ import annotations

from housefly.geometry import distance
from housefly.messages import Order
from housefly.messages.words import Words
from housefly.tasks.document.steps import StepKind, TaskStep
from housefly.tasks.execution.flight_steps import ARRIVED_WITHIN, LookAt
from housefly.tasks.execution.run_context import RunContext


class ReturnToStation(LookAt):
    """Flies to where a task hovered and faces what it faced."""

    def __init__(self, station: Order, context: RunContext) -> None:
        super().__init__(TaskStep(StepKind.LOOK_AT), context)
        self._station, self._looked = station, context.looks
        self.note.words = "fly back to where it was"

    def _aim(self) -> None:
        assert self._station.goal is not None
        self.goal, self.look_at = self._station.goal, self._station.look_at

    def look_in_words(self) -> Words:
        """Return what it did before the pause."""
        return self._looked


def way_to_station(context: RunContext) -> ReturnToStation | None:
    """Return the way back; None when the drone is there, or the task did not hover anywhere."""
    station, here = context.station, context.inputs.position
    if station is None or station.goal is None:
        return None
    is_there = here is not None and distance(here[:2], station.goal) < ARRIVED_WITHIN
    return None if is_there and context.hovers else ReturnToStation(station, context)
