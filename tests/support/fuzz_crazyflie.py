"""Fuzz targets: what a Crazyflie sends, and what the simulated one reads."""

from __future__ import annotations

from collections.abc import Callable

from fuzz_target import FuzzTarget

from housefly.drones.crazyflie.reports import OwnState
from housefly.errors import WireError
from housefly.messages import DroneStatus
from housefly.wires.crazyflie import high_level, localization, log_blocks, parameters, tables
from housefly.wires.crazyflie import setpoints as sp
from housefly.wires.crazyflie import supervisor as words
from housefly.wires.crazyflie.crtp import Packet, Port, decode_crtp, encode_crtp

_FLOAT = tables.ValueType.FLOAT
_DRONE_READS: dict[int, tuple[Callable[[Packet], object], ...]] = {
    Port.GENERIC_SETPOINT: (sp.decode_setpoint, sp.is_notify_stop),
    Port.HIGH_LEVEL: (high_level.decode_high_level,),
    Port.LOCALIZATION: (localization.decode_poses, localization.emergency_of),
    Port.SUPERVISOR: (words.decode_order,),
    Port.LOG: (tables.read_question, log_blocks.decode_block_request),
    Port.PARAMETERS: (
        tables.read_question,
        parameters.number_of,
        lambda packet: parameters.written_value(packet, _FLOAT),
    ),
}
_WE_READ: dict[int, tuple[Callable[[Packet], object], ...]] = {
    Port.LOG: (tables.read_info, tables.read_item, log_blocks.read_block_answer),
    Port.PARAMETERS: (
        tables.read_info,
        tables.read_item,
        lambda packet: parameters.read_value(packet, _FLOAT),
    ),
    Port.HIGH_LEVEL: (high_level.is_land_answer,),
    Port.SUPERVISOR: (words.decode_info,),
    Port.PLATFORM: (words.read_version,),
    Port.LINK: (words.is_source,),
}


def _reader(
    table: dict[int, tuple[Callable[[Packet], object], ...]],
) -> Callable[[bytes], None]:
    def read(data: bytes) -> None:
        packet = decode_crtp(data)
        for one in table.get(packet.port, ()):
            try:
                one(packet)
            except WireError:
                continue

    return read


def _report(data: bytes) -> None:
    state = OwnState().taken_in(decode_crtp(data), 1.0)
    state.report(DroneStatus.FLYING, configured=True, notes=())


def _orders() -> tuple[bytes, ...]:
    packets = (
        sp.encode_setpoint(sp.AltHold(0.1, -0.1, 0.2, 0.3)),
        sp.encode_setpoint(sp.FullState((1.0, 2.0, 3.0), (0.1, 0.0, 0.0), (0.0, 0.0, 0.0), 0.5)),
        sp.notify_setpoints_stop(),
        high_level.encode_high_level(high_level.GoTo((1.0, 2.0, 1.0), 0.5, 2.0)),
        localization.encode_told_pose((1.0, 2.0, 1.0), (1.0, 0.0, 0.0, 0.0)),
        localization.encode_packed_poses([(231, (1.0, 2.0, 1.0), (0.7, 0.1, 0.1, 0.7))] * 2),
        words.encode_order(words.SupervisorOrder.ARM),
        tables.item_question(Port.LOG, 300),
        log_blocks.encode_block_request(
            log_blocks.BlockRequest(log_blocks.BlockOrder.CREATE, 1, ((_FLOAT, 3),))
        ),
        parameters.encode_write(3, _FLOAT, 0.01),
    )
    return tuple(map(encode_crtp, packets))


def _answers() -> tuple[bytes, ...]:
    entries = (tables.TableEntry("stateEstimate.x", _FLOAT),)
    order = high_level.encode_high_level(high_level.Land(0.0, 2.0))
    arm = words.OrderAnswer(words.SupervisorOrder.ARM, is_done=True, state=True)
    packets = (
        tables.info_answer(Port.LOG, entries, (16, 128)),
        tables.item_answer(Port.PARAMETERS, 0, entries),
        log_blocks.encode_answer(log_blocks.BlockOrder.START, 1, log_blocks.BlockError.NONE),
        parameters.parameter_answer(3, _FLOAT, 0.01),
        high_level.high_level_answer(order, 0),
        words.encode_info(words.INFO_BITFIELD, words.info_of(31)),
        words.encode_order_answer(arm),
        words.version_answer(words.VersionQuestion.FIRMWARE, "2026.08"),
        words.source_answer(),
    )
    return tuple(map(encode_crtp, packets))


def _logs() -> tuple[bytes, ...]:
    motion = [(_FLOAT, 1.5)] * 4 + [(tables.ValueType.UINT16, 31.0)]
    state = [(_FLOAT, 1.5)] * 4 + [(tables.ValueType.UINT8, 90.0)]
    return (
        encode_crtp(log_blocks.encode_values(0, 1234, motion)),
        encode_crtp(log_blocks.encode_values(1, 1240, state)),
    )


CRAZYFLIE: dict[str, FuzzTarget] = {
    "crazyflie_order": FuzzTarget(_reader(_DRONE_READS), _orders, (WireError,), 40),
    "crazyflie_answer": FuzzTarget(_reader(_WE_READ), _answers, (WireError,), 40),
    "crazyflie_log": FuzzTarget(_report, _logs, (WireError,), 40),
}
