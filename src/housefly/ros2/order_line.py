"""Orders to the pilots with their answers, and who has which drone."""

from __future__ import annotations

from dataclasses import dataclass
from secrets import token_hex
from threading import Condition

from housefly.bus.bus import Bus
from housefly.bus.topics import DroneTopics
from housefly.clock import Clock
from housefly.messages import Order, OrderAnswer, OrderKind, OrderSource, PilotStep
from housefly.messages.order_fault import NAME_LENGTH_MAX
from housefly.ros2.flight_lease import FlightLease

_PATIENCE = 1.0
"""How long the pilot may take to answer an order [s]."""


@dataclass(frozen=True, slots=True)
class RosReply:
    """What became of a wish, as std_srvs/Trigger says it.

    Attributes:
        success, message: whether it is done, and why not, in words.
        order: id of the order that was given; "" for none.
        task: number of the task that was asked for; 0 for none.
    """

    success: bool
    message: str
    order: str = ""
    task: int = 0


class OrderLine:
    """Gives orders of programs and waits for what the pilots say; thread-safe.

    Args:
        bus: of the run.
        drones: their names.
        clock: monotonic.
    """

    def __init__(self, bus: Bus, drones: tuple[str, ...], clock: Clock) -> None:
        self._bus, self._clock = bus, clock
        self._topics = {name: DroneTopics(name) for name in drones}
        self._leases = {name: FlightLease() for name in drones}
        self._answers: dict[str, OrderAnswer | None] = {}
        self._answered = Condition()

    def heard(self, drone: str, step: PilotStep) -> None:
        """Take in a step of a drone's pilot."""
        self._leases[drone].add(step)
        if step.outputs.answers and self._answers:
            with self._answered:
                for answer in step.outputs.answers:
                    if answer.order_id in self._answers:
                        self._answers[answer.order_id] = answer
                self._answered.notify_all()

    def is_airborne(self, drone: str) -> bool:
        """Return whether the propellers of a drone may turn."""
        return self._leases[drone].is_airborne

    def objection(self, drone: str, sender: str) -> str:
        """Return why a program may not fly a drone now, in words, or ""."""
        return self._leases[drone].objection(_short(sender))

    def holder(self, drone: str) -> Order | None:
        """Return the order by which a drone flies; None on the ground."""
        return self._leases[drone].holder

    def give_back(self, drone: str, order: str) -> None:
        """Let everybody have the drone whom this order flew."""
        self._leases[drone].give_back(order)

    def new_order(self, kind: OrderKind, sender: str) -> Order:
        """Return an order of a program, without a target."""
        return Order(
            kind,
            issued_at=self._clock.now(),
            sender=_short(sender),
            id=token_hex(6),
            source=OrderSource.PROGRAM,
        )

    def publish(self, drone: str, order: Order) -> None:
        """Give an order and wait for nothing."""
        self._bus.publish(self._topics[drone].order, order)

    def ordered(self, drone: str, order: Order) -> RosReply:
        """Give an order; return what the pilot says."""
        with self._answered:
            self._answers[order.id] = None
        try:
            self.publish(drone, order)
            return self._reply(drone, order.id)
        finally:
            with self._answered:
                del self._answers[order.id]

    def _reply(self, drone: str, order: str) -> RosReply:
        def is_answered() -> bool:
            return self._answers[order] is not None

        with self._answered:
            self._answered.wait_for(is_answered, _PATIENCE)
            answer = self._answers[order]
        if answer is None:
            return RosReply(False, f"the pilot of {drone} does not answer")
        return RosReply(answer.is_taken, str(answer.reason) or "done", order)


def _short(sender: str) -> str:
    return sender[:NAME_LENGTH_MAX]
