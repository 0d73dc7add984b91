"""One clip on its way to the disk: readable at every moment, and named only when it is whole."""

from __future__ import annotations

import logging
import os
import struct
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from enum import Enum
from pathlib import Path
from typing import Any

import av
from av.container import InputContainer

from housefly.config.durable import sync_file, sync_folder
from housefly.messages import VideoFrame
from housefly.record.movie import Movie

_LOG = logging.getLogger(__name__)
CLIP_SUFFIX, PART_SUFFIX = ".mp4", ".mp4.part"
_REMUXED_SUFFIX = ".mp4.mended"
_BOX = struct.Struct(">I4s")
"""Length [bytes] and kind of a box of MP4 (ISO 14496-12, section 4.2)."""
_FIRST_BOXES, _BEGUN_MAX = (b"ftyp", b"free"), 4096
"""What a file begins with, and more than that is [bytes]."""


@dataclass(frozen=True, slots=True)
class ClipFile:
    """A whole clip: when its first picture arrived [s], its duration [s], its size [bytes]."""

    path: Path
    began_at: float
    duration: float
    size: int


class ClipWriter:
    """Writes one MP4 file that grows by fragments; a writer that dies leaves a readable one.

    Args:
        path: where the clip lies when it is whole; its folder must exist.

    Raises:
        OSError: the file cannot be made.
    """

    def __init__(self, path: Path) -> None:
        self._path, self._part = path, path.with_name(path.stem + PART_SUFFIX)
        create_private(self._part)
        self._movie = Movie(self._part)
        self._began_at: float | None = None
        self._newest = 0.0
        self._count = 0

    def add(self, frame: VideoFrame) -> None:
        """Append a picture; those before the first key frame are left out.

        May raise OSError and av.FFmpegError.
        """
        if self._began_at is None and not frame.keyframe:
            return
        self._movie.add(frame)
        self._began_at = frame.received_at if self._began_at is None else self._began_at
        self._newest = max(self._newest, frame.received_at)
        self._count += 1

    def finish(self) -> ClipFile | None:
        """Close the file and give it its name; None, and no file, when it has no picture.

        May raise OSError and av.FFmpegError.
        """
        self._movie.close()
        if self._began_at is None or not self._part.stat().st_size:
            self._part.unlink(missing_ok=True)
            return None
        _publish(self._part, self._path)
        duration = self._newest - self._began_at
        duration += duration / (self._count - 1) if self._count > 1 else 0.0
        return ClipFile(self._path, self._began_at, duration, self._path.stat().st_size)

    def abandon(self) -> None:
        """Close the file as well as it can be, and leave it as what a crash would leave."""
        try:
            self._movie.close()
        except (OSError, av.FFmpegError):
            return


def finish_leftover(part: Path) -> Path | None:
    """Make a whole clip of what a crash left; None, and no file, when it shows nothing.

    Where an ordinary file cannot be written, say on a full disk, the fragmented one gets the name:
    it plays too; so does one that cannot be read, for a person may know better. May raise OSError;
    then the part is still there.
    """
    path = part.with_name(part.name.removesuffix(PART_SUFFIX) + CLIP_SUFFIX)
    match _leftover(part):
        case _Leftover.EMPTY:
            part.unlink(missing_ok=True)
            return None
        case _Leftover.UNREADABLE:
            return part.replace(path)
    remuxed = part.with_name(part.name.removesuffix(PART_SUFFIX) + _REMUXED_SUFFIX)
    try:
        create_private(remuxed)
        _remux(part, remuxed)
        _publish(remuxed, path)
    except (OSError, av.FFmpegError, IndexError, ValueError) as error:
        _LOG.warning("%s cannot be copied and stays in fragments: %s", part, error)
        remuxed.unlink(missing_ok=True)
        part.replace(path)
    part.unlink(missing_ok=True)
    return path


def duration_of(path: Path) -> float:
    """Return how long a clip is [s]; 0 when it cannot be read."""
    try:
        with av.open(str(path)) as clip:
            if clip.duration:
                return float(clip.duration / av.time_base)
            packets = tuple(_whole_packets(clip))  # fragments do not say it
            return float((packets[-1].pts or 0) * packets[-1].time_base) if packets else 0.0
    except (OSError, av.FFmpegError, IndexError, ValueError):
        return 0.0


def create_private(path: Path) -> None:
    """Make an empty file that only this user can read; an old one is removed."""
    path.unlink(missing_ok=True)
    os.close(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW, 0o600))


class _Leftover(Enum):
    PLAYS = "plays"
    EMPTY = "empty"
    UNREADABLE = "unreadable"


def _leftover(part: Path) -> _Leftover:
    """Return what a file is that a crash left; raises OSError when the disk cannot read it."""
    try:
        if not part.stat().st_size:
            return _Leftover.EMPTY
        with av.open(str(part)) as source:
            is_shown = next(_whole_packets(source), None) is not None
            return _Leftover.PLAYS if is_shown else _Leftover.EMPTY
    except (av.FFmpegError, IndexError, ValueError) as error:
        if isinstance(error, OSError):
            raise
        return _Leftover.EMPTY if _is_only_begun(part) else _Leftover.UNREADABLE


def _is_only_begun(part: Path) -> bool:
    """Return whether a file holds nothing but the boxes that come before the first picture."""
    left = part.read_bytes() if part.stat().st_size < _BEGUN_MAX else b"?"
    while len(left) >= _BOX.size:
        size, kind = _BOX.unpack_from(left)
        if kind not in _FIRST_BOXES or size < _BOX.size:
            return False
        left = left[size:]
    return not left.strip(b"\0")


def _remux(part: Path, path: Path) -> None:
    """Copy every whole picture into an ordinary MP4 file."""
    with av.open(str(part)) as source, av.open(str(path), "w", format="mp4") as target:
        stream = target.add_stream_from_template(source.streams.video[0])
        for packet in _whole_packets(source):
            packet.stream = stream
            target.mux(packet)


def _whole_packets(source: InputContainer) -> Iterator[Any]:
    """Yield the packets up to the first that cannot be decoded: the last fragment may be torn."""
    with suppress(av.FFmpegError):
        for packet in source.demux(source.streams.video[0]):
            packet.decode()
            if packet.dts is not None:
                yield packet


def _publish(part: Path, path: Path) -> None:
    sync_file(part)
    part.replace(path)
    sync_folder(path.parent)
