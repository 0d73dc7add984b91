"""The interface of a sensor driver."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import inf
from typing import Protocol

from housefly.messages import Observation, RoomEvent

SensorSink = Callable[[Observation | RoomEvent], None]
"""Receives what a sensor reports; it neither waits nor raises."""
_Counts = tuple[tuple[str, int], ...]


@dataclass(frozen=True, slots=True)
class SensorHealth:
    """Health of one sensor.

    Attributes:
        id: of the sensor; the ``source`` of what it reports.
        kind: one word.
        title: the kind in words for people.
        connected: whether it is there and reports as often as it should.
        rate_hz: recent messages per second [Hz].
        age: time since it was last heard [s]; infinite if never.
        problem: what is wrong and what to do about it, a text or words; "" for nothing.
        counts: numbers of received and dropped messages, by name.
        is_offline: whether its own word, or its last will, is that it is gone.
    """

    id: str
    kind: str
    title: str
    connected: bool
    rate_hz: float = 0.0
    age: float = inf
    problem: str = ""
    counts: _Counts = ()
    is_offline: bool = False


class Sensor(Protocol):
    """A driver of one or several sensors on one wire; all calls belong to one asyncio loop."""

    async def run(self, sink: SensorSink) -> None:
        """Connect, feed the sink, and reconnect for ever; ends only when cancelled."""
        ...

    @property
    def connected(self) -> bool:
        """Whether the other side is there."""
        ...

    @property
    def problem(self) -> str:
        """Why it is not, a text or words; "" while it is."""
        ...

    def health(self) -> tuple[SensorHealth, ...]:
        """Return the health of the driver, then of each of its sensors."""
        ...
