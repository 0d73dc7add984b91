"""The page in English, Japanese and German, in real Chromium: all is said, and all of it fits."""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable
from typing import Any

import pytest
import pytest_asyncio
from pilot_states import fault, flying, silent
from playwright.async_api import Browser, Page, expect
from told_sentences import told_sentences
from word_templates import short_name

from housefly.messages.words import Words, parts_of
from housefly.web.access.page_routes import STATIC_FOLDER

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

OTHERS = ("ja", "de")
SIZES = [(390, 844), (844, 390), (1440, 900)]
LOCALES = {"en": "en-GB", "ja": "ja-JP", "de": "de-DE"}
READY = {"en": "Your drone is home", "ja": "ホームで待機", "de": "Die Drohne ist zu Hause"}
STOP_WORDS = {"en": "hover at once", "ja": "停止", "de": "Halt"}


def chunk_of(name: str) -> str:
    return next(STATIC_FOLDER.glob(f"chunk-{name}-*.js")).name


async def opened(
    chromium: Browser, console: Any, name: str, ready: str = "", **options: Any
) -> Page:
    """Open the console with a browser of that language."""
    context = await chromium.new_context(locale=LOCALES[name], **options)
    page = await context.new_page()
    await page.goto(console.link)
    await expect(page.locator(".headline")).to_contain_text(ready or READY[name])
    return page


@pytest_asyncio.fixture(loop_scope="session", name="speaking")
async def speaking_fixture(console: Any, chromium: Browser) -> AsyncIterator[Callable[..., Any]]:
    """Yield what opens the console in a language; its pages end with the test."""
    pages: list[Page] = []

    async def speaking(name: str, **options: Any) -> Page:
        pages.append(await opened(chromium, console, name, **options))
        return pages[-1]

    yield speaking
    for page in pages:
        await page.context.close()


def away(pilot: Any) -> None:
    pilot.position = (4.2, 3.3)


STATES: dict[str, tuple[Callable[[Any], None], str]] = {
    "away": (away, "warning"),
    "flying": (flying, "holding"),
    "stopped": (flying, "stopped"),
    "fault": (fault, "warning"),
    "silent": (silent, "lost"),
}
"""What happens one after another, and the shape of the headline by which it shows."""

FULL_WIDTH = """(() => {
    if (document.documentElement.lang !== "ja") return;
    const pen = document.createElement("canvas").getContext("2d");
    pen.font = "100px " + getComputedStyle(document.body).fontFamily;
    const missing = 1 - pen.measureText("停").width / 100;
    for (const one of document.querySelectorAll("body *"))
        if (one.style) one.style.letterSpacing = `${Math.max(0, missing)}em`;
})()"""
"""Japanese signs are as wide as high; a machine without a font for them draws narrow boxes."""
OVERFLOWING = """(() => [...document.querySelectorAll(
    "button, .headline, .headline .words, .banner, .said-only, .stop .words")]
    .filter((one) => one.offsetParent !== null || one.closest(".stopbar"))
    .filter((one) => one.scrollWidth > one.clientWidth + 1 && one.clientWidth > 0)
    .map((one) => `${one.className}: ${one.textContent} ${one.scrollWidth}>${one.clientWidth}`)
)()"""


async def test_every_sentence_of_the_server_has_a_template(speaking: Callable[..., Any]) -> None:
    page = await speaking("en")
    told = told_sentences()
    assert len(told) > 300
    parts = {part for words in told for part in parts_of(words)}
    sentences = {one.template for one in parts if isinstance(one, Words) and one.template}
    for name in OTHERS:
        missing = await page.evaluate(
            """async ([chunk, name, all]) => {
                const speech = (await import(chunk))[name];
                return all.filter((template) => !speech.templates[template]);
            }""",
            [f"/static/{chunk_of(name)}", name.upper(), sorted(map(short_name, sentences))],
        )
        assert missing == [], name


@pytest.mark.parametrize("name", LOCALES)
async def test_the_page_speaks_the_language_of_the_browser(
    speaking: Callable[..., Any], name: str
) -> None:
    page = await speaking(name)
    assert await page.evaluate("document.documentElement.lang") == name
    await expect(page.locator(".stop .words")).to_contain_text(STOP_WORDS[name])
    await expect(page.locator(".stop strong")).to_contain_text("STOP")


async def test_a_language_that_is_chosen_shows_at_once_and_is_kept_on_the_device(
    speaking: Callable[..., Any],
) -> None:
    page = await speaking("en")
    await page.keyboard.press("?")
    await page.get_by_role("combobox", name="Sprache").select_option("de")
    await expect(page.locator(".headline")).to_contain_text(READY["de"])
    await expect(page.get_by_role("dialog")).to_contain_text("Leertaste")
    await page.reload()
    await expect(page.locator(".headline")).to_contain_text(READY["de"])
    assert await page.evaluate("document.documentElement.lang") == "de"


async def test_a_language_is_fetched_only_when_it_is_spoken(speaking: Callable[..., Any]) -> None:
    page = await speaking("en")
    loaded = "performance.getEntriesByType('resource').map((one) => one.name).join()"
    names = await page.evaluate(loaded)
    assert "app.js" in names and not any(chunk_of(one) in names for one in OTHERS)


async def test_a_sentence_without_a_template_is_shown_in_english_and_marked_so(
    console: Any, speaking: Callable[..., Any]
) -> None:
    page = await speaking("ja")
    console.pilot.link_notes = ("quite unheard of",)
    note = page.locator(".readiness .known")
    await expect(note).to_contain_text("quite unheard of")
    assert await note.get_attribute("lang") == "en"
    headline = page.locator(".headline strong")
    assert await headline.get_attribute("lang") is None


async def test_german_has_a_decimal_comma_and_metres_stay_metres(
    console: Any, speaking: Callable[..., Any]
) -> None:
    page = await speaking("de")
    console.pilot.position = (4.2, 3.3)
    await expect(page.locator(".headline .detail")).to_contain_text("3,9 m vom Landeplatz")


@pytest.mark.parametrize(
    "name",
    ["de", *(pytest.param(name, marks=pytest.mark.interop) for name in LOCALES if name != "de")],
)
async def test_no_button_headline_or_banner_overflows(
    console: Any, speaking: Callable[..., Any], name: str
) -> None:
    page = await speaking(name)
    for state, (change, shape) in STATES.items():
        change(console.pilot)
        if state == "stopped":
            await page.locator(".stop").click()
        await expect(page.locator(".headline")).to_have_attribute("data-shape", shape)
        for width, height in SIZES:
            await page.set_viewport_size({"width": width, "height": height})
            await page.evaluate(FULL_WIDTH)
            found = await page.evaluate(OVERFLOWING)
            assert found == [], f"{name} {state} {width}x{height}"
