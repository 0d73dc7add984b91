"""The page of ``housefly new`` in English, Japanese and German, in real Chromium."""

from __future__ import annotations

import os
import re
from collections.abc import AsyncIterator, Callable
from pathlib import Path
from typing import Any

import pytest
import pytest_asyncio
from playwright.async_api import Browser, Page, expect
from word_templates import new_page_templates, short_name

from housefly.web.access.page_routes import STATIC_FOLDER
from housefly.web.new_site.draft_view import model_views

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

LOCALES = {"en": "en-GB", "ja": "ja-JP", "de": "de-DE"}
OTHERS = ("ja", "de")
SIZES = [(390, 844), (1440, 900)]
STEPS = ("room", "objects", "pad", "places", "zones", "tracking", "frame", "drone", "save")
SAME = {
    "Housefly",
    "English",
    "日本語",
    "Deutsch",
    "Vicon (DataStream)",
    "OptiTrack (NatNet)",
    "VRPN",
}
"""Names that are the same in each language."""
SAME_IN_GERMAN = {"Name", "System", "Port", "Sofa", "sofa"}
DRAWN = {
    "name": "lab",
    "hardware": True,
    "bounds": [0, 0, 6, 4],
    "walls": [{"start": [0, 0], "end": [6, 0]}, {"start": [2, 2], "end": [2, 4], "top": 1}],
    "furniture": [{"name": "k1", "x": 1, "y": 3, "length": 1, "width": 1, "top": 1}],
    "pad": [9, 9],
    "places": [{"name": "k2", "title": "k2", "x": 5, "y": 3, "look_at": [5, 4, 1]}],
    "zones": [{"rectangle": [3, 1, 4, 2], "reason": "k3"}],
    "tracking": {"kind": "vicon", "address": "10.0.0.5"},
    "frame_points": [
        {"name": "k4", "on_map": [1, 1, 0], "seen": [1, 1, 0]},
        {"name": "k5", "on_map": [5, 3, 0], "seen": [5, 3.4, 0]},
    ],
    "drone": {"address": "192.168.1.1"},
}
"""A room that has one of everything, so that each step has all to say; names are no words."""

SHOWN = """() => {
    const found = new Set(["placeholder", "aria-label", "title"].flatMap((name) =>
        [...document.querySelectorAll(`[${name}]`)].map((one) => one.getAttribute(name))));
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walker.nextNode())
        if (!walker.currentNode.parentElement.closest("pre, noscript"))
            found.add(walker.currentNode.textContent);
    found.add(document.title.split("·")[0]);
    return [...found].map((one) => one.trim());
}"""
"""Every text of the page, with what is said to those who do not see it."""
OVERFLOWING = """(() => [...document.querySelectorAll("button, .steps h2 span, legend, label")]
    .filter((one) => one.offsetParent !== null && one.scrollWidth > one.clientWidth + 1)
    .filter((one) => one.clientWidth > 0 && getComputedStyle(one).display !== "inline")
    .map((one) => `${one.textContent} ${one.scrollWidth}>${one.clientWidth}`)
)()"""
FULL_WIDTH = """(() => {
    if (document.documentElement.lang !== "ja") return;
    const pen = document.createElement("canvas").getContext("2d");
    pen.font = "100px " + getComputedStyle(document.body).fontFamily;
    const missing = 1 - pen.measureText("停").width / 100;
    const sheet = new CSSStyleSheet(); // buttons do not inherit it
    sheet.replaceSync(`body * { letter-spacing: ${Math.max(0, missing)}em !important; }`);
    document.adoptedStyleSheets = [sheet];
})()"""
"""Japanese signs are as wide as high; a machine without a font for them draws narrow boxes."""


