"""The objects of a frame that Housefly reads and writes; each knows its own layout.

Layout: whoenig/vicon-datastream-sdk, checked against the SDK's own client. All other kinds are
skipped by length.
"""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import ClassVar, Self

from housefly.geometry import Vec3
from housefly.wires.vicon.buffer import F64, I64, U8, U32, ViconReader, ViconWriter

ROOT_SEGMENT = 0xFFFFFFFF
"""Parent of a subject's root segment."""

RotationMatrix = tuple[float, float, float, float, float, float, float, float, float]

_SEGMENT_HEAD = struct.Struct("<II6f")
_SEGMENT_POSE = struct.Struct("<I12d")
_PAIR = struct.Struct("<II")


@dataclass(frozen=True, slots=True)
class FrameContents:
    """Contents of a frame.

    Attributes:
        numbers: kind and number of objects of each kind.
        unchanged: kinds left out because they did not change.
    """

    KIND: ClassVar[int] = 100004
    numbers: tuple[tuple[int, int], ...]
    unchanged: frozenset[int] = frozenset()

    def write(self, out: ViconWriter) -> None:
        """Append the body."""
        out.u32(len(self.numbers))
        for kind, number in self.numbers:
            out.put(_PAIR, kind, number)
        out.numbers(self.unchanged)

    @classmethod
    def read(cls, source: ViconReader) -> Self:
        """Read the body."""
        pairs = [source.unpack(_PAIR) for _ in range(source.count(_PAIR.size))]
        return cls(tuple((int(kind), int(number)) for kind, number in pairs), source.numbers())


@dataclass(frozen=True, slots=True)
class StreamInfo:
    """Time between two frame numbers, in ticks of 135 MHz."""

    KIND: ClassVar[int] = 1
    period_ticks: int

    def write(self, out: ViconWriter) -> None:
        """Append the body."""
        out.put(I64, self.period_ticks)

    @classmethod
    def read(cls, source: ViconReader) -> Self:
        """Read the body."""
        return cls(int(source.unpack(I64)[0]))


@dataclass(frozen=True, slots=True)
class ApplicationInfo:
    """Which axis points up: z (Vicon's default) or y."""

    KIND: ClassVar[int] = 37
    y_up: bool = False

    def write(self, out: ViconWriter) -> None:
        """Append the body."""
        out.put(U8, self.y_up)

    @classmethod
    def read(cls, source: ViconReader) -> Self:
        """Read the body."""
        return cls(source.unpack(U8)[0] != 0)


@dataclass(frozen=True, slots=True)
class Segment:
    """One rigid part of a subject; the part whose parent is ROOT carries the subject's pose."""

    identity: int
    name: str
    parent: int = ROOT_SEGMENT


@dataclass(frozen=True, slots=True)
class SubjectInfo:
    """A tracked subject; its markers and attachments are not read."""

    KIND: ClassVar[int] = 2
    identity: int
    name: str
    segments: tuple[Segment, ...]

    def write(self, out: ViconWriter) -> None:
        """Append the body, with empty bounds and without markers and attachments."""
        out.u32(self.identity)
        out.text(self.name)
        out.u32(len(self.segments))
        for segment in self.segments:
            out.put(_SEGMENT_HEAD, segment.parent, segment.identity, *[0.0] * 6)
            out.text(segment.name)
        out.u32(0)
        out.u32(0)

    @classmethod
    def read(cls, source: ViconReader) -> Self:
        """Read the body up to the segments."""
        identity, name = source.u32(), source.text()
        segments = []
        for _ in range(source.count(_SEGMENT_HEAD.size + U32.size)):
            parent, segment, *_bounds = source.unpack(_SEGMENT_HEAD)
            segments.append(Segment(int(segment), source.text(), int(parent)))
        return cls(identity, name, tuple(segments))


@dataclass(frozen=True, slots=True)
class FrameInfo:
    """The frame number; it counts periods, so lost frames leave gaps."""

    KIND: ClassVar[int] = 5
    number: int

    def write(self, out: ViconWriter) -> None:
        """Append the body."""
        out.u32(self.number)

    @classmethod
    def read(cls, source: ViconReader) -> Self:
        """Read the body."""
        return cls(source.u32())


@dataclass(frozen=True, slots=True)
class LatencyInfo:
    """Delays from exposure to sending, as the server knows them: name and duration [s]."""

    KIND: ClassVar[int] = 26
    samples: tuple[tuple[str, float], ...]

    def write(self, out: ViconWriter) -> None:
        """Append the body."""
        out.u32(len(self.samples))
        for name, duration in self.samples:
            out.text(name)
            out.put(F64, duration)

    @classmethod
    def read(cls, source: ViconReader) -> Self:
        """Read the body."""
        number = source.count(U32.size + F64.size)
        return cls(tuple((source.text(), float(source.unpack(F64)[0])) for _ in range(number)))


@dataclass(frozen=True, slots=True)
class SegmentPose:
    """Where a segment is: translation [mm] and rotation (row-major matrix, segment to world)."""

    identity: int
    translation_mm: Vec3
    rotation: RotationMatrix


@dataclass(frozen=True, slots=True)
class GlobalSegments:
    """The seen segments of one subject; a lost subject is left out of the packet."""

    KIND: ClassVar[int] = 9
    subject: int
    segments: tuple[SegmentPose, ...]

    def write(self, out: ViconWriter) -> None:
        """Append the body."""
        out.u32(self.subject)
        out.u32(len(self.segments))
        for segment in self.segments:
            out.put(_SEGMENT_POSE, segment.identity, *segment.translation_mm, *segment.rotation)

    @classmethod
    def read(cls, source: ViconReader) -> Self:
        """Read the body."""
        subject = source.u32()
        segments = []
        for _ in range(source.count(_SEGMENT_POSE.size)):
            identity, x, y, z, *rotation = source.unpack(_SEGMENT_POSE)
            a, b, c, d, e, f, g, h, i = rotation
            segments.append(SegmentPose(int(identity), (x, y, z), (a, b, c, d, e, f, g, h, i)))
        return cls(subject, tuple(segments))
