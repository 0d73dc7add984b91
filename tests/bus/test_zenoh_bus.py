"""The bus between real processes."""

from __future__ import annotations

import json
import os
import queue
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from housefly.bus.bus import Bus
from housefly.bus.endpoint import endpoint_in
from housefly.bus.topics import DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.errors import LinkError, WireError
from housefly.messages import (
    Action,
    Command,
    Inputs,
    LinkStatus,
    Order,
    OrderKind,
    Outputs,
    PilotStep,
    VideoFrame,
)

TOPICS = DroneTopics()

pytestmark = pytest.mark.wire

CHILD = """
import json, os, sys, time
from housefly.bus.topics import DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.messages import LinkStatus, Order, OrderKind

options = json.loads(sys.argv[1])
name, TOPICS = options.pop("name"), DroneTopics()
bus = ZenohBus(**options)
def answer(order):
    bus.publish(TOPICS.link, LinkStatus(order.issued_at, notes=(name, order.place)))

bus.subscribe(TOPICS.order, answer)
bus.subscribe(TOPICS.video, lambda picture: None)
bus.answer("who/" + name, lambda text: f"{name} {text} {os.getpid()}")
print("ready", flush=True)
for line in sys.stdin:
    bus.publish(TOPICS.order, Order(OrderKind.GO, line.strip(), sender=name))
"""


