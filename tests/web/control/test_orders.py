from __future__ import annotations

from queue import Queue

import pytest
from fake_room import example_room
from hypothesis import given
from hypothesis import strategies as st

from housefly.bus.local import LocalBus
from housefly.bus.topics import DroneTopics
from housefly.clock import RealClock
from housefly.messages import Order, OrderKind, OrderSource
from housefly.web.control.orders import ORDER_WORDS, order_in_words, order_objection, to_order
from housefly.web.control.pilot_link import PilotLink
from housefly.web.messages.client_messages import OrderRequest

TOPICS = DroneTopics()

ROOM = example_room()


def test_every_kind_of_order_can_be_said_in_words() -> None:
    assert set(ORDER_WORDS) == set(OrderKind)


def test_an_order_that_goes_somewhere_needs_one_target() -> None:
    for kind in (OrderKind.GO, OrderKind.SERVICE):
        assert order_objection(OrderRequest("order", 1, kind), ROOM)
        assert order_objection(OrderRequest("order", 1, kind, "entrance", (1.0, 1.0)), ROOM)
        assert order_objection(OrderRequest("order", 1, kind, "entrance"), ROOM) == ""
        assert order_objection(OrderRequest("order", 1, kind, goal=(1.0, 1.0)), ROOM) == ""


@pytest.mark.parametrize(
    "kind", sorted(set(OrderKind) - {OrderKind.GO, OrderKind.SERVICE, OrderKind.NUDGE}, key=str)
)
def test_other_orders_take_no_target(kind: OrderKind) -> None:
    assert order_objection(OrderRequest("order", 1, kind), ROOM) == ""
    assert order_objection(OrderRequest("order", 1, kind, "entrance"), ROOM)


def test_an_unknown_place_is_refused_with_the_known_ones() -> None:
    assert "entrance" in order_objection(OrderRequest("order", 1, OrderKind.GO, "cellar"), ROOM)


def test_a_goal_outside_the_room_is_refused() -> None:
    assert "outside" in order_objection(
        OrderRequest("order", 1, OrderKind.GO, goal=(100.0, 0.0)), ROOM
    )


def test_nothing_is_flown_to_before_the_room_is_known() -> None:
    assert order_objection(OrderRequest("order", 1, OrderKind.GO, "entrance"), None)


def test_the_order_carries_who_asked_and_when() -> None:
    request = OrderRequest("order", 1, OrderKind.SERVICE, "entrance", look_s=7.0)
    order = to_order(request, "Anna", 12.0)
    assert (order.kind, order.place, order.look_s, order.issued_at, order.sender) == (
        OrderKind.SERVICE,
        "entrance",
        7.0,
        12.0,
        "Anna",
    )
    assert order_in_words(request) == "look at entrance and come back"


@given(st.text(max_size=24))
def test_no_name_makes_a_persons_order_one_of_a_task(name: str) -> None:
    request = OrderRequest("order", 1, OrderKind.HOVER)
    assert to_order(request, name, 0.0).source is OrderSource.PERSON
    assert to_order(request, f"task {name}", 0.0).source is OrderSource.PERSON


def test_no_name_makes_a_persons_stop_one_of_a_task() -> None:
    bus, heard = LocalBus(), Queue[Order]()
    bus.join().subscribe(TOPICS.order, heard.put)
    link = PilotLink(bus.join(), TOPICS, lambda: None, RealClock())
    link.stop("task 12: look")
    assert heard.get(timeout=20.0).source is OrderSource.PERSON
    link.close()
