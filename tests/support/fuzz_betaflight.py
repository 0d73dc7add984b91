"""Fuzz targets: what a Betaflight sends and what the simulated one reads, and its address."""

from __future__ import annotations

from contextlib import suppress

from fuzz_target import FuzzTarget, pieces

from housefly.drones.betaflight.controller import QUESTIONS, Controller
from housefly.errors import ConfigError, WireError
from housefly.messages import DroneStatus
from housefly.wires.betaflight import reports, settings
from housefly.wires.betaflight.commands import VARIANT, Msp
from housefly.wires.betaflight.endpoint import msp_endpoint_of
from housefly.wires.betaflight.framing import (
    MspDirection,
    MspFrame,
    MspReader,
    MspVersion,
    encode_msp,
)
from housefly.wires.betaflight.sticks import RadioSticks, flight_channels
from housefly.wires.betaflight.switches import switches_of

_ANSWERS = {
    Msp.FC_VARIANT: VARIANT,
    Msp.FC_VERSION: bytes((25, 12, 0)),
    Msp.BOXIDS: bytes((0, 1, 50)),
    Msp.MODE_RANGES: bytes((0, 0, 32, 48, 1, 1, 32, 48)),
    Msp.FEATURE_CONFIG: bytes((0, 64, 0, 0)),
    Msp.RX_CONFIG: settings.encode_receiver(1500, 1050),
    Msp.RX_MAP: bytes((0, 1, 3, 2, 4, 5, 6, 7)),
    Msp.RC_TUNING: settings.encode_tuning(settings.RcTuning()),
    Msp.RC_DEADBAND: bytes((3, 5, 0, 50, 0)),
    Msp.PID_ADVANCED: settings.encode_angle_limit(60),
    Msp.ADVANCED_CONFIG: settings.encode_motor_idle(0.055),
    Msp.FAILSAFE_CONFIG: settings.encode_failsafe(settings.FailsafeSettings()),
    Msp.RXFAIL_CONFIG: settings.encode_silent_channels(settings.FcSettings().silent),
    Msp.STATUS_EX: reports.encode_status(reports.FcStatus(3)),
    Msp.BATTERY_STATE: reports.encode_battery(reports.FcBattery(4, 15.2)),
    Msp.ATTITUDE: reports.encode_attitude(reports.FcAttitude(0.1, -0.1, 1.0)),
    Msp.RC: reports.encode_channels((1500, 1500, 1500, 1000, 1800)),
}


def _answer(command: Msp, payload: bytes) -> bytes:
    return encode_msp(MspFrame(command, payload, MspDirection.ANSWER))


def _stream(data: bytes) -> None:
    """Let a controller take in whatever comes, then fly by what it is said to be set to."""
    reader, controller = MspReader(), Controller()
    for number, piece in enumerate(pieces(data[1:], 1 + (data[0] if data else 0))):
        for frame in reader.feed(piece):
            with suppress(WireError):
                controller.hear(frame, 0.01 * number)
    controller.report(DroneStatus.FLYING, configured=True, notes=())
    switches_of(controller.settings.ranges)
    channels = flight_channels(RadioSticks(0.1, -0.1, 0.5, 0.4), controller.settings)
    assert all(0 <= one <= 2500 for one in channels)
    assert controller.is_known or not controller.told.issuperset(QUESTIONS)


def _address(data: bytes) -> None:
    msp_endpoint_of(data.decode(errors="replace"))


BETAFLIGHT: dict[str, FuzzTarget] = {
    "betaflight_stream": FuzzTarget(
        _stream,
        lambda: (
            b"\x20" + b"".join(_answer(command, payload) for command, payload in _ANSWERS.items()),
            b"\x03"
            + encode_msp(
                MspFrame(Msp.ATTITUDE, _ANSWERS[Msp.ATTITUDE], MspDirection.ANSWER, MspVersion.V2)
            ),
        ),
        (),
        2000,
        (b"$M>", b"$X>", b"$M!"),
    ),
    "betaflight_address": FuzzTarget(
        _address,
        lambda: (b"192.168.4.1", b"tcp:10.0.0.2:5761", b"serial:/dev/ttyACM0:115200", b"udp:[::1]"),
        (ConfigError,),
        100,
        (b"serial:", b"udp:", b"tcp:"),
    ),
}
