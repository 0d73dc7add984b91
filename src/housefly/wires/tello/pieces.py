"""A Tello's pictures on UDP 11111: H.264 cut into pieces of 1460 bytes, without any header.

A shorter piece ends a picture. Pieces carry no numbers: one that is lost in the middle of a picture
is not missed, and a picture whose last piece is lost ends where the next one begins.
"""

from __future__ import annotations

from housefly.wires.annex_b import START_CODE

PIECE_BYTES = 1460
PICTURE_BYTES_MAX = 400_000
"""A larger picture is none: key frames of 960x720 at 4 Mbit/s have some 100 kB."""
_LONG_START_CODE = b"\x00" + START_CODE


def pieces_of(picture: bytes) -> tuple[bytes, ...]:
    """Return the datagrams of an access unit.

    One that would end with a full piece gets a zero byte, which H.264 allows behind a unit.
    """
    whole = picture + b"\x00" if len(picture) % PIECE_BYTES == 0 else picture
    return tuple(whole[at : at + PIECE_BYTES] for at in range(0, len(whole), PIECE_BYTES))


class PictureJoiner:
    """Joins pieces to pictures; what has no beginning is thrown away. Never raises.

    Attributes:
        broken: pictures thrown away because their beginning was lost, or they had no end.
    """

    def __init__(self) -> None:
        self.broken = 0
        self._pieces: list[bytes] = []
        self._length = 0

    def feed(self, piece: bytes) -> tuple[bytes, ...]:
        """Take in a datagram; return the pictures now complete."""
        begins = piece.startswith((_LONG_START_CODE, START_CODE))
        ended = self._taken() if begins and self._pieces else None
        if not (begins or self._pieces):
            self.broken += len(piece) < PIECE_BYTES
            return ()
        self._pieces.append(piece)
        self._length += len(piece)
        if len(piece) < PIECE_BYTES:
            last = self._taken()
            return (last,) if ended is None else (ended, last)
        if self._length > PICTURE_BYTES_MAX:
            self._taken()
            self.broken += 1
        return () if ended is None else (ended,)

    def _taken(self) -> bytes:
        picture = b"".join(self._pieces)
        self._pieces.clear()
        self._length = 0
        return picture
