"""axe-core finds nothing: the console in each state, its sheets, tasks and clips, and the login."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from axe_audit import axe_findings
from clip_rows import clip
from console_page import open_orders
from filming import video
from pilot_states import fault, flying, looking, ready, silent
from playwright.async_api import Browser, Page, expect
from stand_in_tasks import StandInTasks

from housefly.config.tasks import TasksConfig
from housefly.evidence.clip_index import ClipIndex
from housefly.evidence.clip_writer import ClipWriter
from housefly.web.access.users import UserBook
from housefly.web.messages.role import Role

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

PHONE_AND_DESKTOP = ((390, 844), (1440, 900))
SHEETS = ("You have control", "More", "Details")
"""What opens each sheet."""


STATES: dict[str, tuple[Callable[[Any], None], str]] = {
    "ready": (ready, "ready"),
    "flying": (flying, "holding"),
    "looking": (looking, "holding"),
    "fault": (fault, "warning"),
    "silent": (silent, "lost"),
}
"""What happens one after another, and the shape of the headline by which it shows."""


@pytest.mark.interop
async def test_axe_finds_nothing_on_the_live_scene_in_any_state(page: Page, console: Any) -> None:
    for state, (change, shape) in STATES.items():
        change(console.pilot)
        await expect(page.locator(".headline")).to_have_attribute("data-shape", shape)
        assert await axe_findings(page) == [], state


async def test_axe_finds_nothing_on_its_sheets(page: Page) -> None:
    for name in SHEETS:
        if name == "More":
            await open_orders(page)
        await page.get_by_role("button", name=name, exact=True).click()
        assert await axe_findings(page, PHONE_AND_DESKTOP) == [], name
        await page.keyboard.press("Escape")
    await page.keyboard.press("?")
    await expect(page.get_by_role("dialog")).to_be_visible()
    assert await axe_findings(page, PHONE_AND_DESKTOP) == []


async def test_axe_sees_what_is_wrong(page: Page) -> None:
    await page.evaluate("document.querySelector('.brand').append(new Image())")
    await page.evaluate("document.querySelector('.headline').style.color = '#999'")
    found = " ".join(await axe_findings(page, ((1440, 900),)))
    assert "image-alt" in found and "color-contrast" in found


async def test_axe_finds_nothing_on_tasks_clips_and_a_clip(
    serving: Any, loopback: str, tmp_path: Path, chromium: Browser
) -> None:
    index = ClipIndex(tmp_path, TasksConfig())
    row = clip(time.time() - 60.0)
    writer = ClipWriter(tmp_path / row.file_name)
    for frame in video(1.0):
        writer.add(frame)
    written = writer.finish()
    assert written is not None
    index.finish(replace(row, size=written.size, duration=written.duration))
    async with serving(loopback, clips=index) as console:
        tasks = StandInTasks(console.bus.join())
        tasks.keep_evidence(index)
        tasks.ring()
        tasks.tell()
        page = await chromium.new_page()
        await page.goto(console.link + "#tasks")
        await expect(page.get_by_role("region", name="Services")).to_be_visible()
        assert await axe_findings(page, PHONE_AND_DESKTOP) == []
        for tab in ("Clips", "Rules"):
            await page.get_by_role("tab", name=tab).click()
            await expect(page.get_by_role("tabpanel").get_by_role("listitem")).to_have_count(1)
            if tab == "Rules":
                await page.locator(".rules summary").click()
            assert await axe_findings(page, PHONE_AND_DESKTOP) == [], tab
        await page.close()


async def test_axe_finds_nothing_on_the_login_and_on_a_used_link(
    serving: Any, loopback: str, tmp_path: Path, chromium: Browser, cheap_passwords: None
) -> None:
    users = UserBook(tmp_path / "users.json")
    users.put("anna", Role.FLY, "a password of anna")
    async with serving(loopback, users=users) as console:
        page = await chromium.new_page(locale="de-DE")
        for address, words in (("/?token=used", "schon benutzt"), ("/", "Passwort")):
            await page.goto(console.origin + address)
            await expect(page.locator("main")).to_contain_text(words)
            assert await axe_findings(page, PHONE_AND_DESKTOP) == [], address
        await page.close()
