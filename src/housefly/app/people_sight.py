"""What the pilot's shell hears of the sensors that look for people; the bus may carry anything."""

from __future__ import annotations

from math import inf

from housefly.clock import Clock
from housefly.config.site import Site
from housefly.messages import SightNews

_AHEAD_MAX = 0.05
"""News of a time further in the future is not believed [s]."""


class PeopleSight:
    """Keeps until when each of the site's sensors was believed.

    Args:
        site: whether it has any.
        clock: the pilot's.

    Attributes:
        seen_at: as ``Inputs.people_seen_at`` [s].
    """

    def __init__(self, site: Site, clock: Clock) -> None:
        self._clock = clock
        self.seen_at = -inf if site.sees_people else inf

    def heard(self, news: SightNews) -> None:
        """Take in news; what is older, of the future or not a number changes nothing."""
        if self.seen_at < news.seen_at <= self._clock.now() + _AHEAD_MAX:
            self.seen_at = news.seen_at
