"""One MCAP file of ROS 2 messages, readable up to its last second if writer or power dies."""

from __future__ import annotations

import os
import time
from pathlib import Path
from typing import Any

from mcap.writer import Writer

from housefly.bus.codec import to_cdr
from housefly.bus.interfaces import definition, ros_name, type_store
from housefly.config.durable import SyncPace, sync_folder
from housefly.record.ros_messages import nanoseconds

_CHUNK_SIZE = 32 * 1024
"""Chunk size [bytes]: a quarter of a second at 100 steps/s is lost when the process dies."""
_BUFFER_SIZE = 512
"""Smaller than a chunk [bytes], so that each chunk is written as soon as it is finished."""


class McapLog:
    """An open recording; every method may raise OSError.

    Log times are dates, so that viewers show when it was; the stamps inside the messages stay on
    the flight's own clock.

    Args:
        path: file to write.
        notes: what is kept beside the messages, as text.
    """

    def __init__(self, path: Path, notes: dict[str, str]) -> None:
        self._file = path.open("wb", buffering=_BUFFER_SIZE)
        self._writer = Writer(self._file, chunk_size=_CHUNK_SIZE)
        self._writer.start(profile="ros2", library="housefly")
        self._writer.add_metadata("housefly", notes)
        self._file.flush()
        os.fsync(self._file.fileno())
        sync_folder(path.parent)
        self._pace = SyncPace()
        self._channels: dict[str, int] = {}
        self._counts: dict[str, int] = {}
        self._epoch: float | None = None

    def add(self, topic: str, at: float, message: Any) -> None:
        """Append a message of a standard ROS 2 type at a time [s]."""
        self._append(
            topic,
            at,
            message.__msgtype__,
            bytes(type_store().serialize_cdr(message, message.__msgtype__)),
        )

    def add_own(self, topic: str, at: float, message: object) -> None:
        """Append one of our own messages at a time [s]."""
        self._append(topic, at, ros_name(type(message).__name__), to_cdr(message))

    def close(self) -> None:
        """Write the index and close the file."""
        try:
            self._writer.finish()  # type: ignore[no-untyped-call]
            self._file.flush()
            os.fsync(self._file.fileno())
        finally:
            self._file.close()

    def _append(self, topic: str, at: float, type_name: str, data: bytes) -> None:
        channel = self._channels.get(topic)
        if channel is None:
            schema = self._writer.register_schema(
                type_name, "ros2msg", definition(type_name).encode()
            )
            channel = self._channels[topic] = self._writer.register_channel(topic, "cdr", schema)
        count = self._counts[topic] = self._counts.get(topic, -1) + 1
        if self._epoch is None:
            self._epoch = time.time() - at
        stamp = nanoseconds(self._epoch + at)
        self._writer.add_message(channel, stamp, data, stamp, count)
        if self._pace.is_due():
            self._file.flush()
            os.fsync(self._file.fileno())
