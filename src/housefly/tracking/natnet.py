"""Client of OptiTrack's Motive (and of all that streams NatNet 3 or 4), unicast or multicast as the
server has it.
"""

from __future__ import annotations

from housefly.bus.reconnect import Trouble, reconnect_for_ever
from housefly.clock import Clock, RealClock
from housefly.config.site import TrackingConfig
from housefly.tracking.contracts import Sink
from housefly.tracking.counts import FrameCounts
from housefly.tracking.natnet_session import NatNetSession

FRESH = 1.0
"""``connected`` means a frame within this time [s]."""


class NatNetTracker:
    """Asks who serves, listens where it streams, hands each frame to a sink as it arrives, and
    reconnects for ever.

    Attributes:
        counts: frames and what was dropped.
    """

    def __init__(self, config: TrackingConfig, clock: Clock | None = None) -> None:
        self.counts = FrameCounts()
        self._config = config
        self._clock = clock or RealClock()
        self._session: NatNetSession | None = None
        self._frame_at = float("-inf")
        self._problem = f"not connected to {config.address}:{config.natnet_port} yet"

    @property
    def connected(self) -> bool:
        """Whether a frame arrived within the last second."""
        return self._clock.now() - self._last_frame_at() <= FRESH

    @property
    def problem(self) -> str:
        """Why no poses arrive, in words, or ""."""
        if self._session is None or not self._session.greeted:
            return self._problem
        return self._session.flood_problem or ("" if self.connected else self._session.silence)

    async def run(self, sink: Sink) -> None:
        """Connect and listen for ever; ends only when cancelled."""
        await reconnect_for_ever(
            lambda: self._listen(sink), lambda: self.counts.frames, self._ended
        )

    async def _listen(self, sink: Sink) -> None:
        """Listen to one server to the end; raises LinkError."""
        self._session = NatNetSession(self._config, self._clock, sink, self.counts)
        try:
            await self._session.run()
        finally:
            self._frame_at, self._session = self._last_frame_at(), None

    def _ended(self, error: Trouble) -> None:
        self._problem = str(error)

    def _last_frame_at(self) -> float:
        return (
            self._frame_at if self._session is None else max(self._frame_at, self._session.frame_at)
        )
