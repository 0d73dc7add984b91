"""An order of a task reaches the pilot, whatever becomes of what is written about it."""

from __future__ import annotations

import io
from contextlib import redirect_stdout

import pytest
from full_disk import full_output

from housefly.app.task_outlet_bus import BusTaskOutlet
from housefly.bus.local import LocalBus
from housefly.bus.topics import DroneTopics
from housefly.messages import Order, OrderKind

TOPICS = DroneTopics()


class Watched(io.StringIO):
    """Notes how many orders the pilot had when something was printed."""

    def __init__(self, heard: list[Order]) -> None:
        super().__init__()
        self._heard = heard
        self.known: list[int] = []

    def write(self, text: str) -> int:
        self.known.append(len(self._heard))
        return super().write(text)


@pytest.mark.parametrize("kind", [OrderKind.STOP, OrderKind.LAND, OrderKind.HOME])
def test_an_order_reaches_the_pilot_although_the_log_takes_no_more(kind: OrderKind) -> None:
    bus, heard = LocalBus(), list[Order]()
    bus.subscribe(TOPICS.order, heard.append)
    order = Order(kind, sender="task 1", issued_at=1.0)
    with full_output():
        BusTaskOutlet(bus, "room").order(order, "drone")
    assert heard == [order]


def test_an_order_is_given_before_it_is_written_down() -> None:
    bus, heard = LocalBus(), list[Order]()
    bus.subscribe(TOPICS.order, heard.append)
    with redirect_stdout(Watched(heard)) as printed:
        BusTaskOutlet(bus, "room").order(
            Order(OrderKind.STOP, sender="task 1", issued_at=1.0), "drone"
        )
    assert printed.getvalue() == "order: stop by task 1\n"
    assert set(printed.known) == {1}
