"""Reads the messages of one MCAP file of ROS 2 messages, up to the last whole one of a cut file."""

from __future__ import annotations

import struct
from collections.abc import Iterator
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import BinaryIO

from mcap.exceptions import EndOfFile, McapError
from mcap.opcode import Opcode
from mcap.records import Channel, McapRecord, Message, Schema
from mcap.stream_reader import StreamReader
from mcap.writer import MCAP0_MAGIC
from zstandard import ZstdError

from housefly.errors import RecordingError

_RECORD_LIMIT = 64 * 2**20
"""Largest record in a sane recording [bytes]; a damaged length must not exhaust the memory."""
_PIECE = 2**20
_HEAD = struct.Struct("<BQ")
"""Kind and length [bytes] of an MCAP record."""


@dataclass(frozen=True, slots=True)
class RecordedMessage:
    """One message as it is in the file.

    Attributes:
        topic: of the message.
        at: when it was recorded [Unix time, s].
        type_name: ROS 2 name of its type.
        schema: text of the type, nested types included.
        encoding: of the bytes: "cdr".
        data: the bytes.
        stamp: ``at`` in whole nanoseconds.
    """

    topic: str
    at: float
    type_name: str
    schema: str
    encoding: str
    data: bytes
    stamp: int


def flight_file(path: Path) -> Path:
    """Return the file of a recording that is named by its folder."""
    return path / "flight.mcap" if path.is_dir() else path


def read_messages(path: Path) -> Iterator[RecordedMessage]:
    """Yield every message in the order of the file; a truncated one ends at its last readable one.

    Raises:
        RecordingError: the file is absent, is no MCAP, or is damaged in the middle.
    """
    try:
        file = path.open("rb")
    except OSError as error:
        raise RecordingError(f"{path} cannot be read: {error.strerror}") from error
    schemas: dict[int, tuple[str, str]] = {}
    channels: dict[int, Channel] = {}
    with file:
        for record in _records(file, path):
            if isinstance(record, Schema):
                schemas[record.id] = record.name, record.data.decode(errors="replace")
            elif isinstance(record, Channel):
                channels[record.id] = record
            elif isinstance(record, Message) and record.channel_id in channels:
                channel = channels[record.channel_id]
                yield RecordedMessage(
                    channel.topic,
                    record.log_time / 1e9,
                    *schemas.get(channel.schema_id, ("", "")),
                    channel.message_encoding,
                    record.data,
                    record.log_time,
                )


def _records(file: BinaryIO, path: Path) -> Iterator[McapRecord]:
    """Yield the records of an MCAP file; ends quietly after the last complete one."""
    if file.read(len(MCAP0_MAGIC)) != MCAP0_MAGIC:
        raise RecordingError(f"{path} is not a recording")
    while len(head := file.read(_HEAD.size)) == _HEAD.size:
        opcode, length = _HEAD.unpack(head)
        if length > _RECORD_LIMIT:
            raise RecordingError(f"{path} is damaged: a record of {length} bytes")
        body = file.read(length)
        if len(body) < length or opcode == Opcode.FOOTER:
            return
        try:
            yield from StreamReader(
                BytesIO(head + body), skip_magic=True, validate_crcs=True
            ).records
        except EndOfFile:
            # The end of this one record, which is whole.
            continue
        except (
            McapError,
            ZstdError,
            struct.error,
            ValueError,
            OverflowError,
            MemoryError,
        ) as error:
            if _is_torn_end(file):
                return
            raise RecordingError(f"{path} is damaged: {error}") from error


def _is_torn_end(file: BinaryIO) -> bool:
    """Return whether nothing follows a record that cannot be read, or what a power cut leaves.

    Some file systems know how long a file is before they have what is in it: that reads as zeros.
    """
    return not any(piece.strip(b"\0") for piece in iter(lambda: file.read(_PIECE), b""))
