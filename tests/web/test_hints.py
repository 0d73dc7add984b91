"""The first steps in real Chromium: once, out of the way, and never while anything flies."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from typing import Any

import pytest
import pytest_asyncio
from axe_audit import axe_findings
from console_page import choose_place, open_orders
from playwright.async_api import Browser, Page, expect

from housefly.messages import DroneStatus, Phase
from housefly.web.access.page_routes import STATIC_FOLDER

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

SIZES = [(390, 844), (844, 390), (768, 1024), (1440, 900)]
FIRST_TIME = "localStorage.getItem('housefly hints') ?? localStorage.setItem('housefly hints', '')"
"""A browser that a program drives is not shown around unless it says so."""
WORDS = ("Ask for anything", "hold the large button", "STOP stops at once")


@pytest_asyncio.fixture(loop_scope="session")
async def page(console: Any, chromium: Browser) -> AsyncIterator[Page]:
    """Yield the console as somebody sees it for the first time."""
    context = await chromium.new_context()
    await context.add_init_script(FIRST_TIME)
    page = await context.new_page()
    await page.goto(console.link)
    await expect(page.locator(".headline")).to_contain_text("Your drone is home")
    yield page
    await context.close()


async def seen(page: Page) -> bool:
    return bool(await page.evaluate("localStorage.getItem('housefly hints') === 'seen'"))


async def settled(page: Page, found: str, tries: int = 60) -> Any:
    """Return what a look at the page finds, at the latest when the page had time to draw."""
    while (value := await page.evaluate(found)) and tries > 0:
        tries -= 1
        await asyncio.sleep(0.05)
    return value


async def test_three_hints_are_shown_one_after_another_and_never_again(page: Page) -> None:
    hint = page.locator(".hint")
    for words in WORDS:
        await expect(hint).to_contain_text(words)
        await hint.get_by_role("button", name="OK").click()
    await expect(hint).to_have_count(0)
    assert await seen(page)
    await page.reload()
    await expect(page.locator(".headline")).to_contain_text("Your drone is home")
    await expect(page.locator(".to-fly")).to_be_visible()
    await expect(hint).to_have_count(0)


async def test_one_press_or_escape_closes_them_all(page: Page) -> None:
    hint = page.locator(".hint")
    await expect(hint).to_contain_text(WORDS[0])
    await page.keyboard.press("Escape")
    await expect(hint).to_have_count(0)
    await page.keyboard.press("?")
    await page.get_by_role("button", name="Show the first steps again").click()
    await expect(hint).to_contain_text(WORDS[0])
    await hint.get_by_role("button", name="Close the hints").click()
    await expect(hint).to_have_count(0)
    assert await seen(page)


async def test_no_hint_lies_over_a_button_a_place_or_stop_at_any_size(page: Page) -> None:
    hint = page.locator(".hint")
    await expect(hint).to_contain_text(WORDS[0])
    assert await axe_findings(page, ((390, 844),)) == []
    await page.emulate_media(color_scheme=None, reduced_motion=None)
    for words in WORDS:
        await expect(hint).to_contain_text(words)
        for width, height in SIZES:
            await page.set_viewport_size({"width": width, "height": height})
            where = f"{words} {width}x{height}"
            assert await settled(page, COVERED) == [], where
            assert await page.evaluate(IS_ON_SCREEN), where
        await hint.get_by_role("button", name="OK").click()


IS_ON_SCREEN = """(() => {
    const { left, right, top, bottom } = document.querySelector(".hint").getBoundingClientRect();
    return left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight;
})()"""
COVERED = """(() => {
    const hint = document.querySelector(".hint");
    const own = hint.getBoundingClientRect();
    if (own.right > innerWidth || own.bottom > innerHeight) return ["the edge"];
    return [...document.querySelectorAll("button, input, a, .stopbar")]
        .filter((one) => !hint.contains(one))
        .map((one) => [one, one.getBoundingClientRect()])
        .filter(([_, at]) => at.width > 1 && at.left < own.right - 1 && at.right > own.left + 1 &&
            at.top < own.bottom - 1 && at.bottom > own.top + 1)
        .filter(([one]) => one.checkVisibility({ visibilityProperty: true }))
        .map(([one]) => one.className + " " + one.textContent);
})()"""


async def test_who_ignores_them_chooses_a_place_and_flies(page: Page, console: Any) -> None:
    hint = page.locator(".hint")
    await expect(hint).to_contain_text(WORDS[0])
    await choose_place(page, "Entrance")
    await expect(hint).to_contain_text(WORDS[1])
    button = page.locator(".acts > :first-child")
    await expect(button).to_have_attribute("aria-disabled", "false")
    await button.focus()
    await page.keyboard.down("Enter")
    await expect(page.locator(".app")).to_have_attribute("data-flying", "true")
    await page.keyboard.up("Enter")
    await expect(hint).to_have_count(0)
    assert await seen(page)


async def test_no_hint_shows_in_flight_in_a_fault_or_after_stop(page: Page, console: Any) -> None:
    hint = page.locator(".hint")
    await expect(hint).to_contain_text(WORDS[0])
    console.pilot.status = DroneStatus.EMERGENCY
    await expect(hint).to_have_count(0)
    console.pilot.status = DroneStatus.LANDED
    await expect(hint).to_have_count(1)
    await page.locator(".stop").click()
    await expect(hint).to_have_count(0)
    assert not await seen(page)


async def test_a_hint_that_waits_does_not_come_up_in_flight(page: Page, console: Any) -> None:
    await expect(page.locator(".hint")).to_contain_text(WORDS[0])
    console.pilot.status, console.pilot.phase = DroneStatus.FLYING, Phase.HOLDING
    await expect(page.locator(".headline")).to_contain_text("Hovering")
    await expect(page.locator(".hint")).to_have_count(0)


async def test_a_watcher_is_shown_around_only_when_it_asks(page: Page, console: Any) -> None:
    watcher = await page.context.new_page()
    await watcher.goto(console.origin)
    await open_orders(watcher)
    await expect(watcher.locator(".caption")).to_be_visible()
    await watcher.keyboard.press("Escape")
    await expect(page.locator(".hint")).to_have_count(1)
    await expect(watcher.locator(".hint")).to_have_count(0)
    await watcher.keyboard.press("?")
    await watcher.get_by_role("button", name="Show the first steps again").click()
    await expect(watcher.locator(".hint")).to_contain_text(WORDS[0])
    assert await watcher.evaluate(COVERED) == []


async def test_the_hints_are_not_in_the_first_load() -> None:
    scripts = {file: file.read_text(encoding="utf-8") for file in STATIC_FOLDER.glob("*.js")}
    hinting = {file.name for file, text in scripts.items() if "hold the large button" in text}
    english = {name for name in hinting if not name.startswith(("chunk-de-", "chunk-ja-"))}
    assert len(english) == 1 and english.pop().startswith("chunk-later-")
