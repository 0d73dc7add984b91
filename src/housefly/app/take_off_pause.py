"""The pilot's word that it stays on the ground for a moment, so that it can be started anew."""

from __future__ import annotations

from housefly.app.refused_orders import RISING_ORDERS, RefusedOrder, refuse_rising
from housefly.messages import DroneStatus, Order, OrderOutcome, Outputs, Phase, Telemetry
from housefly.messages.sensing import REPORT_AGE_MAX
from housefly.messages.words import UNSAID, Words

TAKE_OFF_PAUSE_TIME = 5.0
"""So long it takes no order that flies [s]; then it goes on, if nobody has ended it."""
_REFUSAL = Words("the pilot starts again with the new map; order it anew in a moment")


class TakeOffPause:
    """Whether the pilot stands down, and until when; used on the pilot's loop alone."""

    def __init__(self) -> None:
        self._until = float("-inf")

    def begin(
        self,
        now: float,
        telemetry: Telemetry | None,
        outputs: Outputs | None,
        waiting: tuple[Order, ...],
    ) -> str:
        """Stand down from now on, or return why not, in words.

        Args:
            now: the pilot's clock [s].
            telemetry: the drone's newest word.
            outputs: of the newest step.
            waiting: orders that the next step will hear.
        """
        objection = _objection(now, telemetry, outputs, waiting)
        if not objection:
            self._until = now + TAKE_OFF_PAUSE_TIME
        return objection

    def allowed(
        self, orders: tuple[Order, ...], now: float
    ) -> tuple[tuple[Order, ...], tuple[RefusedOrder, ...]]:
        """Return the orders without those that would take off now, and those."""
        why = _REFUSAL if now < self._until else UNSAID
        return refuse_rising(orders, OrderOutcome.RESTARTING, why)


def _objection(
    now: float,
    telemetry: Telemetry | None,
    outputs: Outputs | None,
    waiting: tuple[Order, ...],
) -> str:
    if telemetry is None or now - telemetry.received_at > REPORT_AGE_MAX:
        return "the drone is not heard, so nobody knows whether it flies"
    if telemetry.status is not DroneStatus.LANDED:
        return f"the drone does not stand: it says that it is {telemetry.status.value}"
    if outputs is None or outputs.phase is not Phase.IDLE:
        return "the drone is about to fly"
    if any(order.kind in RISING_ORDERS for order in waiting):
        return "an order to fly has just come"
    return ""
