"""The scanner's client against the simulated scanner and against servers that misbehave."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from math import inf

import pytest

from housefly.config.laser import LaserConfig
from housefly.messages import Scan
from housefly.sensors.laser import LaserClient
from housefly.twin.sensors.laser_server import LaserServer
from housefly.wires.scip import UST_10LX

pytestmark = pytest.mark.wire
RANGES = (65533, 1500, *range(2000, 2000 + UST_10LX.beams - 3), 5)


async def until(done: Callable[[], bool], limit: float = 8.0) -> None:
    async with asyncio.timeout(limit):
        while not done():
            await asyncio.sleep(0.01)


async def reading(
    client: LaserClient,
    server: LaserServer | None,
    check: Callable[[list[Scan]], Awaitable[None]],
    stamp: Callable[[int], int],
) -> None:
    heard: list[Scan] = []
    task = asyncio.create_task(client.run(heard.append))

    async def measure() -> None:
        number = 0
        while True:
            await asyncio.sleep(0.01)
            number += 1
            if server is not None:
                server.publish(RANGES, stamp(number))

    ticking = asyncio.create_task(measure())
    try:
        await check(heard)
    finally:
        for each in (task, ticking):
            each.cancel()
        await asyncio.gather(task, ticking, return_exceptions=True)


def config(loopback: str) -> LaserConfig:
    return LaserConfig(name="laser-1", address=loopback)


async def test_scans_arrive_in_metres_with_angles_and_what_is_no_distance_is_infinite(
    loopback: str,
) -> None:
    server, client = LaserServer(UST_10LX, loopback), LaserClient(config(loopback))
    await server.start()

    async def check(heard: list[Scan]) -> None:
        await until(lambda: len(heard) > 3)
        scan = heard[-1]
        assert scan.ranges[:3] == (inf, 1.5, 2.0) and scan.ranges[-1] == inf
        assert scan.first_angle == UST_10LX.first_angle and scan.step == UST_10LX.step
        assert scan.received_at - scan.captured_at == pytest.approx(0.03)
        assert client.connected and not client.problem

    # A second of its clock for each: none of them is late, however busy this machine is.
    await reading(client, server, check, lambda n: 1000 * n)
    await server.stop()


async def test_a_clock_that_stands_still_is_no_measurement(loopback: str) -> None:
    server, client = LaserServer(UST_10LX, loopback), LaserClient(config(loopback))
    await server.start()

    async def check(heard: list[Scan]) -> None:
        await until(lambda: client.stale > 5)
        assert len(heard) == 1

    await reading(client, server, check, lambda n: 7)
    await server.stop()


async def test_of_scans_that_waited_only_the_newest_is_handed_on(loopback: str) -> None:
    server, client = LaserServer(UST_10LX, loopback), LaserClient(config(loopback))
    await server.start()

    async def check(heard: list[Scan]) -> None:
        await until(lambda: len(heard) > 3)
        before = client.overtaken
        for number in range(15):  # nobody reads meanwhile: the machine was busy
            server.publish((*RANGES[:-1], 3000 + number), 100_000 + 25 * number)
        await until(lambda: client.overtaken > before + 5)
        await until(lambda: heard[-1].ranges[-1] == inf)
        seen = [scan.ranges[-1] for scan in heard if scan.ranges[-1] != inf]
        assert len(seen) <= 15 - (client.overtaken - before) + 1 and seen == sorted(seen)

    await reading(client, server, check, lambda n: 25 * n)
    await server.stop()


async def test_a_scan_that_waited_is_as_old_as_it_is(loopback: str) -> None:
    server, client = LaserServer(UST_10LX, loopback), LaserClient(config(loopback))
    await server.start()

    async def check(heard: list[Scan]) -> None:
        await until(lambda: len(heard) > 1 and age(heard[-1]) > 0.2)
        assert age(heard[0]) == pytest.approx(0.03)

    def age(scan: Scan) -> float:
        return scan.received_at - scan.captured_at

    await reading(client, server, check, lambda n: n)  # 1 ms of its clock in 10 of ours
    await server.stop()


async def test_it_comes_back_when_the_scanner_does(loopback: str) -> None:
    server, client = LaserServer(UST_10LX, loopback), LaserClient(config(loopback))

    async def check(heard: list[Scan]) -> None:
        await until(lambda: "nobody answers" in client.problem)
        for _ in range(2):
            await server.start()
            before = len(heard)
            await until(lambda before=before: len(heard) > before + 2)
            await server.stop()
            await until(lambda: bool(client.problem))

    await reading(client, server, check, lambda n: n)


@pytest.mark.parametrize(
    "answer",
    [
        b"\xff\xfe\n\n",
        b"HTTP/1.1 400 Bad\r\n\r\n\n\n",
        b"x" * 40_000,
        b"QT\n00P\n\nPP\n00P\nMODL:x;1\n\n",
    ],
)
async def test_another_protocol_is_told_and_never_ends_the_client(
    loopback: str, answer: bytes
) -> None:
    async def answering(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        writer.write(answer)
        await reader.read(1000)

    client = LaserClient(config(loopback))
    async with await asyncio.start_server(answering, loopback, 10940):

        async def check(heard: list[Scan]) -> None:
            await until(lambda: client.malformed > 1)
            assert "does not speak SCIP" in client.problem and not heard

        await reading(client, None, check, lambda n: n)


@pytest.mark.parametrize("answers_qt", [True, False])
async def test_a_scanner_of_an_older_protocol_is_told_its_version_and_ours(
    loopback: str, answers_qt: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(LaserClient, "SILENCE_TIMEOUT", 0.2)
    version = b"V\n0\nVEND:Hokuyo Automatic Co., Ltd.;\nPROD:URG-04LX;\nPROT:SCIP 1.1;\n\n"

    async def answering(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        while line := await reader.readline():
            if line == b"V\n":
                writer.write(version)
            elif answers_qt:
                writer.write(line + b"E\n\n")

    client = LaserClient(config(loopback))
    async with await asyncio.start_server(answering, loopback, 10940):

        async def check(heard: list[Scan]) -> None:
            await until(lambda: "speaks SCIP 1.1; Housefly speaks SCIP 2.0" in client.problem)

        await reading(client, None, check, lambda n: n)
