"""What a page may do to a simulated room, who may, and what is refused."""

from __future__ import annotations

import json
from typing import Any

import pytest

from housefly.bus.bus import Bus
from housefly.bus.local import LocalBus
from housefly.bus.simulated_room import (
    SIMULATION_QUERY,
    SimulatedDeed,
    SimulatedOutcome,
    act_from_json,
    outcome_to_json,
)
from housefly.messages.words import Words
from housefly.web.api.simulated_room import SimulatedRoom

pytestmark = pytest.mark.asyncio(loop_scope="session")
TAB = "tab-number-one"


def room_on(bus: Bus, heard: list[SimulatedDeed]) -> SimulatedRoom:
    """Return a simulated room that does whatever it is asked."""

    def answer(text: str) -> str:
        heard.append(act_from_json(text).deed)
        return outcome_to_json(SimulatedOutcome(True, Words("this room is simulated")))

    bus.answer(SIMULATION_QUERY, answer)
    return SimulatedRoom(bus)


async def asked(console: Any, cookie: str, **body: Any) -> tuple[int, str]:
    status, _, text = await console.request(
        "POST", "/simulation", json.dumps(body), Cookie=cookie, Origin=console.origin
    )
    return status, text


async def test_who_has_control_changes_the_room_and_everybody_else_is_refused(
    serving: Any, loopback: str
) -> None:
    heard: list[SimulatedDeed] = []
    async with serving(loopback, simulation=room_on(LocalBus(), heard)) as console:
        strangers, _ = await asked(console, "", tab=TAB, deed="charge")
        cookie = await console.session()
        nobody, words = await asked(console, cookie, tab=TAB, deed="charge")
        assert (strangers, nobody) == (403, 403) and "control" in words
        async with console.talk(cookie, TAB) as talk:
            assert (await talk.hear("welcome"))["simulated"] is True
            await talk.hear("viewers", pilot=1)
            other, words = await asked(console, cookie, tab="another-tab", deed="charge")
            assert other == 403 and "control" in words and heard == []
            status, text = await asked(console, cookie, tab=TAB, deed="put back")
            assert status == 200 and json.loads(text)["done"] is True
            assert heard == [SimulatedDeed.PUT_BACK]
            told = await talk.hear("events")
            assert "this room is simulated" in told["events"][-1]["text"], "everybody is told"
            status, _, text = await console.request("GET", "/simulation", Cookie=cookie)
            assert status == 200 and json.loads(text)["simulated"] is True
            for body, about in (
                ({"tab": TAB}, "deed"),
                ({"tab": TAB, "deed": "explode"}, "deed"),
                ({"tab": 1, "deed": "charge"}, "tab"),
                ({"tab": TAB, "deed": "fault", "fault": "F03", "seconds": 1e9}, "seconds"),
                ({"tab": TAB, "deed": "charge", "more": 1}, "more"),
                ({"tab": TAB, "deed": "charge", "drone": "nobody"}, "drone"),
            ):
                status, text = await asked(console, cookie, **body)
                assert status == 422 and about in json.loads(text)["error"], text
            assert (await asked(console, cookie, tab=TAB, deed="a" * 2000))[0] == 413


async def test_who_may_only_ask_changes_nothing(serving: Any, loopback: str) -> None:
    heard: list[SimulatedDeed] = []
    async with serving(loopback, simulation=room_on(LocalBus(), heard)) as console:
        cookie = await console.session()
        async with console.talk(cookie, TAB) as talk:
            await talk.say(type="invite", id=1, role="ask")
            path = (await talk.hear("invite"))["path"]
            _, headers, _ = await console.request("GET", path)
            guest = console.opened(headers)
            status, text = await asked(console, guest, tab=TAB, deed="charge")
            assert status == 403 and "your role" in text and heard == []


async def test_a_real_room_is_not_changed_and_a_silent_one_says_so(
    serving: Any, loopback: str
) -> None:
    async with serving(loopback) as console:
        cookie = await console.session()
        async with console.talk(cookie, TAB) as talk:
            assert (await talk.hear("welcome"))["simulated"] is False
            status, text = await asked(console, cookie, tab=TAB, deed="put back")
            assert status == 404 and "this room is real" in text
            _, _, text = await console.request("GET", "/simulation", Cookie=cookie)
            assert json.loads(text)["simulated"] is False
    assert SimulatedRoom(LocalBus()).view().words == "the simulated room does not answer"
