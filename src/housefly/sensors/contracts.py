"""What a sensor driver offers to whoever gathers what the room knows."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import inf
from typing import Protocol

from housefly.messages import Observation, RoomEvent

SensorSink = Callable[[Observation | RoomEvent], None]
"""Takes what a sensor tells; it neither waits nor raises."""
_Counts = tuple[tuple[str, int], ...]


@dataclass(frozen=True, slots=True)
class SensorHealth:
    """How one sensor does.

    Attributes:
        id: of the sensor; the ``source`` of what it tells.
        kind: what it is, one word.
        title: the same for people.
        connected: whether it is there and speaks as often as it should.
        rate_hz: messages per second lately [Hz].
        age: time since it was last heard [s]; infinite when never.
        problem: what is wrong and what to do about it, in words, or "".
        counts: what was heard and what was dropped, by name.
    """

    id: str
    kind: str
    title: str
    connected: bool
    rate_hz: float = 0.0
    age: float = inf
    problem: str = ""
    counts: _Counts = ()


class Sensor(Protocol):
    """One driver, of one sensor or of many that share a wire; all calls belong to one asyncio loop."""

    async def run(self, sink: SensorSink) -> None:
        """Connect, hand what is heard to the sink, reconnect for ever; ends only when cancelled."""
        ...

    @property
    def connected(self) -> bool:
        """Whether the other side of the wire is there."""
        ...

    @property
    def problem(self) -> str:
        """Why not, in words, or ""."""
        ...

    def health(self) -> tuple[SensorHealth, ...]:
        """Return how the driver and each of its sensors do now, the driver first."""
        ...
