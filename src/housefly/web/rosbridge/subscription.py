"""What waits of one topic for one client: so many messages, not too often. Pure."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field

from housefly.ros2.topic_table import Quality

DEPTH = {Quality.SENSOR: 5, Quality.STATE: 50, Quality.LATCHED: 1}
"""Messages of a topic that wait where the client does not say."""
DEPTH_MAX = 100


@dataclass(frozen=True, slots=True)
class Pace:
    """What one subscription asks for.

    Attributes:
        period: least time between two messages [s].
        depth: messages that may wait.
    """

    period: float
    depth: int


def pace_of(throttle_rate: float, queue_length: int, quality: Quality) -> Pace:
    """Return the pace of a subscription.

    Args:
        throttle_rate: least time between two messages [ms].
        queue_length: messages that may wait; 0 for the newest alone where it is throttled, and
            for what the topic keeps where it is not.
        quality: of the topic.
    """
    usual = 1 if throttle_rate else DEPTH[quality]
    return Pace(throttle_rate / 1e3, min(queue_length or usual, DEPTH_MAX))


@dataclass(slots=True)
class Subscription:
    """The messages of one topic that wait; the oldest is dropped for a new one.

    Attributes:
        paces: of each subscription by its id; of several the quickest holds.
        size: of what waits [characters].
    """

    paces: dict[str | int | None, Pace] = field(default_factory=dict)
    size: int = 0
    _waiting: deque[str] = field(default_factory=deque)
    _sent_at: float = float("-inf")

    def add(self, text: str) -> None:
        """Let a message wait."""
        depth = min(one.depth for one in self.paces.values())
        while len(self._waiting) >= depth:
            self._drop()
        self._waiting.append(text)
        self.size += len(text)

    def clear(self) -> None:
        """Drop all that waits."""
        while self._waiting:
            self._drop()

    def wait(self, now: float) -> float:
        """Return how long it takes until a message may go [s]; infinite where none waits."""
        if not self._waiting:
            return float("inf")
        period = min(one.period for one in self.paces.values())
        return max(0.0, self._sent_at + period - now)

    def take(self, now: float) -> str:
        """Return the oldest that waits."""
        self._sent_at = now
        return self._drop()

    def _drop(self) -> str:
        text = self._waiting.popleft()
        self.size -= len(text)
        return text
