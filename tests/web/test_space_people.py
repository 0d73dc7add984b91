"""People in the view in space, in real Chromium with WebGL: plain, pale when old, never certain."""

from __future__ import annotations

import asyncio
import time
from collections.abc import AsyncIterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
import pytest_asyncio
from installed_chromium import chromium_path
from playwright.async_api import Page, async_playwright, expect

from housefly.config.hub import HubConfig
from housefly.config.site import Site
from housefly.geometry import Vec3
from housefly.hub.api.answers import SituationAnswer
from housefly.hub.hub import Hub
from housefly.hub.things.thing import Thing, ThingKind
from housefly.messages import Observation
from housefly.messages.words import literal

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

SOFTWARE_WEBGL = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]


@dataclass
class House:
    """A hub that is told of people, and the page that shows them in space."""

    hub: Hub
    page: Page

    def see(self, person: str, position: Vec3, ago: float = 0.0) -> None:
        at = time.time() - ago
        self.hub.memory.add(Observation(person, "floor-1", at, at, position))

    def name(self, person: str) -> Any:
        return self.page.locator(f".space-names [data-person='{person}']")

    async def picture(self) -> bytes:
        """Return the drawing alone."""
        return await self.page.locator(".space-canvas canvas").screenshot()


@pytest_asyncio.fixture(loop_scope="session")
async def house(serving: Any, loopback: str, tmp_path: Path) -> AsyncIterator[House]:
    """Yield a room in space with the resident, seen now, and a guest, seen a while ago."""
    path = chromium_path()
    async with serving(loopback) as console, async_playwright() as playwright:
        hub = Hub(
            Site(hub=HubConfig(store=str(tmp_path / "room.db"))), tmp_path, console.bus.join()
        )
        for thing in (
            Thing("person-1", "the resident", ThingKind.PERSON),
            Thing("person-2", "the guest", ThingKind.PERSON),
        ):
            hub.memory.world.add_thing(thing)
        telling = asyncio.create_task(hub.run())
        browser = await playwright.chromium.launch(executable_path=path, args=SOFTWARE_WEBGL)
        page = await browser.new_page(viewport={"width": 1440, "height": 900})
        found = House(hub, page)
        found.see("person-1", (2.0, 0.8, 0.0))
        found.see("person-2", (6.0, 1.0, 0.0), ago=70.0)
        await page.goto(console.link)
        await expect(page.locator(".thing-mark[data-thing=person-1]")).to_be_visible()
        await page.locator(".turns .to-space").click()
        await expect(page.locator(".space-canvas canvas, .space-view [role=status]")).to_be_visible(
            timeout=20_000
        )
        if await page.locator(".space-view [role=status]").count():
            await browser.close()
            pytest.skip("this Chromium has no WebGL")
        yield found
        await browser.close()
        telling.cancel()
        await asyncio.gather(telling, return_exceptions=True)
        await asyncio.to_thread(hub.close)


@pytest.mark.interop
async def test_who_was_seen_long_ago_is_pale_and_says_so(house: House) -> None:
    await expect(house.name("person-2")).to_contain_text("the guest")
    await expect(house.name("person-2")).to_contain_text("s ago")
    await expect(house.name("person-1")).to_contain_text("the resident")
    await expect(house.name("person-1")).not_to_contain_text("ago")
    opacity = [
        float(await house.name(one).evaluate("e => getComputedStyle(e).opacity"))
        for one in ("person-1", "person-2")
    ]
    assert opacity[0] > opacity[1]
    await expect(house.page.locator(".space-words")).to_contain_text("last seen")


@pytest.mark.interop
async def test_doubt_is_in_the_words_of_the_plan(house: House) -> None:
    lies = SituationAnswer(
        "lies on the floor",
        "person-1",
        time.time(),
        0.84,
        "low for 12 s",
        words=literal("lies on the floor"),
    )
    house.hub.status.set_situations([lies])
    await expect(house.name("person-1")).to_contain_text("△ lies on the floor, 84 %")


async def test_a_figure_is_drawn_and_its_name_goes_with_it(house: House) -> None:
    await expect(house.name("person-1")).to_be_visible()
    await asyncio.sleep(1.0)
    with_people, before = await house.picture(), await house.name("person-1").bounding_box()
    house.see("person-1", (4.0, 0.8, 0.0))

    async def moved() -> bool:
        after = await house.name("person-1").bounding_box()
        return after is not None and before is not None and after["x"] > before["x"] + 60

    async with asyncio.timeout(10.0):
        while not await moved():
            await asyncio.sleep(0.1)
    assert await house.picture() != with_people
    await house.page.get_by_text("Layers").click()
    await house.page.get_by_role("button", name="People and things").click()
    await expect(house.page.locator(".space-names [data-person]")).to_have_count(0)
