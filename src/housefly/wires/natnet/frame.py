"""One frame of mocap data: rigid bodies and time stamps; all other sections are skipped."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import ClassVar, Self

from housefly.errors import WireError
from housefly.geometry import Quaternion, Vec3
from housefly.wires.natnet.buffer import I32, SIZED_SECTIONS_SINCE, NatNetReader, NatNetWriter

_BODY = struct.Struct("<i3f4ffH")
_SUFFIX = struct.Struct("<IIdQQQ")
_PRECISE = struct.Struct("<II")
_END = struct.Struct("<Hi")
_PARAMS = struct.Struct("<H")
_TRACKED, _RECORDING, _CHANGED = 0x01, 0x01, 0x02
_POINT_BYTES = 12
_LABELED_BYTES = 26


@dataclass(frozen=True, slots=True)
class RigidBody:
    """Pose of a body in the server's axes.

    Attributes:
        identity: number of its description.
        position: of its pivot [m].
        orientation: (w, x, y, z), body to world.
        error: mean distance of its markers from where they should be [m].
        tracked: whether it was seen in this frame; if not, the pose is stale or meaningless.
    """

    identity: int
    position: Vec3
    orientation: Quaternion
    error: float = 0.0
    tracked: bool = True


@dataclass(frozen=True, slots=True)
class NatNetFrame:
    """One frame.

    Attributes:
        number: frame counter.
        bodies: all streamed rigid bodies, seen or not.
        timestamp: time since the server's software started [s].
        exposed: middle of the exposure [ticks], 0 if unknown.
        arrived: when the cameras' data reached the server [ticks].
        sent: when the frame left the server [ticks]; ``sent - arrived`` is the software's latency.
        recording: whether the server records.
        changed: whether bodies were added, removed or renamed.
    """

    KIND: ClassVar[int] = 7
    number: int
    bodies: tuple[RigidBody, ...]
    timestamp: float = 0.0
    exposed: int = 0
    arrived: int = 0
    sent: int = 0
    recording: bool = False
    changed: bool = False

    def write(self, out: NatNetWriter) -> None:
        """Append the body with all other sections empty."""
        out.put(I32, self.number)
        _empty(out, 2)
        bodies = NatNetWriter(out.version)
        for body in self.bodies:
            w, x, y, z = body.orientation
            bodies.put(
                _BODY,
                body.identity,
                *body.position,
                x,
                y,
                z,
                w,
                body.error,
                _TRACKED * body.tracked,
            )
        out.put(I32, len(self.bodies))
        out.section(bodies.data)
        _empty(out, 5 if out.version >= SIZED_SECTIONS_SINCE else 4)
        out.put(_SUFFIX, 0, 0, self.timestamp, self.exposed, self.arrived, self.sent)
        if out.version >= SIZED_SECTIONS_SINCE:
            out.put(_PRECISE, 0, 0)
        out.put(_END, _RECORDING * self.recording | _CHANGED * self.changed, 0)

    @classmethod
    def read(cls, source: NatNetReader) -> Self:
        """Read the body."""
        number = source.number(I32, "frame number")
        _marker_sets(source)
        _rows(source, _POINT_BYTES, "unlabeled markers")
        bodies = _bodies(source)
        _skeletons(source)
        if source.version >= SIZED_SECTIONS_SINCE:
            source.number(I32, "asset count")
            source.section("assets")
        _rows(source, _LABELED_BYTES, "labeled markers")
        for field in ("force plates", "devices"):
            _channels(source, field)
        _, _, timestamp, exposed, arrived, sent = source.unpack(_SUFFIX, "time stamps")
        if source.version >= SIZED_SECTIONS_SINCE:
            source.unpack(_PRECISE, "precision time stamp")
        params = source.number(_PARAMS, "frame parameters")
        return cls(
            number,
            bodies,
            timestamp,
            exposed,
            arrived,
            sent,
            bool(params & _RECORDING),
            bool(params & _CHANGED),
        )


def _empty(out: NatNetWriter, sections: int) -> None:
    for _ in range(sections):
        out.put(I32, 0)
        out.section(b"")


def _bodies(source: NatNetReader) -> tuple[RigidBody, ...]:
    number = source.number(I32, "rigid body count")
    part = source.section("rigid bodies")
    if (
        number < 0
        or number * _BODY.size > part.left
        or (part is not source and number * _BODY.size != part.left)
    ):
        raise WireError(f"NatNet rigid body count: {number} bodies do not make {part.left} bytes")
    return tuple(_body(part) for _ in range(number))


def _body(source: NatNetReader) -> RigidBody:
    identity, px, py, pz, x, y, z, w, error, params = source.unpack(_BODY, "rigid body")
    return RigidBody(identity, (px, py, pz), (w, x, y, z), error, bool(params & _TRACKED))


def _rows(source: NatNetReader, size: int, field: str) -> None:
    number = source.number(I32, f"{field} count")
    part = source.section(field)
    if part is source:
        source.skip(number * size, field)


def _marker_sets(source: NatNetReader) -> None:
    number = source.number(I32, "marker set count")
    part = source.section("marker sets")
    if part is source:
        for _ in _few(number, source, "marker set count"):
            source.text("marker set name")
            _rows(source, _POINT_BYTES, "marker set markers")


def _skeletons(source: NatNetReader) -> None:
    number = source.number(I32, "skeleton count")
    part = source.section("skeletons")
    if part is source:
        for _ in _few(number, source, "skeleton count"):
            source.number(I32, "skeleton")
            _rows(source, _BODY.size, "skeleton bones")


def _channels(source: NatNetReader, field: str) -> None:
    number = source.number(I32, f"{field} count")
    part = source.section(field)
    if part is source:
        for _ in _few(number, source, field):
            source.number(I32, field)
            for _ in range(source.count(I32.size, f"{field} channels")):
                _rows(source, I32.size, f"{field} samples")


def _few(number: int, source: NatNetReader, field: str) -> range:
    """Return a range over a list whose elements have at least four bytes each; refuses others."""
    if not 0 <= number * I32.size <= source.left:
        raise WireError(f"NatNet {field}: {number} do not fit into the {source.left} bytes left")
    return range(number)
