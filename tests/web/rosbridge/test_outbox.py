"""What waits for a client: bounded, in turn, not too often."""

from __future__ import annotations

import asyncio
import threading

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import WireError
from housefly.ros2.topic_table import Quality
from housefly.web.rosbridge.outbox import IDS_MAX, REPLIES_MAX, TOPICS_MAX, WAITING_MAX, Outbox
from housefly.web.rosbridge.subscription import DEPTH_MAX, Pace, Subscription, pace_of

NOW = Pace(0.0, 3)


@given(st.lists(st.sampled_from(["add", "take"]), max_size=60), st.integers(1, 5))
def test_the_newest_wait_and_never_more_than_asked(acts: list[str], depth: int) -> None:
    topic, expected = Subscription({None: Pace(0.0, depth)}), list[str]()
    for number, act in enumerate(acts):
        if act == "add":
            topic.add(str(number))
            expected = [*expected, str(number)][-depth:]
        elif expected:
            assert topic.wait(0.0) == 0.0
            assert topic.take(0.0) == expected.pop(0)
        assert topic.size == sum(map(len, expected))
    assert (topic.wait(0.0) == float("inf")) is (not expected)


def test_a_throttled_topic_waits_and_of_several_paces_the_quickest_holds() -> None:
    topic = Subscription({"a": Pace(1.0, 1), "b": Pace(4.0, 2)})
    topic.add("one")
    assert topic.wait(10.0) == 0.0 and topic.take(10.0) == "one"
    topic.add("two")
    topic.add("three")
    assert topic.wait(10.25) == 0.75 and topic.take(11.0) == "three"


@pytest.mark.parametrize(
    ("rate", "length", "quality", "expected"),
    [
        (0.0, 0, Quality.SENSOR, Pace(0.0, 5)),
        (0.0, 0, Quality.LATCHED, Pace(0.0, 1)),
        (500.0, 0, Quality.STATE, Pace(0.5, 1)),
        (500.0, 7, Quality.STATE, Pace(0.5, 7)),
        (0.0, 10**6, Quality.SENSOR, Pace(0.0, DEPTH_MAX)),
    ],
)
def test_the_pace_of_a_subscription(
    rate: float, length: int, quality: Quality, expected: Pace
) -> None:
    assert pace_of(rate, length, quality) == expected


async def test_replies_go_first_and_topics_take_turns() -> None:
    outbox = Outbox(asyncio.get_running_loop())
    for name in ("a", "b"):
        outbox.subscribe(name, None, NOW)
    for number in range(2):
        outbox.offer("a", f"a{number}")
        outbox.offer("b", f"b{number}")
    outbox.offer("nobody hears this", "c")
    outbox.reply("reply")
    assert [await outbox.next() for _ in range(5)] == ["reply", "a0", "b0", "a1", "b1"]


async def test_a_message_of_another_thread_wakes_the_writer() -> None:
    outbox = Outbox(asyncio.get_running_loop())
    outbox.subscribe("a", None, NOW)
    waiting = asyncio.create_task(outbox.next())
    await asyncio.sleep(0)
    threading.Thread(target=outbox.offer, args=("a", "text")).start()
    assert await waiting == "text"


async def test_topics_subscriptions_replies_and_size_are_bounded() -> None:
    outbox = Outbox(asyncio.get_running_loop())
    for number in range(TOPICS_MAX):
        outbox.subscribe(str(number), None, NOW)
    with pytest.raises(WireError, match="topics are heard already"):
        outbox.subscribe("one more", None, NOW)
    for number in range(1, IDS_MAX):
        outbox.subscribe("0", number, NOW)
    with pytest.raises(WireError, match="subscriptions already"):
        outbox.subscribe("0", IDS_MAX, NOW)
    half = "x" * (WAITING_MAX // 2)
    for _ in range(3):
        outbox.offer("0", half)
        outbox.offer("1", half)
    taken = [await outbox.next() for _ in range(2)]
    assert sum(map(len, taken)) <= WAITING_MAX
    for _ in range(REPLIES_MAX + 1):
        outbox.reply("a")
    with pytest.raises(ConnectionAbortedError):
        while True:
            await outbox.next()


async def test_the_last_subscription_of_a_topic_ends_it() -> None:
    outbox = Outbox(asyncio.get_running_loop())
    outbox.subscribe("a", "1", NOW)
    outbox.subscribe("a", "2", NOW)
    assert not outbox.unsubscribe("a", "1")
    assert outbox.unsubscribe("a", "2") and outbox.topics() == ()
    outbox.subscribe("a", "1", NOW)
    assert outbox.unsubscribe("a", None)
