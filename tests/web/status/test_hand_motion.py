"""Whether somebody moves the drone by hand, as the console hears it from the pilot."""

from __future__ import annotations

from fake_pilot import FakePilot
from fake_room import example_room

from housefly.bus.local import LocalBus
from housefly.bus.topics import DroneTopics
from housefly.clock import SteppedClock
from housefly.messages import DroneStatus, Order, OrderKind, Phase
from housefly.web.status.state_feed import StateFeed

TOPICS = DroneTopics()

STEP = 0.1
MOVED = "Anna"


class Moved:
    """A pilot whose drone hovers, and what the console hears of it."""

    def __init__(self) -> None:
        self.bus, self.clock = LocalBus(), SteppedClock(100.0)
        self.feed = StateFeed(self.clock, "ardrone")
        self.feed.listen(self.bus)
        self.pilot = FakePilot(self.bus.join(), example_room(), self.clock)
        self.pilot.status, self.pilot.phase = DroneStatus.FLYING, Phase.HOLDING

    def nudge(self) -> None:
        now, east = self.clock.now(), (0.4, 0.0, 0.0)
        self.bus.publish(
            TOPICS.order, Order(OrderKind.NUDGE, issued_at=now, sender="Anna", velocity=east)
        )
        self.wait(STEP)

    def wait(self, seconds: float) -> None:
        for _ in range(round(seconds / STEP)):
            self.pilot.advance(STEP)
            self.clock.advance(STEP)


def test_it_is_known_from_the_first_nudge_until_nobody_has_moved_it_for_a_while() -> None:
    moved = Moved()
    moved.wait(STEP)
    assert moved.feed.hand_motion is None
    for _ in range(3):
        moved.nudge()
        assert moved.feed.hand_motion == MOVED
    moved.wait(3.0)
    assert moved.feed.hand_motion is None
    moved.nudge()
    assert moved.feed.hand_motion == MOVED


def test_another_order_or_another_pilot_ends_it_though_nobody_says_so() -> None:
    moved = Moved()
    moved.nudge()
    moved.pilot.phase = Phase.RETURNING
    moved.wait(STEP)
    moved.pilot.phase = Phase.HOLDING
    moved.wait(STEP)
    assert moved.feed.hand_motion is None
    moved = Moved()
    moved.nudge()
    moved.wait(STEP)
    assert moved.feed.hand_motion == MOVED
    moved.pilot.sequence = 0
    moved.wait(STEP)
    assert moved.feed.hand_motion is None
