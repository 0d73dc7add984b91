"""The bus inside one process."""

from __future__ import annotations

import threading

import pytest

from housefly.bus.bus import Bus
from housefly.bus.local import LocalBus
from housefly.bus.topics import DroneTopics
from housefly.errors import LinkError
from housefly.messages import LinkStatus, Order, OrderKind

TOPICS = DroneTopics()


def test_a_message_has_arrived_when_publish_returns() -> None:
    bus: Bus = LocalBus()
    heard: list[Order] = []
    bus.subscribe(TOPICS.order, heard.append)
    bus.publish(TOPICS.order, Order(OrderKind.STOP))
    assert heard == [Order(OrderKind.STOP)]


def test_handlers_are_called_in_the_order_of_subscription_across_members() -> None:
    bus = LocalBus()
    calls: list[str] = []
    bus.subscribe(TOPICS.link, lambda _: calls.append("first"))
    bus.join().subscribe(TOPICS.link, lambda _: calls.append("second"))
    bus.subscribe(TOPICS.link, lambda _: calls.append("third"))
    bus.join().publish(TOPICS.link, LinkStatus(0.0))
    assert calls == ["first", "second", "third"]


def test_a_handler_hears_only_its_topic() -> None:
    bus = LocalBus()
    heard: list[LinkStatus] = []
    bus.subscribe(TOPICS.link, heard.append)
    bus.publish(TOPICS.order, Order(OrderKind.HOVER))
    assert heard == []


def test_a_closed_subscription_is_silent_and_closing_twice_does_no_harm() -> None:
    bus = LocalBus()
    heard: list[LinkStatus] = []
    subscription = bus.subscribe(TOPICS.link, heard.append)
    subscription.close()
    subscription.close()
    bus.publish(TOPICS.link, LinkStatus(0.0))
    assert heard == []


def test_a_member_that_leaves_takes_only_its_own_handlers() -> None:
    bus = LocalBus()
    heard: list[str] = []
    bus.subscribe(TOPICS.link, lambda _: heard.append("stays"))
    with bus.join() as member:
        member.subscribe(TOPICS.link, lambda _: heard.append("leaves"))
        member.answer("who", lambda _: "me")
    bus.publish(TOPICS.link, LinkStatus(0.0))
    member.publish(TOPICS.link, LinkStatus(1.0))
    assert heard == ["stays"]
    with pytest.raises(LinkError, match="nobody"):
        bus.ask("who")


def test_a_query_is_answered_with_the_request_text() -> None:
    bus = LocalBus()
    bus.join().answer("double", lambda text: text * 2)
    assert bus.ask("double", "ab") == "abab"


def test_a_query_whose_handler_fails_says_so_in_words() -> None:
    bus = LocalBus()

    def fail(text: str) -> str:
        raise ValueError(f"cannot read {text}")

    bus.answer("plan", fail)
    with pytest.raises(LinkError, match="cannot read x"):
        bus.ask("plan", "x")


def test_a_handler_may_subscribe_and_publish_itself() -> None:
    bus = LocalBus()
    heard: list[float] = []

    def echo(order: Order) -> None:
        bus.subscribe(TOPICS.link, lambda link: heard.append(link.at))
        bus.publish(TOPICS.link, LinkStatus(order.issued_at))

    bus.subscribe(TOPICS.order, echo)
    bus.publish(TOPICS.order, Order(OrderKind.GO, issued_at=3.0))
    assert heard == [3.0]


def test_no_message_is_lost_when_many_threads_publish_and_subscribe() -> None:
    bus = LocalBus()
    count = [0]
    lock = threading.Lock()

    def add(_: Order) -> None:
        with lock:
            count[0] += 1

    bus.subscribe(TOPICS.order, add)

    def work() -> None:
        for _ in range(200):
            bus.subscribe(TOPICS.link, lambda _: None).close()
            bus.publish(TOPICS.order, Order(OrderKind.HOVER))

    threads = [threading.Thread(target=work) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert count[0] == 1600
