"""The interface of a store."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from housefly.errors import StoreError
from housefly.hub.things.thing import Thing
from housefly.messages import Observation, RoomEvent

TrajectoryRows = NDArray[np.float64]
"""Rows of time [s, Unix time], x, y, z [m], sorted by time; shape (n, 4)."""

FULL_RATE_AGE = 3600.0
"""Samples younger than this are kept at their full rate [s]."""
THINNED_RATE = 10.0
"""Older samples are thinned to this rate [Hz]."""
DEFAULT_KEEP_DAYS = 14.0
"""Samples are deleted after this many days; events are kept for ever."""


class RejectedRowError(StoreError):
    """The database will never accept this row."""


class Store(Protocol):
    """A database of the room. Not thread-safe; open one per thread."""

    @property
    def notices(self) -> tuple[str, ...]:
        """What the user should know about how it was opened: a damaged file, for example."""
        ...

    def put_things(self, things: Iterable[Thing]) -> None:
        """Write things of the catalogue, replacing older ones."""
        ...

    def write(self, samples: Sequence[Observation], events: Sequence[RoomEvent] = ()) -> None:
        """Write all or nothing, in one transaction; writing the same again changes nothing.

        Raises:
            StoreError: not now; the same may be written again later.
            RejectedRowError: one of them never.
        """
        ...

    def things(self, thing: str = "") -> tuple[Thing, ...]:
        """Return one thing of the catalogue by its id (none if unknown), or all."""
        ...

    def latest(self, thing: str = "") -> tuple[Observation, ...]:
        """Return the last valid and invalid sample of each source, of one thing or of all."""
        ...

    def latest_at(self, at: float, thing: str = "") -> tuple[Observation, ...]:
        """Return the last valid sample of each source up to a time [s, Unix time].

        ``captured_at`` is the last time, at most ``at``, at which the source reported just that.
        """
        ...

    def trajectory(
        self, thing: str, since: float, until: float, *, source: str = "", every: float = 0.0
    ) -> TrajectoryRows:
        """Return where a thing was between two times [s, Unix time].

        Args:
            thing: its id.
            since: begin, inclusive.
            until: end, inclusive.
            source: whose samples; "" for all sources, merged by time.
            every: at most one sample per source in this many seconds; 0 for all.
        """
        ...

    def events(
        self, since: float, until: float, *, thing: str = "", kind: str = "", cause: str = ""
    ) -> tuple[RoomEvent, ...]:
        """Return events between two times [s, Unix time], inclusive, by time; "" is any."""
        ...

    def prune(self, now: float) -> bool:
        """Thin and delete old samples in one short transaction; return whether more is left."""
        ...

    def close(self) -> None:
        """Close the database."""
        ...
