"""What is typed slowly stays, while others come and go and the page draws itself anew."""

from __future__ import annotations

from collections.abc import AsyncIterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
import pytest_asyncio
from playwright.async_api import Browser, Locator, Page, expect
from stand_in_tasks import StandInTasks

from housefly.app.views import room_view
from housefly.config.house_mode import HouseMode
from housefly.messages import DroneStatus, Phase
from housefly.room.bsen import bsen
from housefly.room.edit_versions import EditVersions
from housefly.sites.loaded_site import open_site, read_site
from housefly.web.api.edit_service import EditService

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]


@dataclass
class Desk:
    """A page, and the console with tasks and edits before it."""

    page: Page
    console: Any
    tasks: StandInTasks
    cookie: str

    async def type(self, field: Locator, words: str) -> None:
        """Type letter by letter into an empty field; after each, somebody comes and goes."""
        await field.focus()
        await self.page.keyboard.press("Control+a")
        await self.page.keyboard.press("Delete")
        await expect(field).to_have_value("")
        for n, letter in enumerate(words):
            await self.page.keyboard.type(letter)
            await self.stir(n)
        await expect(field).to_have_value(words)

    async def stir(self, n: int) -> None:
        """Let all news come that draw parts of the page anew."""
        async with self.console.talk(self.cookie, f"tab-of-guest-{n}", f"Guest {n}") as one:
            await one.hear("viewers")
        self.tasks.mode = HouseMode.AWAY if n % 2 else HouseMode.HOME
        self.tasks.tell()
        self.console.pilot.battery -= 0.01
        frames = "new Promise((done) => requestAnimationFrame(() => setTimeout(done, 20)))"
        await self.page.evaluate(frames)


@pytest_asyncio.fixture(loop_scope="session")
async def desk(
    serving: Any, loopback: str, chromium: Browser, tmp_path: Path
) -> AsyncIterator[Desk]:
    loaded = open_site(read_site("bsen"))
    edits = EditService(bsen, loaded.site, EditVersions(tmp_path / "edits"))
    async with serving(loopback, edits=edits, view=room_view(loaded)) as console:
        tasks = StandInTasks(console.bus.join())
        tasks.tell()
        page = await chromium.new_page(viewport={"width": 1440, "height": 900})
        await page.goto(console.link)
        await expect(page.locator(".headline")).to_contain_text("Your drone is home")
        (kept,) = await page.context.cookies()
        cookie = f"{kept['name']}={kept['value']}"
        console.proofs[cookie] = await page.evaluate("localStorage['housefly proof']")
        yield Desk(page, console, tasks, cookie)
        await page.context.close()


async def test_a_name_and_a_question_stay(desk: Desk) -> None:
    page = desk.page
    await desk.type(page.get_by_role("combobox", name="Where is"), "the red cup")
    await page.get_by_role("button", name="You have control", exact=True).click()
    await desk.type(page.get_by_role("textbox", name="Your name"), "Anna")


async def test_half_a_question_stays_when_a_drone_takes_off_and_is_no_command(desk: Desk) -> None:
    page, pilot = desk.page, desk.console.pilot
    field = page.get_by_role("combobox", name="Where is")
    await desk.type(field, "where is ")
    pilot.status, pilot.phase = DroneStatus.FLYING, Phase.HOLDING
    await expect(page.locator(".headline")).to_contain_text("Hovering")
    await page.keyboard.type("teabottle")  # a space would stop, also here
    await expect(field).to_have_value("where is teabottle")
    assert pilot.orders == []
    await page.keyboard.press("Enter")
    await expect(page.get_by_role("button", name="Fly home")).to_be_visible()


async def test_a_wish_its_numbers_and_a_search_stay(desk: Desk) -> None:
    page = desk.page
    await (
        page.get_by_role("tab", name="Tasks")
        .or_(page.get_by_role("button", name="Tasks", exact=True))
        .first.click()
    )
    await desk.type(page.get_by_role("searchbox", name="Ask for something"), "look around")
    await page.get_by_role("button", name="Look at a place or a thing").click()
    await desk.type(page.get_by_label("what to look at"), "sofa")
    await desk.type(page.get_by_label("how long to look"), "12.5")
    await page.get_by_role("tab", name="Clips").click()
    await desk.type(page.get_by_label("person"), "anna")


async def test_a_place_and_its_half_typed_numbers_stay(desk: Desk) -> None:
    page = desk.page
    await page.goto(f"{desk.console.origin}/#edit")
    await page.reload()
    await page.get_by_role("button", name="Entrance", exact=True).click()
    await desk.type(page.get_by_label("Name", exact=True), "Reading corner")
    x = page.get_by_label("x", exact=True).first
    await x.focus()
    await page.keyboard.press("Control+a")
    for n, (key, shown) in enumerate(zip("-1.25", ("", "-1", "-1", "-1.2", "-1.25"), strict=True)):
        await page.keyboard.press(key)
        await desk.stir(n)
        value = await x.input_value()
        assert value.rstrip(".") == shown, f"after {key}"
