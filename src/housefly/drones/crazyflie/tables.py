"""Reading a drone's tables of contents, some entries at a time."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from dataclasses import dataclass

from housefly.drones.crazyflie.link import CrtpLink
from housefly.wires.crazyflie.crtp import Packet, Port
from housefly.wires.crazyflie.tables import (
    TOC_CHANNEL,
    TableEntry,
    info_question,
    item_question,
    read_info,
    read_item,
)

_AT_ONCE = 8
"""Entries asked for before the first answer came: more would drown a radio."""


@dataclass(frozen=True, slots=True)
class Table:
    """A table of contents.

    Attributes:
        check: tells one table from another.
        entries: number and entry, by ``group.name``.
    """

    check: int
    entries: Mapping[str, tuple[int, TableEntry]]


async def read_table(link: CrtpLink, port: Port, known: Table | None = None) -> Table:
    """Return a drone's table; one that is known already is not read again.

    Args:
        link: to the drone.
        port: of log variables or parameters.
        known: what was read before, if anything was.

    Raises:
        LinkError: the drone does not answer.
    """
    told = await link.ask(info_question(port), lambda packet: _is_info(packet, port))
    count, check = read_info(told)
    if known is not None and (known.check, len(known.entries)) == (check, count):
        return known
    entries: dict[str, tuple[int, TableEntry]] = {}
    for first in range(0, count, _AT_ONCE):
        numbers = range(first, min(first + _AT_ONCE, count))
        for entry, number in zip(
            await asyncio.gather(*(_entry(link, port, number) for number in numbers)),
            numbers,
            strict=True,
        ):
            entries[entry.name] = number, entry
    return Table(check, entries)


async def _entry(link: CrtpLink, port: Port, number: int) -> TableEntry:
    answer = await link.ask(
        item_question(port, number),
        lambda packet: _is_on(packet, port) and read_item(packet)[0] == number,
    )
    return read_item(answer)[1]


def _is_info(packet: Packet, port: Port) -> bool:
    return _is_on(packet, port) and read_info(packet) is not None


def _is_on(packet: Packet, port: Port) -> bool:
    return packet.port == port and packet.channel == TOC_CHANNEL
