"""What the room's process tells a pilot over their socket: frames, and the tracker's health."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from housefly.bus.codec import from_cdr, to_cdr
from housefly.bus.private_socket import FrameCutter, framed
from housefly.errors import WireError
from housefly.messages import TrackedFrame
from housefly.messages.words import UNSAID, Words, from_tree, tree

_MAGIC = b"HFt1"
_FRAME, _STATUS = 0, 1
_BODY_MAX = 256 * 1024
"""Longest body accepted [bytes], as on the bus (``FRAME_TOPIC``)."""


@dataclass(frozen=True, slots=True)
class TrackerStatus:
    """Health of the room's tracking client.

    Attributes:
        connected: whether frames arrive.
        problem: why not; UNSAID while they do.
    """

    connected: bool = False
    problem: Words = UNSAID


TrackingMessage = TrackedFrame | TrackerStatus


def encode_tracking_message(message: TrackingMessage) -> bytes:
    """Return a message with its header."""
    if isinstance(message, TrackedFrame):
        kind, body = _FRAME, to_cdr(message)
    else:
        kind, body = (
            _STATUS,
            bytes([message.connected]) + json.dumps(tree(message.problem)).encode(),
        )
    return framed(_MAGIC, kind, body)


class TrackingMessageReader:
    """Cuts a stream into messages."""

    def __init__(self) -> None:
        self._frames = FrameCutter(_MAGIC, len(_DECODE), _BODY_MAX)

    def feed(self, data: bytes) -> list[TrackingMessage]:
        """Append the next bytes and return the messages now complete, oldest first.

        Raises:
            WireError: no message of ours; the connection is of no use any more.
        """
        return [_DECODE[kind](body) for kind, body in self._frames.feed(data)]


def _status(body: bytes) -> TrackerStatus:
    try:
        return TrackerStatus(bool(body[0]), from_tree(json.loads(body[1:])))
    except (IndexError, ValueError, RecursionError) as error:
        raise WireError(f"a tracker's status that cannot be read: {error}") from error


_DECODE: tuple[Callable[[bytes], TrackingMessage], ...] = (partial(from_cdr, TrackedFrame), _status)
