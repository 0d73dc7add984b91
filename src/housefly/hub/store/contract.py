"""What every store can do, whatever keeps it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from housefly.errors import StoreError
from housefly.hub.things.thing import Thing
from housefly.messages import Happening, Observation

Trajectory = NDArray[np.float64]
"""One row a moment: time [s, Unix time], x, y, z [m]; shape (n, 4), by time."""

FULL_RATE = 3600.0
"""Samples younger than this are kept at the rate at which they came [s]."""
THIN_RATE = 10.0
"""Older ones are thinned to this rate [Hz]."""
KEPT_DAYS = 14.0
"""After this many days they are removed; what happened stays for good."""


class UnfitRowError(StoreError):
    """A row is such that the database will never take it."""


class Store(Protocol):
    """A database of the room. One thread at a time; open one for each thread that asks."""

    @property
    def notices(self) -> tuple[str, ...]:
        """What the user should know about how it was opened: a damaged file that was moved aside."""
        ...

    def know(self, things: Iterable[Thing]) -> None:
        """Keep things of the catalogue, replacing what was known of them."""
        ...

    def write(self, samples: Sequence[Observation], happenings: Sequence[Happening] = ()) -> None:
        """Keep all or nothing, in one transaction; writing the same again changes nothing.

        Raises:
            StoreError: not now; the same may be written again later.
            UnfitRowError: one of them never.
        """
        ...

    def things(self, thing: str = "") -> tuple[Thing, ...]:
        """Return one thing of the catalogue by its id (none when it is unknown), or all."""
        ...

    def latest(self, thing: str = "") -> tuple[Observation, ...]:
        """Return the last valid and the last invalid sample of each source, of one thing or of all."""
        ...

    def seen(self, at: float, thing: str = "") -> tuple[Observation, ...]:
        """Return the last valid sample of each source at or before a time [s, Unix time], of one
        thing or of all.

        ``captured_at`` is the last time, at most ``at``, at which the source said just that.
        """
        ...

    def trajectory(
        self, thing: str, since: float, until: float, *, source: str = "", every: float = 0.0
    ) -> Trajectory:
        """Return where a thing was between two times [s, Unix time].

        Args:
            thing: its id.
            since: begin, inclusive.
            until: end, inclusive.
            source: whose samples; "" for all sources, merged by time.
            every: at most one sample of each source in so many seconds; 0 for all.
        """
        ...

    def events(
        self, since: float, until: float, *, thing: str = "", kind: str = "", cause: str = ""
    ) -> tuple[Happening, ...]:
        """Return what happened between two times [s, Unix time], both inclusive, by time; "" means
        any.
        """
        ...

    def tidy(self, now: float) -> bool:
        """Thin and remove old samples in one short transaction; tell whether there is more to do."""
        ...

    def close(self) -> None:
        """Let go of the database."""
        ...
