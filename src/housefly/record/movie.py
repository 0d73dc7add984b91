"""The drone's video as a playable file, without decoding or encoding."""

from __future__ import annotations

import io
from fractions import Fraction
from pathlib import Path
from typing import Any

import av
from av.container import OutputContainer

from housefly.config.durable import SyncPace, sync_file
from housefly.messages import VideoFrame

_TIME_BASE = Fraction(1, 90_000)
_OPTIONS = {"movflags": "hybrid_fragmented+frag_keyframe", "flush_packets": "1"}
"""Fragments survive the death of the writer; an orderly end turns them into an ordinary file."""


class Movie:
    """An MP4 file that grows with each H.264 access unit, from the first decodable key frame on.

    Frames of another size than the first are dropped: one MP4 track has one size.

    Args:
        path: file to write; it appears with the first frame.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._container: OutputContainer | None = None
        self._stream: Any = None
        self._size = (0, 0)
        self._started_at = 0.0
        self._last_pts = -1
        self._pace = SyncPace()

    def add(self, frame: VideoFrame) -> None:
        """Append one frame, shown from its ``received_at`` on.

        May raise OSError and av.FFmpegError.
        """
        if self._container is None and not (frame.keyframe and self._open(frame)):
            return
        if (frame.width, frame.height) != self._size or self._container is None:
            return
        pts = max(self._last_pts + 1, round((frame.received_at - self._started_at) / _TIME_BASE))
        self._last_pts = pts
        packet = av.Packet(frame.data)
        packet.stream, packet.time_base = self._stream, _TIME_BASE
        packet.pts = packet.dts = pts
        packet.is_keyframe = frame.keyframe
        self._container.mux(packet)
        if self._pace.is_due():
            sync_file(self._path)

    def close(self) -> None:
        """Close the file; closing twice does no harm."""
        container, self._container = self._container, None
        if container is not None:
            container.close()

    def _open(self, first: VideoFrame) -> bool:
        """Open the file; False when the frame lacks the stream's parameters."""
        try:
            with av.open(io.BytesIO(first.data), format="h264") as probe:
                template = probe.streams.video[0]
                if not template.codec_context.extradata or not template.codec_context.width:
                    return False
                container = av.open(str(self._path), "w", format="mp4", options=_OPTIONS)
                self._stream = container.add_stream_from_template(template)
        except (av.InvalidDataError, IndexError):
            return False
        self._container = container
        self._size = (first.width, first.height)
        self._started_at = first.received_at
        return True
