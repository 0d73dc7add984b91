"""The live scene at every size in real Chromium: orders and STOP are on the screen, in one page."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from console_page import open_orders
from pilot_states import fault, flying, looking, ready, silent
from playwright.async_api import Browser, FloatRect, Page, expect

from housefly.config.drone import DroneConfig
from housefly.messages import OrderKind, Phase

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

FIVE_SIZES = [(390, 844), (844, 390), (768, 1024), (1280, 800), (1440, 900)]
AT_200_PERCENT = [(640, 400), (720, 450), (384, 512)]
"""What a laptop, a larger one and a tablet have left at 200 % zoom."""
ORDERS = (".acts > :first-child", ".acts .action >> nth=0", ".acts .action >> nth=1")
RESTING = (".ask-line", ".to-fly")
"""On the ground one asks; orders come with a goal, or when they are opened."""
VIEWS = (".view.map", ".view.video")


STATES: dict[str, tuple[Callable[[Any], None], str]] = {
    "ready": (ready, "ready"),
    "flying": (flying, "holding"),
    "looking": (looking, "holding"),
    "fault": (fault, "warning"),
    "silent": (silent, "lost"),
}
"""What happens, and the shape of the headline by which it shows."""


async def box(page: Page, selector: str) -> FloatRect:
    found = await page.locator(selector).first.bounding_box()
    assert found is not None, f"{selector} is not on the page"
    return found


def is_within(one: FloatRect, width: int, height: int) -> bool:
    across = one["x"] >= 0 and one["x"] + one["width"] <= width
    return across and one["y"] >= 0 and one["y"] + one["height"] <= height


def cover(one: FloatRect, other: FloatRect) -> bool:
    """Return whether two boxes lie over each other, by more than their edges."""
    across = min(one["x"] + one["width"], other["x"] + other["width"]) - max(one["x"], other["x"])
    down = min(one["y"] + one["height"], other["y"] + other["height"]) - max(one["y"], other["y"])
    return across > 1 and down > 1


@pytest.mark.parametrize(
    "state",
    [
        *("ready", "flying", "fault", "silent"),
        pytest.param("looking", marks=pytest.mark.interop),
    ],
)
async def test_orders_and_stop_are_on_the_screen_at_every_size(
    page: Page, console: Any, state: str
) -> None:
    change, shape = STATES[state]
    change(console.pilot)
    await expect(page.locator(".headline")).to_have_attribute("data-shape", shape)
    for width, height in FIVE_SIZES + AT_200_PERCENT:
        where = f"{state} {width}x{height}"
        await page.set_viewport_size({"width": width, "height": height})
        stop = await box(page, ".stop")
        assert is_within(stop, width, height), where
        least = 88 if state in ("ready", "fault") else 0.9 * width
        assert stop["width"] >= least and stop["height"] >= 56, where
        for one in RESTING if state == "ready" else ORDERS:
            order = await box(page, one)
            assert is_within(order, width, height) and order["height"] >= 44, f"{where} {one}"
            assert not cover(order, stop), f"{where} {one}"
        for one in VIEWS:
            view = await box(page, one)
            assert is_within(view, width, height) and view["height"] >= 20, f"{where} {one}"
            assert not cover(view, stop), f"{where} {one}"
        assert await page.evaluate(SCROLLED) == 0, f"{where} must not scroll"


SCROLLED = """(() => { const one = document.scrollingElement;
    return Math.max(0, one.scrollWidth - one.clientWidth, one.scrollHeight - one.clientHeight);
})()"""


async def test_a_cut_is_red_says_that_it_falls_and_lies_far_from_stop_at_every_size(
    page: Page,
) -> None:
    await open_orders(page)
    await page.get_by_role("button", name="More", exact=True).click()
    cut = page.locator(".cut")
    for width, height in FIVE_SIZES + AT_200_PERCENT:
        await page.set_viewport_size({"width": width, "height": height})
        where, stop = await box(page, ".cut"), await box(page, ".stop")
        assert is_within(where, width, height), f"{width}x{height}"
        await expect(cut.get_by_text("falls")).to_be_visible()
        away = max(
            stop["y"] - where["y"] - where["height"], stop["x"] - where["x"] - where["width"]
        )
        assert away > 90, f"{width}x{height}"
    red, green, blue = await cut.evaluate(
        "one => getComputedStyle(one).borderTopColor.match(/[0-9]+/g).map(Number)"
    )
    assert red > 2 * max(green, blue)


async def test_the_picture_takes_the_stage_while_the_drone_looks_and_gives_it_back(
    page: Page, console: Any
) -> None:
    app = page.locator(".app")
    await expect(app).to_have_attribute("data-swapped", "false")
    looking(console.pilot)
    await expect(app).to_have_attribute("data-swapped", "true")
    picture, plan = await box(page, ".view.video"), await box(page, ".view.map")
    assert picture["width"] > 2 * plan["width"]
    console.pilot.phase = Phase.RETURNING
    await expect(app).to_have_attribute("data-swapped", "false")


async def test_whoever_watches_reads_it_in_large_and_has_stop_and_land(
    page: Page, console: Any, until: Callable[..., Any]
) -> None:
    flying(console.pilot)
    watcher = await page.context.new_page()
    await watcher.goto(console.origin)
    await expect(watcher.locator(".caption")).to_contain_text("You watch.")
    orders = watcher.get_by_role("region", name="Orders")
    assert await orders.locator(".acts [aria-disabled=true]").count() == 0, "nothing is greyed"
    await orders.get_by_role("button", name="Land").click()
    await until(lambda: [one.kind for one in console.pilot.orders] == [OrderKind.LAND])
    await watcher.close()


async def test_without_a_drone_there_is_a_map_no_order_and_the_way_to_add_one_at_every_size(
    chromium: Browser, serving: Callable[..., Any], loopback: str
) -> None:
    async with serving(loopback, drone=DroneConfig(enabled=False)) as console:
        page = await (await chromium.new_context()).new_page()
        await page.goto(console.link)
        await expect(page.locator(".headline")).to_contain_text("Watching the room")
        for width, height in FIVE_SIZES + AT_200_PERCENT:
            where = f"{width}x{height}"
            await page.set_viewport_size({"width": width, "height": height})
            for one in (".view.map", ".no-drone"):
                shown = await box(page, one)
                assert is_within(shown, width, height) and shown["height"] >= 40, f"{where} {one}"
            assert await page.evaluate(SCROLLED) == 0, f"{where} must not scroll"
        for one in (".stop", ".command", ".view.video", ".readiness", ".control"):
            await expect(page.locator(one)).to_have_count(0)
        await expect(page.locator(".no-drone")).to_contain_text("[drone]")
        await page.keyboard.press("Space")
        assert console.stops == []
        await page.context.close()
