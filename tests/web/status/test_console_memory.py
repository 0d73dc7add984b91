"""Control, STOP and log over a restart of the console, over real sockets and on a real disk."""

from __future__ import annotations

import asyncio
import time
from contextlib import AsyncExitStack
from pathlib import Path
from typing import Any

import pytest

from housefly.bus.topics import HUB_QUERY
from housefly.hub.api.answers import EventAnswer, EventsAnswer
from housefly.hub.api.json import answer_to_json
from housefly.messages import Severity
from housefly.web.messages.server_messages import EventView
from housefly.web.status.console_memory import ConsoleMemory, KeptControl, KnownTab

pytestmark = [pytest.mark.wire, pytest.mark.asyncio(loop_scope="session")]


def event(number: int, at: float = 5.0) -> EventView:
    return EventView(number, at, Severity.INFO, "test", f"event {number}")


async def test_what_was_kept_is_read_again_and_a_torn_line_is_not(tmp_path: Path) -> None:
    control = KeptControl(2, (KnownTab("owner", "tab-number-two", 2, "Ben"),), True, "Anna")
    first = ConsoleMemory(tmp_path)
    assert first.read(10.0).is_new
    first.keep_control(KeptControl(1))
    for number in range(1, 4):
        first.keep_event(event(number))
    first.keep_event(event(4, at=99.0))
    first.keep_control(control)
    first.close()
    file = tmp_path / "console.jsonl"
    assert file.stat().st_mode & 0o777 == 0o600
    file.write_text(file.read_text() + '{"control": {"holder": 7, "ta')
    kept = ConsoleMemory(tmp_path).read(10.0)
    assert not kept.is_new and kept.control == control
    assert [one.number for one in kept.events] == [1, 2, 3], "4 is of another boot"


async def test_a_line_torn_by_a_kill_hides_nothing_that_the_next_console_keeps(
    tmp_path: Path,
) -> None:
    (tmp_path / "console.jsonl").write_text('{"control": {"holder": 7, "ta')
    second = ConsoleMemory(tmp_path)
    second.read(10.0)
    stopped = KeptControl(2, stop_holds=True, stop_by="Anna")
    second.keep_control(stopped)
    second.close()
    assert ConsoleMemory(tmp_path).read(10.0).control == stopped


async def test_a_file_that_grows_is_written_anew_with_all_that_counts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("housefly.web.status.console_memory._SIZE_MAX", 2000)
    memory = ConsoleMemory(tmp_path)
    memory.read(10.0)
    memory.keep_control(KeptControl(3))
    for number in range(1, 100):
        memory.keep_event(event(number))
    memory.close()
    kept = ConsoleMemory(tmp_path).read(10.0)
    assert kept.control.holder == 3
    assert [one.number for one in kept.events] == list(range(1, 100))


async def test_after_a_restart_control_waits_for_its_holder_and_the_log_is_there(
    serving: Any, loopback: str, tmp_path: Path
) -> None:
    async with serving(loopback, memory=ConsoleMemory(tmp_path)) as served:
        cookie, proofs, port = await served.session(), served.proofs, served.port
        async with (
            served.talk(cookie, "the-pilots-tab", "Anna") as anna,
            served.talk(cookie, "a-watchers-tab", "Ben") as ben,
        ):
            await ben.hear("verdict", pilot=1, control="Anna")
            served.pilot.add_event(Severity.WARNING, "going_on", "something happened")
            await anna.hear("events")
            await anna.say(type="stop", id=1)
            await anna.hear("accepted", id=1)
            await confirmed(anna)
    async with serving(loopback, port, memory=ConsoleMemory(tmp_path)) as served:
        served.proofs.update(proofs)
        why = {"severity": "warning", "words": "landed: the battery is empty"}
        landed = EventAnswer("battery low", "ardrone", time.time(), "pilot", "", 1.0, why)
        served.bus.answer(HUB_QUERY, lambda _: answer_to_json(EventsAnswer((landed,))))
        async with AsyncExitStack() as stack:
            ben = await stack.enter_async_context(served.talk(cookie, "a-watchers-tab", "Ben"))
            welcome = await ben.hear("welcome")
            assert welcome["you"] == 2
            texts = [one["text"] for one in welcome["events"]]
            restarted = next(n for n, text in enumerate(texts) if "started again" in text)
            assert "something happened" in texts[:restarted]
            missed = ""
            while "the battery is empty" not in missed:
                missed = str(texts) + str(await ben.hear("events"))
            await ben.hear("verdict", pilot=1, control="Anna")
            await ben.say(type="order", id=2, order="take_off")
            assert "Anna has control" in (await ben.hear("refused", id=2))["reason"]
            anna = await stack.enter_async_context(served.talk(cookie, "the-pilots-tab", "Anna"))
            assert (await anna.hear("welcome"))["you"] == 1
            await confirmed(anna)
            assert served.pilot.stopped, "the pilot of this test is new, and was stopped again"
            assert served.stops


async def test_tabs_without_number_that_were_kept_shut_nobody_out(
    serving: Any, loopback: str, tmp_path: Path
) -> None:
    guest = tuple(KnownTab("guest", f"tab-number-{n}", n, "Eve") for n in range(1, 10_001))
    first = ConsoleMemory(tmp_path)
    first.read(10.0)
    first.keep_control(KeptControl(None, guest))
    first.close()
    memory = ConsoleMemory(tmp_path)
    async with (
        serving(loopback, memory=memory) as served,
        served.talk(await served.session(), "tab-of-admin", "Ada") as ada,
    ):
        assert (await ada.hear("welcome"))["you"] == 10_001
        await ada.hear("verdict", pilot=10_001)
    memory.close()
    kept = ConsoleMemory(tmp_path).read(1e9).control.tabs
    assert len(kept) <= 256 and kept[-1].name == "Ada"


async def confirmed(talk: Any) -> None:
    async with asyncio.timeout(5.0):
        while (await talk.hear("verdict"))["stop"]["progress"] != "confirmed":
            pass
