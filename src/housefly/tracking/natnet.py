"""Client of OptiTrack's Motive and of other NatNet 3 and 4 servers, unicast or multicast."""

from __future__ import annotations

from housefly.bus.reconnect import ReconnectingClient
from housefly.clock import Clock
from housefly.config.tracking import TrackingConfig
from housefly.messages import Sighting
from housefly.messages.words import UNSAID, Words
from housefly.tracking.contracts import SightingSink
from housefly.tracking.counts import FrameCounts
from housefly.tracking.natnet_session import NatNetSession


class NatNetTracker(ReconnectingClient[tuple[Sighting, ...]]):
    """Asks who serves, listens where it streams, and hands each frame to a sink as it arrives.

    Attributes:
        counts: frames and what was dropped.
    """

    def __init__(self, config: TrackingConfig, clock: Clock | None = None) -> None:
        super().__init__(f"{config.address}:{config.natnet_port}", clock)
        self.counts = FrameCounts()
        self._config = config
        self._session: NatNetSession | None = None

    @property
    def problem(self) -> Words:
        """Why no poses arrive, or why some are dropped; UNSAID where all is well."""
        if self._session is None or not self._session.greeted:
            return self._problem
        return (
            self._session.flood_problem
            or self.counts.unit_problem(self._clock.now())
            or (UNSAID if self.connected else self._session.silence)
        )

    async def _read_connection(self, sink: SightingSink) -> None:
        def hand_on(sightings: tuple[Sighting, ...]) -> None:
            self._data_arrived(self._clock.now())
            sink(sightings)

        self._session = NatNetSession(self._config, self._clock, hand_on, self.counts)
        try:
            await self._session.run()
        finally:
            self._session = None
