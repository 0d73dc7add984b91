"""Moving the drone by hand in real Chromium: keys, buttons, and everything that lets go."""

from __future__ import annotations

import os
from collections.abc import AsyncIterator, Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import pytest_asyncio
from fake_room import example_room
from playwright.async_api import Browser, Page, expect

from housefly.messages import DroneStatus, OrderKind, Phase

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

NUDGED = replace(example_room(), limits={**example_room().limits, "nudge_speed": 0.4})
SIZES = [(1440, 900), (1024, 768), (768, 1024), (390, 844), (844, 390)]


@pytest_asyncio.fixture(loop_scope="session")
async def console(loopback: str, serving: Callable[..., Any]) -> AsyncIterator[Any]:
    async with serving(loopback, view=NUDGED) as served:
        yield served


@pytest_asyncio.fixture(loop_scope="session")
async def page(
    console: Any, chromium: Browser, ready_page: Callable[..., Any]
) -> AsyncIterator[Page]:
    """Yield the live scene of a drone that hovers in the middle of the room."""
    async with ready_page(chromium, console) as page:
        console.pilot.position, console.pilot.height = (3.0, 1.5), 1.1
        console.pilot.status, console.pilot.phase = DroneStatus.FLYING, Phase.HOLDING
        await expect(toggle(page)).to_be_visible()
        yield page


def toggle(page: Page) -> Any:
    return page.get_by_role("switch", name="Move by hand")


def says(page: Page) -> Any:
    return page.locator(".nudge .says")


def nudges(console: Any) -> list[Any]:
    return [order for order in console.pilot.orders if order.kind is OrderKind.NUDGE]


async def is_still(page: Page, console: Any) -> None:
    """Fail unless nothing more is sent from soon on."""
    await expect(says(page)).to_contain_text("Hovering")
    await page.wait_for_timeout(200)  # what was on its way
    count = len(nudges(console))
    await page.wait_for_timeout(400)
    assert len(nudges(console)) == count


async def test_keys_move_it_while_they_are_held_and_no_longer(
    page: Page, console: Any, until: Any
) -> None:
    await page.keyboard.down("ArrowRight")
    await page.wait_for_timeout(300)
    assert nudges(console) == []  # the arrows are the map's until moving is on
    await page.keyboard.up("ArrowRight")
    await toggle(page).click()
    for key, axis, sign in (("d", 0, 1), ("w", 1, 1), ("ArrowLeft", 0, -1), ("f", 2, -1)):
        count = len(nudges(console))
        await page.keyboard.down(key)
        await until(lambda count=count: len(nudges(console)) > count + 3)
        velocity = nudges(console)[-1].velocity
        assert velocity[axis] == pytest.approx(0.4 * sign)
        assert sum(abs(part) for part in velocity) == pytest.approx(0.4)
        await expect(says(page)).to_contain_text("Moving")
        await expect(page.locator(".headline")).to_contain_text("Moved by hand by Viewer")
        await page.keyboard.up(key)
        await is_still(page, console)
    console.pilot.position = (0.8, 1.5)
    await page.keyboard.down("a")
    await expect(says(page)).to_contain_text("A wall or furniture is ahead")
    await page.keyboard.up("a")
    await toggle(page).click()
    await expect(says(page)).to_have_count(0)


LETTING_GO: dict[str, str] = {
    "blur": "window.dispatchEvent(new Event('blur'))",
    "a hidden page": (
        "Object.defineProperty(document, 'hidden', {value: true, configurable: true});"
        "document.dispatchEvent(new Event('visibilitychange'));"
        "delete document.hidden"
    ),
    "a gamepad that is gone": "window.dispatchEvent(new Event('gamepaddisconnected'))",
}


@pytest.mark.parametrize("what", LETTING_GO)
async def test_whatever_takes_the_page_away_lets_go(
    page: Page, console: Any, until: Any, what: str
) -> None:
    await toggle(page).click()
    count = len(nudges(console))
    await page.keyboard.down("d")
    await until(lambda: len(nudges(console)) > count + 1)
    await page.evaluate(LETTING_GO[what])
    await is_still(page, console)
    await page.keyboard.up("d")


