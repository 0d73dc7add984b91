"""What the console tells unasked: here the pre-flight checks, over real sockets."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from housefly.messages import DroneStatus

pytestmark = [pytest.mark.wire, pytest.mark.asyncio(loop_scope="session")]


def fails(console: Any) -> None:
    """Let the first check, a required one, fail."""
    first, *others = console.pilot.checks
    console.pilot.checks = (replace(first, passed=False, value="12%"), *others)


async def checked(talk: Any, condition: Any) -> dict[str, Any]:
    """Return the first list of checks that meets a condition."""
    while not condition(found := (await talk.hear("preflight"))["preflight"]):
        pass
    return dict(found)


async def test_everybody_hears_the_pre_flight_checks_and_what_changes_in_them(console: Any) -> None:
    cookie = await console.session()
    async with console.talk(cookie, "the-pilots-tab") as pilot:
        found = await checked(pilot, lambda one: one["checks"])
        assert found["ready"] and found["checks"][0]["code"] == "charge"
        async with console.talk(cookie, "a-watchers-tab") as watcher:
            await checked(watcher, lambda one: one["ready"])
            fails(console)
            for talk in (pilot, watcher):
                found = await checked(talk, lambda one: not one["ready"] and one["checks"])
                assert found["checks"][0]["value"] == "12%"
                assert all(found["checks"][0][key] for key in ("limit", "why", "mend", "fault"))


async def test_in_flight_there_are_no_checks_that_somebody_could_take_for_new_ones(
    console: Any,
) -> None:
    async with console.talk(await console.session()) as one:
        await checked(one, lambda found: found["ready"])
        console.pilot.status = DroneStatus.FLYING
        assert await checked(one, lambda found: not found["checks"]) == {
            "ready": False,
            "checks": [],
        }
        console.pilot.status = DroneStatus.LANDED
        await checked(one, lambda found: found["ready"])


async def test_a_pilot_that_cannot_tell_its_checks_is_not_ready(console: Any) -> None:
    async with console.talk(await console.session()) as one:
        await checked(one, lambda found: found["ready"])
        console.pilot.checks = ("no check at all",)
        assert not (await checked(one, lambda found: not found["checks"]))["ready"]
