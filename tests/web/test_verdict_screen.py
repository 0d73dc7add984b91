"""What the console says in a fault, in real Chromium: only what is known, at every size."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import AsyncIterator, Callable
from dataclasses import replace
from typing import Any
from urllib.parse import urlsplit

import pytest
import pytest_asyncio
from console_page import choose_place, open_orders
from playwright.async_api import Browser, Page, expect

from housefly.messages import DroneStatus, OrderKind, Phase

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

Until = Callable[..., Any]
SIZES = [(390, 844), (844, 390), (768, 1024), (1280, 800), (1920, 1080)]
SCREENS = ("Live", "Tasks")


@pytest_asyncio.fixture(loop_scope="session")
async def page(
    console: Any, chromium: Browser, ready_page: Callable[..., Any]
) -> AsyncIterator[Page]:
    """Yield the console on a laptop; fails on errors of the page."""
    async with ready_page(chromium, console, viewport={"width": 1280, "height": 800}) as page:
        yield page


def fly(console: Any) -> None:
    console.pilot.status, console.pilot.phase = DroneStatus.FLYING, Phase.HOLDING


async def hold(page: Page, name: str) -> None:
    await page.get_by_role("button", name=name).hover()
    await page.mouse.down()
    await asyncio.sleep(0.9)
    await page.mouse.up()


async def more(page: Page) -> None:
    await open_orders(page)
    await page.get_by_role("button", name="More", exact=True).click()


async def screen(page: Page, name: str) -> None:
    await page.get_by_role("navigation").get_by_role("button", name=name).click()


async def test_a_drone_that_is_not_well_on_its_pad_is_not_said_to_be(
    page: Page, console: Any
) -> None:
    line = page.locator(".headline")
    console.pilot.pose_age = 9.8
    await expect(line).to_contain_text("Not ready")
    await expect(line).to_contain_text("tracking saw the drone last 10 s ago")
    await expect(page.locator(".drone")).to_have_attribute("data-age", "dead")
    await expect(page.locator(".drone .age")).to_contain_text("seen 9.8 s ago")
    console.pilot.pose_age, console.pilot.position = 0.02, (6.4, 1.0)
    await expect(line).to_contain_text("Not on the pad")
    await expect(line).to_contain_text("5.4 m from the pad")
    await expect(page.locator(".drone .age")).to_have_count(0)
    console.pilot.position = (3.4, 2.0)
    await expect(line).to_contain_text("under, on or in table")
    await more(page)
    await hold(page, "Take off")
    await expect(page.locator(".said")).to_contain_text("Not ready")
    assert console.pilot.orders == []
    console.pilot.position = (1.0, 1.0)
    await expect(line).to_contain_text("Your drone is home")


async def test_the_reason_of_a_fault_is_on_the_screen_at_every_size(
    page: Page, console: Any
) -> None:
    console.pilot.checks = (
        replace(console.pilot.checks[0], passed=False, value="12%"),
        *console.pilot.checks[1:],
    )
    reason = page.locator(".headline .detail")
    await expect(reason).to_have_text("the battery is too low (12%)")
    for name in SCREENS:
        await screen(page, name)
        for width, height in SIZES:
            await page.set_viewport_size({"width": width, "height": height})
            await expect(reason).to_be_in_viewport(ratio=1)
            clipped = await reason.evaluate("e => e.scrollWidth > e.clientWidth + 1")
            assert not clipped, f"{name} {width}x{height}"
        await page.set_viewport_size({"width": 1280, "height": 800})


async def test_a_tap_on_what_must_be_held_says_so_at_the_button(page: Page, console: Any) -> None:
    await more(page)
    button = page.get_by_role("button", name="Take off")
    await button.click()
    said = page.locator(".said")
    await expect(said).to_contain_text("Hold it for 0.6 s")
    where, at = await said.bounding_box(), await button.bounding_box()
    assert where is not None and at is not None
    assert where["x"] >= at["x"] + at["width"], "over no order"
    assert console.pilot.orders == []


async def test_what_ends_a_hold_is_told_although_it_is_over_at_once(
    page: Page, console: Any
) -> None:
    await more(page)
    button, said = page.get_by_role("button", name="Take off"), page.locator(".said")
    await button.hover()
    await page.mouse.down()
    console.pilot.pose_age = 9.8
    await expect(page.locator(".headline")).to_contain_text("Not ready")
    console.pilot.pose_age = 0.02
    await expect(page.locator(".headline")).to_contain_text("Your drone is home")
    await page.mouse.up()
    await expect(said).to_contain_text("Not ready")
    assert console.pilot.orders == []


async def test_a_refusal_comes_back_to_the_button_that_was_held_and_stays_until_it_is_read(
    page: Page, console: Any, until: Until
) -> None:
    await choose_place(page, "Sofa")
    await expect(page.locator(".ghost .preview")).to_be_visible()
    await hold(page, "and come back")
    await until(lambda: len(console.pilot.orders) == 1)
    console.pilot.refuse("too near")
    said, button = page.locator(".said"), page.locator(".primary")
    await expect(said).to_contain_text("Too near.")
    where, at = await said.bounding_box(), await button.bounding_box()
    assert where is not None and at is not None
    assert where["x"] >= at["x"] + at["width"] and abs(where["y"] - at["y"]) < 60, "beside it"
    for name in SCREENS:
        await screen(page, name)
        await expect(said).to_contain_text("Too near")
        bar, box = await page.locator(".stop").bounding_box(), await said.bounding_box()
        assert bar is not None and box is not None and box["y"] + box["height"] <= bar["y"]
    await said.get_by_role("button", name="OK").click()
    await expect(said).to_have_count(0)


async def test_stop_says_on_every_screen_whether_it_was_confirmed(
    page: Page, console: Any, until: Until
) -> None:
    fly(console)
    await expect(page.locator(".headline")).to_contain_text("Hovering")
    stop = page.locator(".stop")
    console.pilot.publishing = False
    await expect(page.locator(".banner")).to_contain_text("No word from the pilot")
    console.pilot.stopped = False
    await stop.click()
    await expect(stop).to_have_attribute("data-progress", "sent")
    await expect(stop).to_have_attribute("data-progress", "failed")
    for name in SCREENS:
        await screen(page, name)
        await expect(stop).to_contain_text("STOP FAILED")
        await expect(stop).to_contain_text("has not confirmed it")
    console.pilot.publishing = True
    await expect(stop).to_contain_text("STOPPED")
    for name in SCREENS:
        await screen(page, name)
        await expect(page.get_by_role("button", name="Resume")).to_be_visible()
    await hold(page, "Resume")
    await expect(stop).to_have_attribute("data-progress", "none")
    assert not console.pilot.stopped


async def test_a_stop_stays_latched_although_the_pilot_was_started_again(
    page: Page, console: Any, until: Until
) -> None:
    fly(console)
    await expect(page.locator(".headline")).to_contain_text("Hovering")
    await page.keyboard.press("Space")
    await expect(page.locator(".stop")).to_contain_text("STOPPED")
    console.pilot.stopped, console.pilot.sequence = False, 0  # another pilot, which knows nothing
    await until(lambda: len(console.stops) >= 2 and console.pilot.stopped)
    await expect(page.locator(".stop")).to_contain_text("STOPPED")
    await expect(page.locator(".headline")).to_contain_text("Stopped")


@pytest.mark.interop
async def test_a_page_that_stood_still_is_told_that_it_lost_control(page: Page) -> None:
    await page.evaluate("{ const until = Date.now() + 4500; while (Date.now() < until); }")
    said = page.locator(".said")
    await expect(said).to_contain_text("This page was silent and lost control")
    await expect(page.locator(".who")).to_contain_text("Nobody has control")
    await open_orders(page)
    await page.locator(".acts").get_by_role("button", name="Take control").click()
    await expect(page.locator(".who")).to_contain_text("You have control")
    await expect(said).to_have_count(0)  # of then


@pytest.mark.interop
async def test_a_watcher_that_is_left_alone_does_not_get_control_by_chance(
    page: Page, console: Any
) -> None:
    watcher = await page.context.new_page()
    await watcher.goto(console.origin)
    await expect(watcher.locator(".who")).to_contain_text("Viewer 1 has control")
    await page.close()
    await expect(watcher.locator(".who")).to_contain_text("Nobody has control", timeout=10_000)
    await watcher.reload()
    await expect(watcher.locator(".headline")).to_contain_text("Your drone is home")
    await expect(watcher.locator(".who")).to_contain_text("Nobody has control")


async def test_on_the_ground_space_presses_the_button_that_has_the_focus(
    page: Page, console: Any
) -> None:
    for name in reversed(SCREENS):
        button = page.get_by_role("navigation").get_by_role("button", name=name)
        await button.focus()
        await page.keyboard.press("Space")
        await expect(button).to_have_attribute("aria-current", "page")
    await page.get_by_role("button", name="Keys").focus()
    await page.keyboard.press("Space")
    await expect(page.get_by_role("dialog", name="Keys")).to_be_visible()
    assert console.stops == []


async def test_single_letters_can_be_switched_off_and_stop_can_not(
    page: Page, console: Any, until: Until
) -> None:
    await page.keyboard.press("?")
    await page.get_by_role("checkbox", name="Letters and ? are keys").uncheck()
    await page.reload()
    await expect(page.locator(".headline")).to_contain_text("Your drone is home")
    for key in ("m", "r", "?"):
        await page.keyboard.press(key)
    await expect(page.locator(".app")).to_have_attribute("data-swapped", "false")
    await expect(page.locator(".scene")).to_be_visible()
    await expect(page.get_by_role("dialog", name="Keys")).to_be_hidden()
    await page.keyboard.press("Space")
    await until(lambda: console.stops)


async def test_from_where_it_landed_away_the_large_button_flies_home(
    page: Page, console: Any, until: Until
) -> None:
    console.pilot.position = (6.4, 1.0)
    await expect(page.locator(".headline")).to_contain_text("Not on the pad")
    large = page.locator(".acts > :first-child")
    await expect(large).to_contain_text("Fly home")
    await page.keyboard.press("h")  # a key that is not held starts nothing
    await expect(page.locator(".said")).to_contain_text("on the ground")
    await page.evaluate(REMEMBER)
    await hold(page, "Fly home")
    order = await until(lambda: console.pilot.orders and console.pilot.orders[-1])
    assert (order.kind, order.place, order.look_s) == (OrderKind.SERVICE, "home", 0.0)
    await expect(page.locator(".headline")).to_contain_text("Your drone is home", timeout=30_000)
    assert "Not ready" not in await page.evaluate("window.told"), "nothing flashes after a landing"


REMEMBER = """() => {
    window.told = "";
    const look = () => ["acts", "readiness", "headline"]
        .forEach((one) => (window.told += document.querySelector("." + one)?.textContent));
    new MutationObserver(look)
        .observe(document.body, {subtree: true, childList: true, characterData: true});
}"""


async def test_what_is_written_on_a_button_is_in_its_name(page: Page) -> None:
    for name in SCREENS:
        await screen(page, name)
        assert await page.evaluate(MISNAMED) == []


MISNAMED = """[...document.querySelectorAll('button[aria-label]')]
    .filter(one => !one.ariaLabel.toLowerCase().includes(one.innerText.trim().toLowerCase()))
    .filter(one => /[a-z]{2}/i.test(one.innerText)).map(one => one.ariaLabel)"""


async def test_a_page_without_its_server_says_what_held_and_no_more(
    chromium: Browser, serving: Any, loopback: str
) -> None:
    context = await chromium.new_context(viewport={"width": 390, "height": 844})
    page = await context.new_page()
    async with serving(loopback) as served:
        await page.goto(served.link)
        await expect(page.locator(".headline")).to_contain_text("Your drone is home")
        await choose_place(page, "Entrance")
        await hold(page, "and come back")
        await expect(page.locator(".headline")).to_contain_text("Flying to", timeout=10_000)
    banner = page.locator(".banner")
    await expect(banner).to_contain_text("No word from the server for")
    await expect(banner).to_contain_text("What held then: it flies on to Entrance, then comes home")
    await expect(page.locator(".headline")).to_contain_text("No contact with the server")
    stop = page.locator(".stop")
    await stop.click()
    await expect(stop).to_contain_text("STOP FAILED")
    await expect(stop).to_contain_text("did not arrive: no contact with the server")
    assert OrderKind.STOP not in [one.kind for one in served.pilot.orders]
    with socket.create_server((loopback, urlsplit(served.link).port or 0)):
        # the launcher keeps the port of a server that died: who connects waits
        await stop.click()
        await expect(stop).not_to_contain_text("FAILED")
        await expect(stop).to_contain_text("did not arrive: no contact with the server")
    await context.close()
