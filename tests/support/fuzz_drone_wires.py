"""Fuzz targets: what the drone sends, what the twin and the driver's process read."""

from __future__ import annotations

import struct
from collections.abc import Iterable

import numpy as np
from fuzz_target import FuzzTarget, pieces

from housefly.bus.stop import STOP_MAGIC, StopToken, verified
from housefly.config.airframe import airframe_named
from housefly.drones.ardrone.telemetry import NavdataReports
from housefly.drones.driver_messages import (
    DriverStatus,
    MessageReader,
    PoseNews,
    TimedCommand,
    encode_driver_message,
)
from housefly.errors import WireError
from housefly.messages import (
    Action,
    Command,
    DroneFault,
    DroneStatus,
    Pose,
    PositionSetpoint,
    Setpoint,
    Sighting,
    Telemetry,
    VelocitySetpoint,
    VideoFrame,
)
from housefly.messages.steering import flying
from housefly.wires.ardrone.at import (
    Animation,
    Config,
    ConfigIds,
    Led,
    Pcmd,
    PcmdFlag,
    PcmdMag,
    Ref,
    RefBits,
    encode_datagram,
    parse_datagram,
)
from housefly.wires.ardrone.config import default_values, encode_dump, parse_dump
from housefly.wires.ardrone.navdata import decode_navdata, encode_navdata
from housefly.wires.ardrone.navdata_options import OPTION_TYPES, Demo, PhysMeasures
from housefly.wires.ardrone.pave import KeyframeGate, PaveHeader, VideoReassembler, encode_frame

_SECRET = b"a secret of sixteen"
_CHECKSUM = struct.Struct("<2HI")


def _summed(data: bytes) -> bytes:
    """Return navdata with the right magic and checksum: a mutator would never find them."""
    body = b"\x88\x77\x66\x55" + data[4:]
    return body + _CHECKSUM.pack(0xFFFF, 8, int(np.frombuffer(body, np.uint8).sum()))


def _navdata(data: bytes) -> None:
    for datagram in (data, _summed(data)):
        reports = NavdataReports()
        reports.accept(datagram, 1.0)
        _ = reports.telemetry
        try:
            decode_navdata(datagram).decoded()
        except WireError:
            continue


def _navdata_seeds() -> Iterable[bytes]:
    full = [kind() for kind in OPTION_TYPES]
    for options in ((), (Demo(),), (Demo(), PhysMeasures()), full):
        yield encode_navdata(0x0F000001, 7, options)[:-8]


def _at(data: bytes) -> None:
    parsed = parse_datagram(data)
    assert all(len(text) < 1000 for text in parsed.rejects)


def _at_seeds() -> Iterable[bytes]:
    moves = (PcmdFlag.PROGRESSIVE, 0.1, -0.2, 0.3, -1.0)
    yield encode_datagram(1, [Ref(RefBits.TAKE_OFF), Pcmd(*moves), PcmdMag(*moves, 0.1, 0.2)])
    yield encode_datagram(5, [ConfigIds("0" * 8, "1" * 8, "2" * 8), Config("a:b", "1")])
    yield encode_datagram(9, [Led(1, 2.0, 3), Animation(4, 1000)])
    yield b"AT*FTRIM=1,\rAT*COMWDG=2\r\nAT*CTRL=3,5,0\rAT*GAIN=4,1,2\r"


def _pave(data: bytes) -> None:
    stream, gate = VideoReassembler(), KeyframeGate()
    for piece in pieces(data[1:], 1 + (data[0] if data else 0)):
        for frame in stream.feed(piece):
            gate.passes(frame)


def _pave_seeds() -> Iterable[bytes]:
    key = b"\x00\x00\x01\x67a\x00\x00\x01\x68b\x00\x00\x01\x65picture"
    for size in (64, 68):
        header = PaveHeader(len(key), 1, header_size=size)
        yield b"\xff" + encode_frame(header, key) + encode_frame(PaveHeader(4, 2), b"\0\0\1\x41")
    yield b"\x40" + b"PaVE" * 20


def _driver(data: bytes) -> None:
    reader = MessageReader()
    for piece in pieces(data[1:], 1 + (data[0] if data else 0)):
        reader.feed(piece)


def _driver_seeds() -> Iterable[bytes]:
    report = Telemetry(
        1.0, DroneStatus.FLYING, 0.5, faults=(DroneFault.BATTERY_LOW,), acceleration=(0.0, 0.0, 9.8)
    )
    for message in (
        TimedCommand(Command(Action.FLY, Setpoint(0.1, 0.2, 0.3, 0.4)), 5.0),
        TimedCommand(flying(VelocitySetpoint(0.5, 0.0, 0.1, 0.2)), 5.0),
        TimedCommand(flying(PositionSetpoint(1.0, 2.0, 1.1)), 5.0),
        PoseNews(Sighting("drone", Pose((1.0, 2.0, 1.1)), 4.0, 4.02)),
        report,
        DriverStatus(True, False, 200.0, "silent", airframe_named("ardrone").capabilities),
        VideoFrame(b"\0\0\1\x65", True, 640, 360, 3, 1.0, 2.0),
    ):
        yield b"\xff" + encode_driver_message(message)


def _stop(data: bytes) -> None:
    verified(data, STOP_MAGIC, _SECRET)


DRONE_WIRES: dict[str, FuzzTarget] = {
    "navdata": FuzzTarget(_navdata, _navdata_seeds),
    "at_commands": FuzzTarget(
        _at, _at_seeds, words=(b"AT*", b"PCMD_MAG", b"CONFIG_IDS", b"CTRL", b"LED", b"\r", b'"')
    ),
    "drone_config": FuzzTarget(
        parse_dump,
        lambda: (encode_dump(default_values())[:1500] + b"\0", b"a:b = { 1 2 3 }\n\0"),
        (WireError,),
    ),
    "video": FuzzTarget(_pave, _pave_seeds, words=(b"PaVE", b"\0\0\1")),
    "driver": FuzzTarget(_driver, _driver_seeds, (WireError,), words=(b"HFd1",)),
    "stop": FuzzTarget(
        _stop, lambda: (StopToken(9, b"12345678").signed(STOP_MAGIC, _SECRET),), (WireError,), 64
    ),
}