class Child:
    """Another process on the bus: it answers ``who/NAME``, reports each order as a LINK, and sends
    orders when told.
    """

    def __init__(self, name: str, **options: Any) -> None:
        self.process = subprocess.Popen(
            [sys.executable, "-c", CHILD, json.dumps({"name": name, **options})],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        assert self.process.stdout is not None
        assert self.process.stdout.readline() == "ready\n"

    def order(self, place: str) -> None:
        assert self.process.stdin is not None
        self.process.stdin.write(place + "\n")
        self.process.stdin.flush()

    def leave(self) -> int:
        assert self.process.stdin is not None
        self.process.stdin.close()
        return self.process.wait(timeout=10)


@pytest.fixture
def child() -> Iterator[Callable[..., Child]]:
    children: list[Child] = []

    def start(name: str, **options: Any) -> Child:
        children.append(Child(name, **options))
        return children[-1]

    yield start
    for started in children:
        if started.process.poll() is None:
            started.process.kill()
        started.process.wait()
        for stream in (started.process.stdin, started.process.stdout):
            if stream is not None and not stream.closed:
                stream.close()


@pytest.fixture
def endpoint() -> Iterator[str]:
    with tempfile.TemporaryDirectory() as folder:
        yield endpoint_in(Path(folder))


def until(condition: Callable[[], Any], patience: float = 10.0) -> Any:
    """Return the first true value of the condition."""
    deadline = time.monotonic() + patience
    while time.monotonic() < deadline:
        if found := condition():
            return found
        time.sleep(0.005)
    raise AssertionError("it did not happen")


def step(number: int) -> PilotStep:
    return PilotStep(number, 0.01 * number, Inputs(), Outputs(Command(Action.IDLE)))


def test_a_message_crosses_to_another_process_and_back(
    endpoint: str, child: Callable[..., Child]
) -> None:
    with ZenohBus(listen=endpoint) as bus:
        heard: list[LinkStatus] = []
        bus.subscribe(TOPICS.link, heard.append)
        child("other", connect=endpoint)
        assert bus.ask("who/other", "is").startswith("other is ")
        bus.publish(TOPICS.order, Order(OrderKind.GO, "entrance", issued_at=1.5))
        until(lambda: heard)
        assert heard == [LinkStatus(1.5, notes=("other", "entrance"))]


def test_three_processes_hear_each_other_through_the_one_that_listens(
    endpoint: str, child: Callable[..., Child]
) -> None:
    child("pilot", listen=endpoint)
    web = child("web", connect=endpoint)
    with ZenohBus(connect=endpoint) as bus:
        orders: list[Order] = []
        bus.subscribe(TOPICS.order, orders.append)
        assert bus.ask("who/web").startswith("web")
        assert bus.ask("who/pilot").startswith("pilot")
        web.order("sofa")
        until(lambda: orders)
        assert orders == [Order(OrderKind.GO, "sofa", sender="web")]


def test_a_member_may_come_before_the_one_that_listens(
    endpoint: str, child: Callable[..., Child]
) -> None:
    with ZenohBus(connect=endpoint) as bus:
        with pytest.raises(LinkError, match="nobody answered"):
            bus.ask("who/pilot", timeout=0.2)
        child("pilot", listen=endpoint)
        assert bus.ask("who/pilot", timeout=10.0).startswith("pilot")


def test_orders_arrive_again_after_the_listener_was_killed_and_restarted(
    endpoint: str, child: Callable[..., Child]
) -> None:
    with ZenohBus(connect=endpoint) as bus:
        heard: list[LinkStatus] = []
        bus.subscribe(TOPICS.link, heard.append)
        for place in ("first", "second"):
            pilot = child("pilot", listen=endpoint)
            assert bus.ask("who/pilot", timeout=10.0).endswith(str(pilot.process.pid))
            bus.publish(TOPICS.order, Order(OrderKind.GO, place))
            until(lambda place=place: any(link.notes[1] == place for link in heard))
            os.kill(pilot.process.pid, signal.SIGKILL)
            pilot.process.wait()


def test_the_listener_goes_on_when_a_member_is_killed_and_a_new_one_comes(
    endpoint: str, child: Callable[..., Child]
) -> None:
    with ZenohBus(listen=endpoint) as bus:
        for _ in range(2):
            web = child("web", connect=endpoint)
            assert bus.ask("who/web", timeout=10.0).endswith(str(web.process.pid))
            os.kill(web.process.pid, signal.SIGKILL)
            web.process.wait()
            for number in range(50):
                bus.publish(TOPICS.step, step(number))


def test_a_stopped_member_does_not_hold_up_the_sender(
    endpoint: str, child: Callable[..., Child]
) -> None:
    picture = VideoFrame(bytes(100_000), True, 640, 360, 1, 0.0)
    with ZenohBus(listen=endpoint) as bus:
        heard: list[VideoFrame] = []
        web = child("web", connect=endpoint)
        assert bus.ask("who/web", timeout=10.0)
        watcher = ZenohBus(connect=endpoint)
        watcher.subscribe(TOPICS.video, heard.append)
        until(lambda: (bus.publish(TOPICS.video, picture), heard)[1])
        web.process.send_signal(signal.SIGSTOP)
        for _ in range(100):
            bus.publish(TOPICS.video, picture)
            time.sleep(0.01)
        web.process.send_signal(signal.SIGCONT)
        watcher.close()
        assert len(heard) > 50


def test_a_slow_handler_skips_messages_and_delays_nobody_else(endpoint: str) -> None:
    slow: list[LinkStatus] = []
    quick: list[LinkStatus] = []
    gate = threading.Event()

    def wait(link: LinkStatus) -> None:
        slow.append(link)
        gate.wait(10.0)

    with ZenohBus(listen=endpoint) as bus, ZenohBus(connect=endpoint) as other:
        other.subscribe(TOPICS.link, wait)
        other.subscribe(TOPICS.link, quick.append)
        until(lambda: (bus.publish(TOPICS.link, LinkStatus(-1.0)), quick and slow)[1])
        for number in range(100):
            bus.publish(TOPICS.link, LinkStatus(float(number)))
            until(lambda number=number: quick[-1].at == number)
        gate.set()
        until(lambda: slow[-1].at == 99.0)
        assert len(slow) <= 4


def test_a_recorder_that_stands_still_for_seconds_misses_no_step(endpoint: str) -> None:
    """Each step is sent when the last has crossed: what a busy machine's network drops is no miss.

    Nine seconds of them wait for the recorder.
    """
    heard: list[int] = []
    crossed: queue.Queue[int] = queue.Queue()
    gate = threading.Event()

    def slow(heard_of: PilotStep) -> None:
        heard.append(heard_of.sequence)
        gate.wait(60.0)

    with ZenohBus(listen=endpoint) as bus, ZenohBus(connect=endpoint) as other:
        other.subscribe(TOPICS.step, slow)
        other.subscribe(TOPICS.step, lambda heard_of: crossed.put(heard_of.sequence))
        until(lambda: (bus.publish(TOPICS.step, step(-1)), heard and not crossed.empty())[1])
        for number in range(900):
            bus.publish(TOPICS.step, step(number))
            while crossed.get(timeout=20.0) != number:
                pass  # one of those before the first
        assert heard == [-1], "it stands still"
        gate.set()
        until(lambda: heard[-1] == 899)
        assert heard[heard.index(0) :] == list(range(900))


def test_what_nobody_hears_is_not_even_encoded(endpoint: str) -> None:
    broken = LinkStatus("no time")  # type: ignore[arg-type]
    with ZenohBus(listen=endpoint) as bus, ZenohBus(connect=endpoint) as other:
        bus.publish(TOPICS.link, broken)
        heard: list[LinkStatus] = []
        other.subscribe(TOPICS.link, heard.append)
        until(lambda: (bus.publish(TOPICS.link, LinkStatus(1.0)), heard)[1])
        with pytest.raises(WireError, match="cannot be encoded"):
            bus.publish(TOPICS.link, broken)


def test_every_order_arrives_in_order_although_the_handler_is_slow(endpoint: str) -> None:
    heard: list[float] = []

    def slow(order: Order) -> None:
        time.sleep(0.0005)
        heard.append(order.issued_at)

    with ZenohBus(listen=endpoint) as bus, ZenohBus(connect=endpoint) as other:
        bus.subscribe(TOPICS.order, slow)
        bus.answer("there", str)
        other.ask("there", timeout=10.0)
        for number in range(1000):
            other.publish(TOPICS.order, Order(OrderKind.HOVER, issued_at=float(number)))
        until(lambda: len(heard) == 1000)
        assert heard == [float(number) for number in range(1000)]


def test_a_handler_that_fails_hears_the_next_message(
    endpoint: str, caplog: pytest.LogCaptureFixture
) -> None:
    heard: list[str] = []

    def handler(order: Order) -> None:
        heard.append(order.place)
        if order.place == "bad":
            raise ValueError("broken handler")

    with ZenohBus(listen=endpoint) as bus:
        bus.subscribe(TOPICS.order, handler)
        bus.publish(TOPICS.order, Order(OrderKind.GO, "bad"))
        bus.publish(TOPICS.order, Order(OrderKind.GO, "good"))
        until(lambda: heard == ["bad", "good"])
    assert "broken handler" in caplog.text


def test_a_failed_query_is_a_link_error_in_words(endpoint: str) -> None:
    def fail(text: str) -> str:
        raise ValueError(f"no way to {text}")

    with ZenohBus(listen=endpoint) as bus:
        bus.answer("plan", fail)
        with pytest.raises(LinkError, match="no way to the moon"):
            bus.ask("plan", "the moon")


def test_namespaces_keep_two_rooms_apart(endpoint: str) -> None:
    with (
        ZenohBus(listen=endpoint, namespace="one") as bus,
        ZenohBus(connect=endpoint, namespace="two") as other,
    ):
        bus.answer("who", lambda _: "one")
        with pytest.raises(LinkError, match="nobody"):
            other.ask("who", timeout=0.3)


def test_an_address_in_use_is_a_link_error_that_names_it(endpoint: str) -> None:
    with ZenohBus(listen=endpoint), pytest.raises(LinkError, match=f"{endpoint}.*in use"):
        ZenohBus(listen=endpoint)


def test_a_closed_bus_is_quiet_and_closing_twice_does_no_harm(endpoint: str) -> None:
    bus: Bus = ZenohBus(listen=endpoint)
    heard: list[Order] = []
    bus.subscribe(TOPICS.order, heard.append)
    bus.close()
    bus.close()
    bus.publish(TOPICS.order, Order(OrderKind.STOP))
    with pytest.raises(LinkError, match="closed"):
        bus.subscribe(TOPICS.order, heard.append)
    with pytest.raises(LinkError, match="closed"):
        bus.ask("who")
    assert heard == []


def test_a_closed_subscription_is_silent_also_when_its_own_handler_closes_it(endpoint: str) -> None:
    heard: list[Order] = []
    with ZenohBus(listen=endpoint) as bus:

        def once(order: Order) -> None:
            heard.append(order)
            subscription.close()

        subscription = bus.subscribe(TOPICS.order, once)
        for _ in range(3):
            bus.publish(TOPICS.order, Order(OrderKind.HOVER))
        until(lambda: heard)
        time.sleep(0.05)
        assert len(heard) == 1


def test_a_process_that_forgets_to_close_still_exits(
    endpoint: str, child: Callable[..., Child]
) -> None:
    with ZenohBus(listen=endpoint) as bus:
        web = child("web", connect=endpoint)
        assert bus.ask("who/web", timeout=10.0)
        assert web.leave() == 0


def test_with_several_threads_a_long_answer_holds_up_no_other(endpoint: str) -> None:
    going_on = threading.Event()

    def answer(text: str) -> str:
        if text == "long":
            going_on.wait(20.0)
        return text

    with ZenohBus(listen=endpoint) as bus, ZenohBus(connect=endpoint) as other:
        bus.answer("x", answer, threads=2)
        found: list[str] = []
        asking = threading.Thread(target=lambda: found.append(other.ask("x", "long", 20.0)))
        asking.start()
        assert other.ask("x", "short", 10.0) == "short"
        assert found == []
        going_on.set()
        asking.join()
        assert found == ["long"]
        bus.answer("broken", lambda text: str(1 // 0), threads=2)
        with pytest.raises(LinkError, match="failed"):
            other.ask("broken", "", 10.0)
