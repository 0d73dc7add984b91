"""Saved edits are used at once only by who has control, while nothing speaks against it."""

from __future__ import annotations

import json
from collections.abc import AsyncIterator, Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest
import pytest_asyncio
from stand_in_tasks import StandInTasks

from housefly.config.edits import Edits
from housefly.config.site import Site
from housefly.messages import DroneStatus, Phase
from housefly.room.bsen import bsen
from housefly.room.edit_versions import EditVersions
from housefly.web.access.audit_log import AuditLog
from housefly.web.api.edit_service import EditService

pytestmark = [pytest.mark.wire, pytest.mark.asyncio(loop_scope="session")]

TAB = "tab-number-one"


@dataclass
class Desk:
    """A browser that has control, before a console whose launcher notes what it is asked."""

    console: Any
    cookie: str
    versions: EditVersions
    audit: Path
    in_force: Edits = field(default_factory=Edits)
    used: list[int] = field(default_factory=list)
    refusal: str = ""

    def use(self, number: int) -> str:
        self.used.append(number)
        return self.refusal

    async def ask(self, version: int = 1, tab: str = TAB, **headers: str) -> tuple[int, str]:
        given = {"Cookie": self.cookie, "Origin": self.console.origin, **headers}
        body = json.dumps({"based_on": version, "tab": tab})
        status, _, text = await self.console.request("POST", "/edits/use", body, **given)
        return status, json.loads(text).get("error", "")


@pytest_asyncio.fixture(loop_scope="session")
async def desk(serving: Any, loopback: str, tmp_path: Path) -> AsyncIterator[Desk]:
    versions = EditVersions(tmp_path / "edits")
    versions.save(Edits(removed=("bed",)), 0)
    found: Desk | None = None
    service = EditService(
        bsen,
        Site(),
        versions,
        in_force=lambda: found.in_force if found else Edits(),
        use=lambda number: found.use(number) if found else "",
    )
    audit = tmp_path / "commands.jsonl"
    async with serving(loopback, edits=service, audit=AuditLog(audit)) as console:
        cookie = await console.session()
        async with console.talk(cookie, TAB, "Ada") as talk:
            await talk.hear("state")
            found = Desk(console, cookie, versions, audit)
            yield found


async def test_who_has_control_uses_it_on_the_ground_and_everybody_is_told(
    desk: Desk, until: Callable[..., Any]
) -> None:
    assert await desk.ask() == (200, "")
    assert desk.used == [1]
    said = "Ada starts the pilot again, so that the drone has the newest places and zones"
    await until(lambda: desk.audit.exists() and said in desk.audit.read_text())


async def test_in_flight_and_in_doubt_nobody_is_asked_to_start_anything(desk: Desk) -> None:
    pilot = desk.console.pilot
    pilot.status, pilot.phase = DroneStatus.FLYING, Phase.HOLDING
    await said(desk, "land first")
    pilot.status, pilot.phase = DroneStatus.LANDED, Phase.IDLE
    pilot.telemetry_age = 9.0
    await said(desk, "nobody knows whether the drone flies")
    pilot.telemetry_age, pilot.publishing = 0.03, False
    await said(desk, "nobody knows whether the drone flies")
    assert desk.used == []


async def test_a_task_that_is_under_way_is_not_cut_off(desk: Desk) -> None:
    tasks = StandInTasks(desk.console.bus.join())
    task = tasks.ring()
    tasks.advance(task.id, 0)
    await said(desk, "a task is under way")
    assert desk.used == []
    tasks.finish(task.id, "seen")
    tasks.close()


async def test_others_other_pages_and_old_pages_use_nothing(desk: Desk) -> None:
    assert (await desk.ask(Origin="http://elsewhere.example"))[0] == 403
    assert (await desk.ask(Cookie=""))[0] == 403
    assert await desk.ask(tab="tab-number-two") == (403, "Ada has control")
    assert (await desk.ask(version=0))[0] == 409
    desk.in_force = desk.versions.newest().edits
    assert await desk.ask() == (409, "the drone has this version already")
    assert desk.used == []


async def test_what_pilot_or_launcher_refuse_is_said_in_their_words(desk: Desk) -> None:
    desk.refusal = "an order to fly has just come"
    assert await desk.ask() == (409, desk.refusal)
    assert not desk.audit.exists() or "starts the pilot" not in desk.audit.read_text()


async def said(desk: Desk, words: str) -> None:
    """Ask until the console has heard of a change; whatever is refused is a 409."""
    for _ in range(100):
        status, told = await desk.ask()
        if words in told:
            assert status == 409
            return
        desk.used.clear()
    raise AssertionError(f"{words!r} was not said, but {told!r}")
