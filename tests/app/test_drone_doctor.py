"""A drone is looked at before anybody flies it: what answers, and what keeps it on the floor."""

from __future__ import annotations

import asyncio
from dataclasses import replace

import pytest
from betaflight_room import betaflight_room
from crazyflie_room import crazyflie_room

from housefly.app.drone_doctor import drone_at, look_at_drone
from housefly.cli import main
from housefly.errors import ConfigError
from housefly.wires.betaflight.settings import FcSettings

pytestmark = pytest.mark.wire


async def test_a_drone_that_is_well_is_said_to_be_and_one_that_is_locked_says_what_to_do(
    loopback: str,
) -> None:
    async with crazyflie_room(loopback) as room:
        await asyncio.sleep(0.2)
        well = await asyncio.to_thread(look_at_drone, drone_at(f"crazyflie://{loopback}"))
        assert all(check.well for check in well)
        assert "2026.08" in well[0].found and {check.name for check in well} >= {
            "reports",
            "state",
            "battery",
            "settings",
        }
        room.world.toggle_emergency()
        await asyncio.sleep(0.3)
        locked = await asyncio.to_thread(look_at_drone, drone_at(f"crazyflie://{loopback}"))
        said = [check.found for check in locked if not check.well]
        assert "emergency" in said
        assert any("switch it off and on" in words for words in said)


@pytest.mark.parametrize(
    ("parameters", "told"),
    [
        ((), "none that tells it where it is"),
        (("deck.bcFlow2",), "Flow deck"),
        (("deck.bcLighthouse4", "deck.bcDWM1000"), "Lighthouse deck, Loco deck"),
    ],
)
async def test_the_decks_that_tell_a_drone_where_it_is_are_found_and_told(
    loopback: str, parameters: tuple[str, ...], told: str
) -> None:
    async with crazyflie_room(loopback) as room:
        room.server.values.update(dict.fromkeys(parameters, 1.0))
        await asyncio.sleep(0.2)
        checks = await asyncio.to_thread(look_at_drone, drone_at(f"crazyflie://{loopback}"))
        decks = next(check for check in checks if check.name == "decks")
        assert decks.well and decks.found == told


async def test_a_betaflight_says_what_is_not_set_as_it_must_be_and_why_it_does_not_arm(
    loopback: str,
) -> None:
    async with betaflight_room(loopback) as room:
        room.firmware.settings = replace(room.firmware.settings, silent=FcSettings().silent)
        checks = await asyncio.to_thread(look_at_drone, drone_at(f"betaflight://{loopback}"))
        assert checks[0].well and "Betaflight 25.12.0" in checks[0].found
        said = [check.found for check in checks if check.name == "it says"]
        assert any("set rxfail 3 to h on the drone (it is auto)" in words for words in said)


def test_a_drone_that_is_not_there_ends_the_command_with_words(
    loopback: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["doctor", "--drone", f"crazyflie://{loopback}"]) == 1
    assert "nobody answers at" in " ".join(capsys.readouterr().out.split())


@pytest.mark.parametrize(
    ("uri", "found", "remedy"),
    [
        ("betaflight://tcp:{host}:5999", "Connection refused", "join its network"),
        ("betaflight://serial:/dev/nothing", "No such file", "plug it in"),
    ],
)
def test_what_mends_a_link_is_of_its_kind(loopback: str, uri: str, found: str, remedy: str) -> None:
    (check,) = look_at_drone(drone_at(uri.format(host=loopback)))
    assert not check.well and found in check.found and remedy in check.remedy


@pytest.mark.parametrize("uri", ["192.168.1.1", "crazyflie://", "crazyfly://10.0.0.1"])
def test_what_is_no_drone_is_refused_with_what_is_allowed(uri: str) -> None:
    with pytest.raises(ConfigError, match=r"--drone"):
        drone_at(uri)
