"""The simulated drone's live video: H.264 pictures in PaVE frames to every client on TCP 5555.

What a client gets begins with a key frame. One that reads too slowly loses pictures up to the next
key frame and delays nobody else.
"""

from __future__ import annotations

import asyncio
import socket

from housefly.twin.contracts import EncodedPicture
from housefly.twin.link_counters import Counters
from housefly.wires.ardrone.pave import VIDEO_PORT, FrameType, PaveHeader, encode_frame

_MAX_CLIENTS = 8
_MAX_BACKLOG = 96 * 1024
"""Bytes that may wait for one client: five key frames, or about half a second of stream."""
_SEND_BUFFER = 128 * 1024
"""Bytes the kernel may hold for one client; its default would hide a slow reader."""
PAVE_HEADER_SIZE = 64
_STREAM_ID = 5
_CLOCK_AHEAD = 100.0
"""The drone's clock runs since it was switched on, so long before the room [s].

Stream 1, and a clock below 65 s before the number of chunks, look like H.264's start code to who
reads the stream without its headers.
"""
_MACROBLOCK = 16
"""H.264 codes whole blocks of 16 pixels and shows a part of them: 368 lines coded, 360 shown."""
_START_CODE = b"\x00\x00\x00\x01"
_NAL_SPS, _NAL_PPS = 7, 8
_PARAMETER_SETS_END = 512
"""How far into a key picture to search for parameter sets [bytes]; a real drone's end after 24."""


class _Viewer(asyncio.Protocol):
    """One client of the stream."""

    def __init__(self, port: VideoServer) -> None:
        self._port = port
        self._transport: asyncio.Transport | None = None
        self._waits_for_key = True

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        assert isinstance(transport, asyncio.Transport)
        if not self._port.admit(self):
            transport.abort()
            return
        transport.get_extra_info("socket").setsockopt(
            socket.SOL_SOCKET, socket.SO_SNDBUF, _SEND_BUFFER
        )
        self._transport = transport

    def connection_lost(self, exc: Exception | None) -> None:
        self._transport = None
        self._port.dismiss(self)

    def close(self) -> None:
        if self._transport is not None:
            self._transport.abort()

    def offer(self, frame: bytes, keyframe: bool) -> bool:
        """Queue a frame and return True, or drop it because the client is behind."""
        if self._transport is None:
            return False
        self._waits_for_key = self._transport.get_write_buffer_size() > _MAX_BACKLOG or (
            self._waits_for_key and not keyframe
        )
        if not self._waits_for_key:
            self._transport.write(frame)
        return not self._waits_for_key


class VideoServer:
    """TCP 5555 of the simulated drone.

    Args:
        counters: where frames sent and dropped are counted.
        header_size: bytes of a PaVE header; 64, or 68 as some firmware sends.
    """

    def __init__(self, counters: Counters, header_size: int = PAVE_HEADER_SIZE) -> None:
        self._counters = counters
        self._header_size = header_size
        self._viewers: set[_Viewer] = set()
        self._server: asyncio.Server | None = None
        self._bytes_sent = 0

    @property
    def viewers(self) -> int:
        """How many clients are connected."""
        return len(self._viewers)

    async def start(self, address: str) -> None:
        """Listen; raises OSError when the address is taken."""
        loop = asyncio.get_running_loop()
        self._server = await loop.create_server(lambda: _Viewer(self), address, VIDEO_PORT)

    async def stop(self) -> None:
        """Close the port and every connection."""
        if self._server is not None:
            self._server.close()
        for viewer in tuple(self._viewers):
            viewer.close()

    def admit(self, viewer: _Viewer) -> bool:
        """Accept a new client, unless there are too many."""
        if len(self._viewers) >= _MAX_CLIENTS:
            return False
        self._viewers.add(viewer)
        return True

    def dismiss(self, viewer: _Viewer) -> None:
        """Forget a client."""
        self._viewers.discard(viewer)

    def publish(self, picture: EncodedPicture) -> None:
        """Send a picture to every client that keeps up; returns at once."""
        if not self._viewers:
            return
        frame = encode_frame(self._header(picture), picture.data)
        self._bytes_sent += len(frame)
        for viewer in tuple(self._viewers):
            if viewer.offer(frame, picture.keyframe):
                self._counters.frames_sent += 1
            else:
                self._counters.frames_dropped += 1

    def _header(self, picture: EncodedPicture) -> PaveHeader:
        sps, pps = _parameter_set_sizes(picture.data) if picture.keyframe else (0, 0)
        return PaveHeader(
            payload_size=len(picture.data),
            frame_number=picture.number & 0xFFFFFFFF,
            timestamp_ms=round(1e3 * (picture.at + _CLOCK_AHEAD)) & 0xFFFFFFFF,
            frame_type=FrameType.IDR if picture.keyframe else FrameType.P_FRAME,
            display_width=picture.width,
            display_height=picture.height,
            encoded_width=_whole_blocks(picture.width),
            encoded_height=_whole_blocks(picture.height),
            header_size=self._header_size,
            byte_position=self._bytes_sent,
            stream_id=_STREAM_ID,
            sps_size=sps,
            pps_size=pps,
        )


def _whole_blocks(pixels: int) -> int:
    return -(-pixels // _MACROBLOCK) * _MACROBLOCK


def _parameter_set_sizes(key_picture: bytes) -> tuple[int, int]:
    """Return the bytes of SPS and PPS with start codes; 0 if not near the beginning."""
    units = key_picture[:_PARAMETER_SETS_END].split(_START_CODE)[1:-1]
    sizes = {unit[0] & 0x1F: len(_START_CODE) + len(unit) for unit in units if unit}
    return sizes.get(_NAL_SPS, 0), sizes.get(_NAL_PPS, 0)
