"""PaVE: the header before each H.264 picture on TCP port 5555, and the stream's reassembly.

Facts: Parrot ARDroneLib SDK 2.0.1 and recorded streams. Headers have 64 or, in some firmware, 68
bytes; the field ``header_size`` decides.
"""

from __future__ import annotations

import struct
from dataclasses import dataclass
from enum import IntEnum
from typing import Final

from housefly.errors import WireError
from housefly.wires.annex_b import can_begin

VIDEO_PORT = 5555
_MAGIC = b"PaVE"
_HEADER_SIZES = (64, 68)
MAX_PAYLOAD = 1_000_000
"""Largest picture accepted [bytes]; a real 640x360 key frame has 10-20 kB, 720p below 100 kB."""
BAD_HEADERS_MAX = 64
"""After so many refused headers in one call, the rest of what was received is thrown away."""
CODEC_H264: Final = 4

_HEADER = struct.Struct("<4sBBHI4HII4BIIH4B2sI12s")
_MIN_HEADER = _HEADER.size
_MAX_HEADER = 256


class FrameType(IntEnum):
    """What a picture can be decoded from."""

    UNKNOWN = 0
    IDR = 1
    I_FRAME = 2
    P_FRAME = 3
    HEADERS = 4


@dataclass(frozen=True, slots=True)
class PaveHeader:
    """The fields of a PaVE header; sizes [bytes], pictures [px], timestamp of the drone's clock."""

    payload_size: int
    frame_number: int
    timestamp_ms: int = 0
    frame_type: int = FrameType.P_FRAME
    display_width: int = 640
    display_height: int = 360
    encoded_width: int = 640
    encoded_height: int = 368
    header_size: int = 64
    version: int = 2
    codec: int = CODEC_H264
    total_chunks: int = 1
    chunk_index: int = 0
    control: int = 0
    byte_position: int = 0
    stream_id: int = 1
    total_slices: int = 1
    slice_index: int = 0
    sps_size: int = 0
    pps_size: int = 0
    advertised_size: int = 0


@dataclass(frozen=True, slots=True)
class PaveFrame:
    """One picture: its header and its H.264 Annex B bytes."""

    header: PaveHeader
    payload: bytes

    @property
    def keyframe(self) -> bool:
        """Whether the payload has SPS, PPS and an IDR slice, so that decoding may start here."""
        return can_begin(self.payload)


def encode_header(header: PaveHeader) -> bytes:
    """Return the header's bytes, padded to ``header_size``; raises WireError."""
    h = header
    if h.header_size not in _HEADER_SIZES:
        raise WireError(f"PaVE header of {h.header_size} bytes; {_HEADER_SIZES} are possible")
    try:
        packed = _HEADER.pack(
            *(_MAGIC, h.version, h.codec, h.header_size, h.payload_size),
            *(h.encoded_width, h.encoded_height, h.display_width, h.display_height),
            *(h.frame_number, h.timestamp_ms),
            *(h.total_chunks, h.chunk_index, h.frame_type, h.control),
            *(h.byte_position & 0xFFFFFFFF, h.byte_position >> 32, h.stream_id),
            *(h.total_slices, h.slice_index, h.sps_size, h.pps_size, b"", h.advertised_size, b""),
        )
    except struct.error as error:
        raise WireError(f"PaVE header value does not fit: {error}") from error
    return packed.ljust(h.header_size, b"\x00")


def encode_frame(header: PaveHeader, payload: bytes) -> bytes:
    """Return header and payload; raises WireError when the header names another payload size."""
    if header.payload_size != len(payload):
        raise WireError(
            f"PaVE header says {header.payload_size} bytes, the picture has {len(payload)}"
        )
    return encode_header(header) + payload


