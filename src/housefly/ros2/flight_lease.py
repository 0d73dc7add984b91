"""Who has a drone that flies: whoever ordered the flight, until it stands again."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.messages import Order, OrderKind, OrderSource, Phase, PilotStep
from housefly.messages.sensing import AIRBORNE_STATUSES

_TAKES_THE_DRONE = frozenset(
    {
        *(OrderKind.TAKE_OFF, OrderKind.GO, OrderKind.SERVICE),
        *(OrderKind.HOVER, OrderKind.HOME, OrderKind.NUDGE),
    }
)
"""Orders after which a drone is flown by who gave them."""


@dataclass(slots=True)
class FlightLease:
    """The holder of one drone, from the steps of its pilot; a stopped drone is a person's.

    Attributes:
        is_airborne: whether its propellers may turn.
        holder: the newest order that was taken since it stood; None on the ground.
    """

    is_airborne: bool = False
    holder: Order | None = None

    def add(self, step: PilotStep) -> None:
        """Take in one step."""
        telemetry = step.inputs.telemetry
        self.is_airborne = telemetry is not None and telemetry.status in AIRBORNE_STATUSES
        refused = {one.order_id for one in step.outputs.answers if not one.is_taken}
        for order in step.inputs.orders:
            is_stop = order.kind is OrderKind.STOP
            if (is_stop or order.kind in _TAKES_THE_DRONE) and order.id not in refused:
                self.holder = order
        stands = not self.is_airborne and step.outputs.phase is Phase.IDLE
        if stands and not step.inputs.orders:
            self.holder = None

    def give_back(self, order: str) -> None:
        """Let everybody have the drone whom this order flew."""
        if self.holder is not None and self.holder.id == order:
            self.holder = None

    def objection(self, sender: str) -> str:
        """Return why a program may not fly the drone now, in words, or ""."""
        holder = self.holder
        if not self.is_airborne or holder is None or holder.sender == sender:
            return ""
        if holder.kind is OrderKind.STOP:
            return f"it was stopped by {holder.sender}: Resume is a person's, in the console"
        if holder.source is OrderSource.TASK:
            return "a task flies it: cancel that first"
        return f"{holder.sender or 'somebody'} flies it"
