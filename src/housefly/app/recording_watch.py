"""Lets the drone's light say that its camera is recorded, for as long as whoever records says so.

The recorder tells it on the bus, again and again. When it dies, nothing is recorded any more and
nothing is told any more: the light goes out.
"""

from __future__ import annotations

from collections.abc import Callable

from housefly.drones.contract import Drone
from housefly.messages import RecordingNews

NEWS_AGE_MAX = 1.5
"""What was said longer ago does not count [s]."""
REFRESH_PERIOD = 0.25
"""How often the drone is told again [s]."""
NO_LIGHT = "the camera is recorded; this drone has no light that says so"


class RecordingWatch:
    """Passes on what the recorder says; belongs to one asyncio loop.

    Args:
        drone: whose light it is.
        now: the machine's monotonic clock, which the recorder has too [s].
    """

    def __init__(self, drone: Drone, now: Callable[[], float]) -> None:
        self._drone, self._now = drone, now
        self._news = RecordingNews(float("-inf"), records=False)
        self._was_told = False

    @property
    def records(self) -> bool:
        """Whether the camera is recorded, as far as is known now."""
        return self._news.records and self._now() - self._news.at <= NEWS_AGE_MAX

    @property
    def note(self) -> str:
        """That a drone without a light is recorded, in words, or ""."""
        known = self._drone.capabilities
        has_light = known is not None and known.light
        return NO_LIGHT if self.records and not has_light else ""

    def heard(self, news: RecordingNews) -> None:
        """Take in what the recorder says; what is older than the newest does not count."""
        if self._news.at <= news.at <= self._now():
            self._news = news
            self.refresh()

    def refresh(self) -> None:
        """Tell the drone again; nothing is said while nothing is recorded."""
        if (records := self.records) or self._was_told:
            self._drone.show_recording(records)
        self._was_told = records