async def test_a_button_is_held_and_stop_and_flights_take_the_pad_away(
    page: Page, console: Any, until: Any
) -> None:
    await toggle(page).click()
    box = await page.get_by_role("button", name="Right on the map").bounding_box()
    assert box is not None
    await page.mouse.move(box["x"] + 10, box["y"] + 10)
    await page.mouse.down()
    await until(lambda: len(nudges(console)) > 2)
    await page.mouse.move(5, 5)  # still held
    count = len(nudges(console))
    await until(lambda: len(nudges(console)) > count + 1)
    await page.mouse.up()
    await is_still(page, console)
    await page.keyboard.down("d")
    await until(lambda: len(nudges(console)) > count + 5)
    console.pilot.phase = Phase.OUTBOUND
    await expect(toggle(page)).to_have_count(0)
    count = len(nudges(console))
    console.pilot.phase = Phase.HOLDING
    await expect(toggle(page)).to_have_attribute("aria-checked", "false")
    await page.wait_for_timeout(300)
    assert len(nudges(console)) == count
    await page.keyboard.up("d")


async def test_what_the_pilot_refuses_is_sent_no_more_until_it_is_let_go(
    page: Page, console: Any, until: Any
) -> None:
    await toggle(page).click()
    await page.keyboard.down("d")
    await until(lambda: len(nudges(console)) > 1)
    console.pilot.refuse("Eve comes near: making way")
    await expect(says(page)).to_contain_text("Eve comes near: making way")
    await page.wait_for_timeout(200)
    count = len(nudges(console))
    await page.wait_for_timeout(400)
    assert len(nudges(console)) == count
    await page.keyboard.up("d")
    await expect(says(page)).to_contain_text("Hovering")
    await page.keyboard.down("d")
    await until(lambda: len(nudges(console)) > count + 1)
    await page.keyboard.up("d")


GAMEPAD = """
window.pad = {connected: true, axes: [0, 0, 0, 0], buttons: [{pressed: false}, {pressed: false}]};
navigator.getGamepads = () => [window.pad];
"""


async def test_a_gamepads_sticks_move_it_and_its_b_hovers(
    page: Page, console: Any, until: Any
) -> None:
    await page.evaluate(GAMEPAD)
    await page.evaluate("window.pad.axes[0] = 1")
    await toggle(page).click()
    await is_still(page, console)  # the stick was pushed before
    await page.evaluate("window.pad.axes[0] = 0.1")
    await page.wait_for_timeout(250)
    await page.evaluate("window.pad.axes = [0.1, -0.6, 0, 0]")
    await until(lambda: len(nudges(console)) > 2)
    assert nudges(console)[-1].velocity == pytest.approx((0.0, 0.2, 0.0))
    await page.evaluate("window.pad.buttons[1].pressed = true")
    await until(lambda: console.pilot.orders[-1].kind is OrderKind.HOVER)
    await is_still(page, console)


@pytest.mark.parametrize(
    "size", [*SIZES[3:], *(pytest.param(size, marks=pytest.mark.interop) for size in SIZES[:3])]
)
async def test_the_pad_is_on_the_screen_and_hides_neither_orders_nor_stop(
    page: Page, size: tuple[int, int]
) -> None:
    await page.set_viewport_size({"width": size[0], "height": size[1]})
    await toggle(page).click()
    await expect(says(page)).to_be_visible()
    if folder := os.environ.get("HOUSEFLY_NUDGE_SHOTS"):
        for scheme in ("light", "dark"):
            await page.emulate_media(color_scheme=scheme)
            name = f"nudge-{size[0]}x{size[1]}-{scheme}.png"
            await page.screenshot(path=Path(folder) / name)
    pad = await page.locator(".nudge").bounding_box()
    assert pad is not None
    assert pad["x"] >= 0 and pad["x"] + pad["width"] <= size[0]
    assert pad["y"] >= 0 and pad["y"] + pad["height"] <= size[1]
    for selector in (".stop", ".acts", ".top"):
        other = await page.locator(selector).first.bounding_box()
        assert other is not None
        across = pad["x"] + pad["width"] <= other["x"] or other["x"] + other["width"] <= pad["x"]
        down = pad["y"] + pad["height"] <= other["y"] or other["y"] + other["height"] <= pad["y"]
        assert across or down, selector