@pytest_asyncio.fixture(loop_scope="session", name="speaking")
async def speaking_fixture(drawer: Any, chromium: Browser) -> AsyncIterator[Callable[[str], Any]]:
    """Yield what opens the page of a room with everything in it in a language."""
    status, told = await drawer.post("/draft", draft=DRAWN)
    assert status == 200, told
    name, _, value = drawer.cookie.partition("=")
    contexts = []

    async def speaking(language: str) -> Page:
        context = await chromium.new_context(locale=LOCALES[language])
        contexts.append(context)
        await context.add_cookies([{"name": name, "value": value, "url": drawer.origin}])
        page = await context.new_page()
        await page.goto(f"{drawer.origin}/?proof={drawer.proof}")
        await expect(page.locator("html")).to_have_attribute("lang", language)
        await expect(page.locator(".steps > li")).to_have_count(len(STEPS))
        return page

    yield speaking
    for context in contexts:
        await context.close()


async def open_step(page: Page, index: int) -> None:
    """Open a step, and the first of each list in it."""
    row = page.locator(".steps > li").nth(index)
    await row.locator("h2 button").click()
    await expect(row).to_have_attribute("data-open", "true")


async def texts_of(page: Page, index: int) -> set[str]:
    """Return the texts of a step that have words, with each of its items open in turn."""
    await open_step(page, index)
    found = set(await page.evaluate(SHOWN))
    for one in await page.locator(".steps .rows button.name").all():
        await one.click()
        found |= set(await page.evaluate(SHOWN))
    return {text for text in found if re.search(r"[^\W\d_]{2}", text)}


@pytest.mark.interop
async def test_no_text_of_the_page_is_left_untranslated(speaking: Callable[[str], Any]) -> None:
    pages = {name: await speaking(name) for name in LOCALES}
    for index, step in enumerate(STEPS):
        texts = {name: await texts_of(page, index) for name, page in pages.items()}
        assert len(texts["en"]) > 15
        known = {text for text in texts["en"] if text[:1] == "k" and text[1:].isdigit()} | SAME
        names = {DRAWN["name"], "10.0.0.5", "vicon 10.0.0.5", "192.168.1.1", "ardrone"}
        names |= {one.name for one in model_views()}
        same = {name: (texts["en"] & texts[name]) - known - names for name in OTHERS}
        assert same == {"ja": set(), "de": same["de"] & SAME_IN_GERMAN}, step


async def test_the_page_finds_every_template_of_its_server(speaking: Callable[[str], Any]) -> None:
    page = await speaking("en")
    names = sorted(map(short_name, new_page_templates()))
    assert len(names) > 250
    for name in OTHERS:
        chunk = next(STATIC_FOLDER.glob(f"new-{name}-*.js")).name
        missing = await page.evaluate(
            """async ([chunk, name, all]) => {
                const speech = (await import(chunk))[name];
                return all.filter((template) => !speech.templates[template]);
            }""",
            [f"/static/{chunk}", name.upper(), names],
        )
        assert missing == [], name


async def test_a_language_that_is_chosen_shows_at_once_and_is_kept(
    speaking: Callable[[str], Any],
) -> None:
    page = await speaking("en")
    await page.get_by_role("combobox", name="Sprache").select_option("de")
    await expect(page.get_by_role("button", name="Größe ändern")).to_be_visible()
    await page.reload()
    await expect(page.get_by_role("button", name="Größe ändern")).to_be_visible()


@pytest.mark.parametrize("name", OTHERS)
async def test_nothing_overflows(speaking: Callable[[str], Any], name: str) -> None:
    page = await speaking(name)
    for width, height in SIZES:
        await page.set_viewport_size({"width": width, "height": height})
        await page.evaluate(FULL_WIDTH)
        for index, step in enumerate(STEPS):
            await open_step(page, index)
            assert await page.evaluate(OVERFLOWING) == [], f"{step} {width}x{height}"
            if folder := os.environ.get("HOUSEFLY_NEW_SHOTS"):
                await page.screenshot(path=Path(folder) / f"{name}-{step}-{width}.png")
