"""Descriptions of what is tracked; only names and numbers of rigid bodies are read."""

from __future__ import annotations

import struct
from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar, Self

from housefly.errors import WireError
from housefly.geometry import Vec3
from housefly.wires.natnet.buffer import (
    I32,
    SIZED_SECTIONS_SINCE,
    NatNetReader,
    NatNetVersion,
    NatNetWriter,
)

_NO_PARENT = -1
"""Parent of a body that hangs on no other."""
_MARKER_NAMES_SINCE: NatNetVersion = (4, 0)
_ROTATION_SINCE: NatNetVersion = (4, 2)
_RIGID_BODY = 1
_BODY = struct.Struct("<ii3f")
_MARKER_BYTES = 16
_TURN_BYTES = 16
_CAMERA_BYTES = 28
_PLATE_BYTES = 4 * (2 + 3 + 144 + 12)


@dataclass(frozen=True, slots=True)
class RigidBodyDescription:
    """A tracked body: number, name, and its place relative to its parent [m]."""

    identity: int
    name: str
    parent: int = _NO_PARENT
    offset: Vec3 = (0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class ModelDef:
    """The rigid bodies of a server."""

    KIND: ClassVar[int] = 5
    bodies: tuple[RigidBodyDescription, ...]

    def write(self, out: NatNetWriter) -> None:
        """Append the body; the bodies' markers are not told."""
        out.put(I32, len(self.bodies))
        for body in self.bodies:
            out.put(I32, _RIGID_BODY)
            part = NatNetWriter(out.version)
            part.text(body.name)
            part.put(_BODY, body.identity, body.parent, *body.offset)
            if out.version >= _ROTATION_SINCE:
                part.put(struct.Struct("<4f"), 0.0, 0.0, 0.0, 1.0)
            part.put(I32, 0)
            out.section(part.data)

    @classmethod
    def read(cls, source: NatNetReader) -> Self:
        """Read the body."""
        bodies = []
        for _ in range(source.count(I32.size + 1, "data set count")):
            kind = source.number(I32, "data set kind")
            part = source.section("data set")
            if kind == _RIGID_BODY:
                bodies.append(_rigid_body(part))
            elif source.version < SIZED_SECTIONS_SINCE:
                _step_over(kind, part)
        return cls(tuple(bodies))


def _rigid_body(source: NatNetReader) -> RigidBodyDescription:
    name = source.text("rigid body name")
    identity, parent, x, y, z = source.unpack(_BODY, "rigid body description")
    if source.version >= _ROTATION_SINCE:
        source.skip(_TURN_BYTES, "rigid body rotation")
    markers = source.count(_MARKER_BYTES, "rigid body markers")
    source.skip(markers * _MARKER_BYTES, "rigid body markers")
    if source.version >= _MARKER_NAMES_SINCE:
        _names(source, markers)
    return RigidBodyDescription(identity, name, parent, (x, y, z))


def _step_over(kind: int, source: NatNetReader) -> None:
    step = _OTHERS.get(kind)
    if step is None:
        raise WireError(f"NatNet data set kind: {kind} is unknown; allowed: 0 to 5")
    step(source)


def _names(source: NatNetReader, number: int) -> None:
    for _ in range(number):
        source.text("marker or channel name")


def _marker_set(source: NatNetReader) -> None:
    source.text("marker set name")
    _names(source, source.count(1, "marker set markers"))


def _skeleton(source: NatNetReader) -> None:
    source.text("skeleton name")
    source.number(I32, "skeleton")
    for _ in range(source.count(_BODY.size + 1, "skeleton bones")):
        _rigid_body(source)


def _force_plate(source: NatNetReader) -> None:
    source.number(I32, "force plate")
    source.text("force plate serial number")
    source.skip(_PLATE_BYTES, "force plate calibration")
    source.unpack(struct.Struct("<ii"), "force plate kind")
    _names(source, source.count(1, "force plate channels"))


def _device(source: NatNetReader) -> None:
    source.number(I32, "device")
    source.text("device name")
    source.text("device serial number")
    source.unpack(struct.Struct("<ii"), "device kind")
    _names(source, source.count(1, "device channels"))


def _camera(source: NatNetReader) -> None:
    source.text("camera name")
    source.skip(_CAMERA_BYTES, "camera pose")


_OTHERS: dict[int, Callable[[NatNetReader], None]] = {
    0: _marker_set,
    2: _skeleton,
    3: _force_plate,
    4: _device,
    5: _camera,
}
"""Data sets that versions before 4.1 give no length."""
