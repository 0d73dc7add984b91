"""Feeds run exactly while somebody watches one of their channels."""

from __future__ import annotations

from collections.abc import Sequence

from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import LinkError
from housefly.foxglove.demand import Demand, Feed

TOPICS = ("/a", "/b", "/c", "/d")
FEEDS = (("/a", "/b"), ("/c",), ("/a", "/d"))


class Server:
    """Who watches what, without a wire."""

    def __init__(self) -> None:
        self.watched: dict[str, int] = dict.fromkeys(TOPICS, 0)
        self.forgotten: list[str] = []
        self.again: list[str] = []

    def is_wanted(self, topic: str) -> bool:
        return self.watched[topic] > 0

    def send_again(self, topic: str) -> None:
        self.again.append(topic)

    def forget(self, topics: Sequence[str]) -> None:
        self.forgotten += topics


class Tap:
    """Counts how often something runs at once."""

    def __init__(self) -> None:
        self.open = 0

    def start(self) -> Sequence[Tap]:
        self.open += 1
        return (self,)

    def close(self) -> None:
        self.open -= 1


@given(st.lists(st.tuples(st.sampled_from(TOPICS), st.booleans()), max_size=30))
def test_each_feed_runs_once_while_one_of_its_channels_is_watched_and_else_not(
    changes: list[tuple[str, bool]],
) -> None:
    server, taps = Server(), [Tap() for _ in FEEDS]
    demand = Demand([Feed(topics, tap.start) for topics, tap in zip(FEEDS, taps, strict=True)])
    for topic, has_come in changes:
        server.watched[topic] = max(0, server.watched[topic] + (1 if has_come else -1))
        demand.follow(server, topic, has_come)
        for topics, tap in zip(FEEDS, taps, strict=True):
            assert tap.open == any(server.watched[name] for name in topics)
    assert server.again == [topic for topic, has_come in changes if has_come]
    demand.end()
    demand.run(server)
    assert [tap.open for tap in taps] == [0, 0, 0]


def test_what_a_feed_kept_is_forgotten_when_it_ends() -> None:
    server, tap = Server(), Tap()
    demand = Demand([Feed(("/a", "/b"), tap.start)])
    server.watched["/a"] = 1
    demand.update(server)
    assert server.forgotten == []
    server.watched["/a"] = 0
    demand.update(server)
    assert server.forgotten == ["/a", "/b"]


def test_a_feed_that_cannot_begin_is_tried_again() -> None:
    tap, server, fails = Tap(), Server(), [True]

    def start() -> Sequence[Tap]:
        if fails.pop() if fails else False:
            raise LinkError("the bus is closed")
        return tap.start()

    demand = Demand([Feed(("/a",), start)])
    server.watched["/a"] = 1
    demand.update(server)
    assert tap.open == 0
    demand.update(server)
    assert tap.open == 1