def decode_header(data: bytes | bytearray | memoryview) -> PaveHeader:
    """Read a header.

    Raises:
        WireError: fewer than 64 bytes, no "PaVE", an impossible header or payload size.
    """
    if len(data) < _MIN_HEADER:
        raise WireError(f"PaVE header of {len(data)} bytes; at least {_MIN_HEADER} are needed")
    values = _HEADER.unpack_from(data)
    magic, version, codec, header_size, payload_size, enc_w, enc_h, width, height, number, stamp = (
        values[:11]
    )
    chunks, chunk, kind, control, low, high, stream, slices, cut, sps, pps, _, advertised, _ = (
        values[11:]
    )
    if magic != _MAGIC:
        raise WireError("picture does not start with PaVE")
    if not _MIN_HEADER <= header_size <= _MAX_HEADER:
        raise WireError(f"PaVE header names its size as {header_size} bytes")
    if payload_size > MAX_PAYLOAD:
        raise WireError(f"PaVE payload of {payload_size} bytes; at most {MAX_PAYLOAD} are taken")
    return PaveHeader(
        payload_size=payload_size,
        frame_number=number,
        timestamp_ms=stamp,
        frame_type=kind,
        display_width=width,
        display_height=height,
        encoded_width=enc_w,
        encoded_height=enc_h,
        header_size=header_size,
        version=version,
        codec=codec,
        total_chunks=chunks,
        chunk_index=chunk,
        control=control,
        byte_position=high << 32 | low,
        stream_id=stream,
        total_slices=slices,
        slice_index=cut,
        sps_size=sps,
        pps_size=pps,
        advertised_size=advertised,
    )


class VideoReassembler:
    """Cuts a TCP byte stream into pictures; resynchronizes at the next "PaVE", never raises.

    Attributes:
        skipped_bytes: bytes thrown away because no picture started there.
        bad_headers: headers that were refused.
    """

    def __init__(self) -> None:
        self.skipped_bytes = 0
        self.bad_headers = 0
        self._buffer = bytearray()
        self._refused = 0

    def feed(self, data: bytes) -> tuple[PaveFrame, ...]:
        """Append the next bytes of the stream and return the pictures now complete.

        Garbage costs little: after ``BAD_HEADERS_MAX`` refused headers the rest is thrown away.
        """
        self._buffer += data
        self._refused = 0
        frames: list[PaveFrame] = []
        while (frame := self._next()) is not None:
            frames.append(frame)
        return tuple(frames)

    def _next(self) -> PaveFrame | None:
        while self._seek_magic():
            if len(self._buffer) < _MIN_HEADER:
                return None
            try:
                header = decode_header(self._buffer)
            except WireError:
                self.bad_headers += 1
                self._refused += 1
                flooded = self._refused >= BAD_HEADERS_MAX
                self._skip(len(self._buffer) if flooded else len(_MAGIC))
                continue
            end = header.header_size + header.payload_size
            if len(self._buffer) < end:
                return None
            payload = bytes(memoryview(self._buffer)[header.header_size : end])
            del self._buffer[:end]
            return PaveFrame(header, payload)
        return None

    def _seek_magic(self) -> bool:
        at = self._buffer.find(_MAGIC)
        if at < 0:
            # the last three bytes may be the beginning of the next "PaVE"
            self._skip(max(0, len(self._buffer) - len(_MAGIC) + 1))
            return False
        self._skip(at)
        return True

    def _skip(self, count: int) -> None:
        self.skipped_bytes += count
        del self._buffer[:count]


class KeyframeGate:
    """Lets pictures pass from a key frame on; after a gap in their numbers, from the next one."""

    def __init__(self) -> None:
        self._next_number: int | None = None

    def passes(self, frame: PaveFrame) -> bool:
        """Return whether this picture can be decoded after those that passed before."""
        number = frame.header.frame_number
        if frame.keyframe or number == self._next_number:
            self._next_number = (number + 1) & 0xFFFFFFFF
            return True
        self._next_number = None
        return False

    def reset(self) -> None:
        """Forget everything: the next picture must be a key frame."""
        self._next_number = None
