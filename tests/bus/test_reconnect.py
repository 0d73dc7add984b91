"""The base of the clients that reconnect for ever."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

import pytest

from housefly.bus.reconnect import DATA_AGE_MAX, ReconnectingClient, within
from housefly.clock import SteppedClock
from housefly.errors import LinkError, WireError


class Client(ReconnectingClient[int]):
    """Lives through one written connection after the other."""

    def __init__(self, story: list[Exception | int], clock: SteppedClock) -> None:
        super().__init__("here", clock)
        self._story = story

    async def _read_connection(self, sink: Callable[[int], None]) -> None:
        if not self._story:
            raise asyncio.CancelledError
        item = self._story.pop(0)
        if isinstance(item, Exception):
            raise item
        self._problem = ""
        self._data_arrived(self._clock.now())
        sink(item)


async def lived_through(
    client: Client, monkeypatch: pytest.MonkeyPatch
) -> tuple[list[float], list[int]]:
    """Run the story without waiting; return the pauses and the data."""
    pauses: list[float] = []
    data: list[int] = []

    async def sleep(seconds: float) -> None:
        pauses.append(seconds)

    monkeypatch.setattr(asyncio, "sleep", sleep)
    with pytest.raises(asyncio.CancelledError):
        await client.run(data.append)
    return pauses, data


class Leaving(ReconnectingClient[int]):
    """Loses its connection while it leaves it, as a broker's library does on a busy machine."""

    async def _read_connection(self, sink: Callable[[int], None]) -> None:
        sink(1)
        try:
            await asyncio.sleep(60.0)
        except asyncio.CancelledError:
            raise LinkError("gone") from None


async def test_a_connection_that_is_lost_while_it_is_left_does_not_begin_again() -> None:
    begun: list[int] = []
    task = asyncio.create_task(Leaving("here").run(begun.append))
    await asyncio.sleep(0)
    task.cancel()
    await asyncio.wait({task}, timeout=5.0)
    assert task.cancelled()
    assert begun == [1]


async def test_pauses_double_up_to_two_seconds_and_shrink_when_data_arrived(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    client = Client([*[LinkError("gone")] * 7, 1, LinkError("gone")], SteppedClock())
    pauses, data = await lived_through(client, monkeypatch)
    assert pauses == pytest.approx([0.1, 0.2, 0.4, 0.8, 1.6, 2.0, 2.0, 0.1, 0.2])
    assert data == [1]


async def test_malformed_bytes_are_counted_and_every_problem_is_told(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    clock = SteppedClock()
    client = Client([WireError("x"), LinkError("nobody answers")], clock)
    assert client.problem == "not connected to here yet" and not client.connected
    await lived_through(client, monkeypatch)
    assert (client.malformed, client.problem) == (1, "nobody answers")


async def test_a_defect_in_reading_is_told_and_does_not_end_the_data(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    client = Client([ZeroDivisionError("division by zero"), 1], SteppedClock())
    _, data = await lived_through(client, monkeypatch)
    assert data == [1]
    assert "ZeroDivisionError" in capsys.readouterr().err
    broken = Client([ZeroDivisionError("division by zero")], SteppedClock())
    await lived_through(broken, monkeypatch)
    assert broken.problem == "here: reading failed (ZeroDivisionError: division by zero)"


async def test_a_client_is_connected_while_its_data_are_new(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    clock = SteppedClock()
    client = Client([1], clock)
    await lived_through(client, monkeypatch)
    assert client.connected and client.problem == ""
    clock.advance(2 * DATA_AGE_MAX)
    assert not client.connected and client.problem == "connected to here, but it is silent"


async def test_work_that_takes_too_long_is_a_link_error() -> None:
    with pytest.raises(LinkError, match="too slow"):
        await within(0.01, asyncio.sleep(5.0), "too slow")
    assert await within(1.0, asyncio.sleep(0.0, 3), "too slow") == 3
