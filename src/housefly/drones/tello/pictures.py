"""A Tello's pictures, UDP 11111: pieces to ``VideoFrame``, from a key frame on."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from housefly.clock import Clock
from housefly.config.capabilities import OnboardCamera
from housefly.messages import VideoFrame
from housefly.wires.annex_b import can_begin
from housefly.wires.tello.pieces import PIECE_BYTES, PictureJoiner

STALL_TIME = 2.0
"""After this long without a picture it counts as gone, and is asked for again [s]."""
_PIECES_MAX = 2000
"""More pieces in a second are thrown away: 4 Mbit/s are 350."""


class Pictures(asyncio.DatagramProtocol):
    """Hands on what can be decoded.

    Args:
        drone: its IP address; nobody else is heard.
        camera: gives the size of a picture.
        clock: for ages.

    Attributes:
        handlers: called with each picture.
    """

    def __init__(self, drone: str, camera: OnboardCamera, clock: Clock) -> None:
        self.handlers: list[Callable[[VideoFrame], None]] = []
        self._drone, self._camera, self._clock = drone, camera, clock
        self._joiner = PictureJoiner()
        self._last_at = float("-inf")
        self._number, self._broken = 0, 0
        self._follows = False
        self._counted_since, self._counted = float("-inf"), 0

    @property
    def connected(self) -> bool:
        """Whether pictures arrive."""
        return self._clock.now() - self._last_at < STALL_TIME

    def datagram_received(self, data: bytes, addr: tuple[str, int]) -> None:
        """Take in a piece; too long ones, too many, and those of others are dropped."""
        if addr[0] != self._drone or len(data) > PIECE_BYTES or self._is_flooded():
            return
        for picture in self._joiner.feed(data):
            self._see(picture)

    def error_received(self, exc: Exception) -> None:
        """Ignore it: nothing is sent from here."""

    def _see(self, picture: bytes) -> None:
        is_key = can_begin(picture)
        is_whole = self._joiner.broken == self._broken
        self._broken = self._joiner.broken
        self._follows = is_key or (self._follows and is_whole)
        if not self._follows:
            return
        self._last_at = self._clock.now()
        self._number += 1
        frame = VideoFrame(
            data=picture,
            keyframe=is_key,
            width=self._camera.width,
            height=self._camera.height,
            sequence=self._number,
            received_at=self._last_at,
        )
        for handler in self.handlers:
            handler(frame)

    def _is_flooded(self) -> bool:
        now = self._clock.now()
        if now - self._counted_since > 1.0:
            self._counted_since, self._counted = now, 0
        self._counted += 1
        return self._counted > _PIECES_MAX
