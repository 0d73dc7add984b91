"""Fuzz targets: what a Tello sends, and what the simulated one reads."""

from __future__ import annotations

from fuzz_target import FuzzTarget, pieces

from housefly.errors import WireError
from housefly.messages import DroneStatus
from housefly.wires.annex_b import can_begin
from housefly.wires.tello.answers import decode_tello_answer
from housefly.wires.tello.conversions import telemetry_of_state
from housefly.wires.tello.lines import decode_line
from housefly.wires.tello.pieces import PictureJoiner
from housefly.wires.tello.state import TelloState, decode_state, encode_state


def _state(data: bytes) -> None:
    telemetry_of_state(decode_state(data), DroneStatus.FLYING, 1.0)


def _pieces(data: bytes) -> None:
    joiner = PictureJoiner()
    for piece in pieces(data[1:], 1 + (data[0] if data else 0)):
        for picture in joiner.feed(piece):
            can_begin(picture)


TELLO: dict[str, FuzzTarget] = {
    "tello_line": FuzzTarget(
        decode_line,
        lambda: (b"rc -100 0 50 1", b"go 100 -20 0 50", b"cw 90", b"takeoff", b"battery?"),
        (WireError,),
        300,
        (b"rc ", b"go ", b"speed ", b"forward "),
    ),
    "tello_answer": FuzzTarget(
        decode_tello_answer, lambda: (b"ok", b"error Motor stop", b"87\r\n"), (WireError,), 300
    ),
    "tello_state": FuzzTarget(
        _state,
        lambda: (
            encode_state(TelloState(1, -2, 30, 86, 70, 63, 12)),
            b"mid:-1;x:-100;mpry:-1,-1,-1;pitch:0;roll:0;yaw:0;tof:10;h:0;bat:9;time:0;",
        ),
        (WireError,),
        600,
        (b"pitch:", b"tof:", b"bat:", b"time:", b";"),
    ),
    "tello_pieces": FuzzTarget(
        _pieces,
        lambda: (b"\x40\0\0\0\1\x67a\0\0\0\1\x68b\0\0\0\1\x65picture\0\0\0\1\x41more",),
        words=(b"\0\0\0\1", b"\0\0\1"),
    ),
}
