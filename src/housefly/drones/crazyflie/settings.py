"""What a Crazyflie is set to before it may fly, written and read back."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import degrees, isclose

from housefly.drones.crazyflie.link import CrtpLink
from housefly.drones.crazyflie.manoeuvres import HEIGHT_GAIN
from housefly.drones.crazyflie.reports import BLOCKS
from housefly.drones.crazyflie.tables import Table
from housefly.errors import LinkError
from housefly.wires.crazyflie.crtp import Packet, Port
from housefly.wires.crazyflie.log_blocks import (
    CONTROL,
    BlockError,
    BlockOrder,
    BlockRequest,
    encode_block_request,
    read_block_answer,
)
from housefly.wires.crazyflie.parameters import (
    READ,
    WRITE,
    encode_read,
    encode_write,
    number_of,
    read_value,
    written_value,
)
from housefly.wires.crazyflie.tables import TableEntry

DECKS = {
    "deck.bcFlow2": "Flow deck",
    "deck.bcLighthouse4": "Lighthouse deck",
    "deck.bcDWM1000": "Loco deck",
}
"""Decks that tell the drone where it is, by the parameter that finds each."""
_KALMAN, _PID = 2.0, 1.0
_ROUNDING = 1e-4


def flight_settings(tilt_max: float) -> dict[str, float]:
    """Return what the drone must be set to: the estimator that takes poses, limits, height loop.

    A height is asked for anew with every setpoint, as far ahead as the climb that is wanted: what
    its loop would learn of that is wrong.

    Args:
        tilt_max: largest lean of its own position loop [rad].
    """
    return {
        "stabilizer.estimator": _KALMAN,
        "stabilizer.controller": _PID,
        "posCtlPid.rLimit": degrees(tilt_max),
        "posCtlPid.pLimit": degrees(tilt_max),
        "posCtlPid.zKp": HEIGHT_GAIN,
        "posCtlPid.zKi": 0.0,
    }


async def write_settings(link: CrtpLink, table: Table, wanted: Mapping[str, float]) -> None:
    """Write settings, and read each back.

    Raises:
        LinkError: the drone has no such parameter, does not answer, or keeps another value.
    """
    for name, value in wanted.items():
        number, entry = _found(table, name)
        await link.ask(encode_write(number, entry.kind, value), _about(WRITE, number))
        kept = await read_setting(link, table, name)
        if not isclose(kept, value, rel_tol=_ROUNDING, abs_tol=_ROUNDING):
            raise LinkError(f"the Crazyflie keeps {name} = {kept:g}, not {value:g}")


async def read_setting(link: CrtpLink, table: Table, name: str) -> float:
    """Return a parameter's value; raises LinkError as ``write_settings`` does."""
    number, entry = _found(table, name)
    answer = await link.ask(encode_read(number), _about(READ, number))
    return read_value(answer, entry.kind)


async def reset_estimator(link: CrtpLink, table: Table) -> None:
    """Let the drone forget where it believed to be; only on the floor."""
    await _write_unread(link, table, "kalman.resetEstimation", 1.0)
    await _write_unread(link, table, "kalman.resetEstimation", 0.0)


async def found_decks(link: CrtpLink, table: Table) -> tuple[str, ...]:
    """Return the decks on the drone that tell it where it is."""
    return tuple(
        [
            words
            for name, words in DECKS.items()
            if name in table.entries and await read_setting(link, table, name)
        ]
    )


async def start_logs(link: CrtpLink, table: Table) -> None:
    """Let the drone send what reports are made of, and nothing else.

    Raises:
        LinkError: it does not answer, refuses, or has no such variable.
    """
    await _ordered(link, BlockRequest(BlockOrder.RESET))
    for block, (period, variables) in BLOCKS.items():
        found = tuple((kind, _found(table, name)[0]) for name, kind in variables.items())
        await _ordered(link, BlockRequest(BlockOrder.CREATE, block, found))
        await _ordered(link, BlockRequest(BlockOrder.START, block, period=period))


async def _ordered(link: CrtpLink, request: BlockRequest) -> None:
    answer = await link.ask(encode_block_request(request), lambda packet: _answers(packet, request))
    _, _, error = read_block_answer(answer)
    if error not in (BlockError.NONE, BlockError.EXISTS):
        raise LinkError(
            f"the Crazyflie refuses to {request.order.name} log block {request.block}: {error}"
        )


async def _write_unread(link: CrtpLink, table: Table, name: str, value: float) -> None:
    number, entry = _found(table, name)
    is_it = _about(WRITE, number)
    await link.ask(
        encode_write(number, entry.kind, value),
        lambda packet: is_it(packet) and isclose(written_value(packet, entry.kind), value),
    )


def _found(table: Table, name: str) -> tuple[int, TableEntry]:
    if name not in table.entries:
        raise LinkError(f"the Crazyflie has no {name}: is its firmware too old?")
    return table.entries[name]


def _about(channel: int, number: int) -> Callable[[Packet], bool]:
    def is_it(packet: Packet) -> bool:
        is_parameter = packet.port == Port.PARAMETERS and packet.channel == channel
        return is_parameter and number_of(packet) == number

    return is_it


def _answers(packet: Packet, request: BlockRequest) -> bool:
    if packet.port != Port.LOG or packet.channel != CONTROL:
        return False
    order, block, _ = read_block_answer(packet)
    return order is request.order and (order is BlockOrder.RESET or block == request.block)
