"""The simulated scanner on its wire, asked as the manual asks."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

import pytest

from housefly.errors import LinkError
from housefly.twin.sensors.laser_server import LaserServer
from housefly.wires.scip import (
    URG_04LX,
    ScannerParameters,
    ScipReply,
    decode_measurement,
    decode_reply,
)
from housefly.wires.scip.parameters import named_values

pytestmark = pytest.mark.wire
PORT = 10940
RANGES = tuple(range(1000, 1000 + URG_04LX.beams))


class Line:
    def __init__(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        self.reader, self.writer = reader, writer

    async def reply(self) -> ScipReply:
        async with asyncio.timeout(5.0):
            return decode_reply(await self.reader.readuntil(b"\n\n"))

    async def ask(self, text: str) -> ScipReply:
        self.writer.write(text.encode() + b"\n")
        return await self.reply()


@asynccontextmanager
async def serving(address: str) -> AsyncIterator[tuple[LaserServer, Line]]:
    server = LaserServer(URG_04LX, address, PORT)
    await server.start()
    reader, writer = await asyncio.open_connection(address, PORT)
    try:
        yield server, Line(reader, writer)
    finally:
        writer.close()
        await server.stop()


async def test_it_says_who_and_how_it_is(loopback: str) -> None:
    async with serving(loopback) as (_, line):
        assert ScannerParameters.of(await line.ask("PP")) == URG_04LX
        assert named_values(await line.ask("VV"))["PROT"] == "SCIP 2.2"
        assert named_values(await line.ask("II;hello"))["LASR"] == "OFF"
        assert (await line.ask("BM")).status == "00"
        assert (await line.ask("BM")).status == "02"
        assert named_values(await line.ask("II"))["LASR"] == "ON"
        assert (await line.ask("QT")).status == "00"
        assert named_values(await line.ask("II"))["LASR"] == "OFF"


async def test_md_sends_as_many_scans_as_asked_and_counts_down(loopback: str) -> None:
    async with serving(loopback) as (server, line):
        assert (await line.ask("MD0044072501003")) == ScipReply("MD0044072501003", "00")
        for stamp in range(5):
            server.publish(RANGES, stamp)
        for left in (2, 1, 0):
            found = decode_measurement(await line.reply())
            assert found is not None and found.request.count == left
            assert found.ranges == RANGES
        assert (await line.ask("PP")).echo == "PP"


async def test_scans_are_skipped_clustered_and_cut_out_as_asked(loopback: str) -> None:
    async with serving(loopback) as (server, line):
        await line.ask("MD0050006104100")
        for stamp in range(4):
            server.publish(RANGES, stamp)
        found = [decode_measurement(await line.reply()) for _ in range(2)]
        assert [scan.stamp for scan in found if scan] == [0, 2]
        assert found[0] is not None and found[0].ranges == (1006, 1010, 1014)


async def test_gd_needs_the_laser_and_gives_the_newest(loopback: str) -> None:
    async with serving(loopback) as (server, line):
        assert (await line.ask("GD0044072501")).status == "10"
        await line.ask("BM")
        server.publish(RANGES, 77)
        found = decode_measurement(await line.ask("GD0044072501"))
        assert found is not None and (found.stamp, found.ranges) == (77, RANGES)


@pytest.mark.parametrize(
    ("text", "status"),
    [
        ("MD0044072601000", "04"),
        ("MD0100005001000", "05"),
        ("XX", "0E"),
        ("MD00", "0E"),
        ("PP;forbidden*", "0E"),
    ],
)
async def test_what_makes_no_sense_is_answered_with_its_status(
    loopback: str, text: str, status: str
) -> None:
    async with serving(loopback) as (_, line):
        assert (await line.ask(text)).status == status
        assert (await line.ask("PP")).status == "00"


async def test_garbage_ends_a_connection_and_not_the_server(loopback: str) -> None:
    async with serving(loopback) as (server, line):
        reader, writer = await asyncio.open_connection(loopback, PORT)
        writer.write(b"\xff" * 5000)
        async with asyncio.timeout(5.0):
            assert await reader.read() == b""
        writer.close()
        assert (await line.ask("\x01\x02")).status == "0E"
        assert server.malformed == 1


async def test_a_port_that_is_taken_is_told(loopback: str) -> None:
    async with serving(loopback):
        with pytest.raises(LinkError, match="cannot serve SCIP"):
            await LaserServer(URG_04LX, loopback, PORT).start()
