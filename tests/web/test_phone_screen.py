"""The console on a phone in real Chromium: one stage, a sheet from below, and a reason once."""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable
from dataclasses import replace
from typing import Any

import pytest
import pytest_asyncio
from axe_audit import axe_findings
from fingers import swipe
from pilot_states import flying
from playwright.async_api import Browser, FloatRect, Locator, Page, ViewportSize, expect
from stand_in_tasks import StandInTasks

from housefly.geometry import Vec2
from housefly.messages import DroneStatus, Phase

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

PHONE: ViewportSize = {"width": 390, "height": 844}
PHONES: list[ViewportSize] = [
    PHONE,
    {"width": 360, "height": 640},
    {"width": 844, "height": 390},
]
MAP, PICTURE = "false", "true"
"""What has the stage, as the page tells it."""
COVERED = """(one) => { const at = one.getBoundingClientRect();
    return [0.1, 0.5, 0.9].flatMap((x) => [0.1, 0.5, 0.9].map((y) => document.elementFromPoint(
        at.x + x * at.width, at.y + y * at.height))).filter((hit) => !one.contains(hit)).length;
}"""
"""How many of nine points of an element something else lies on."""


@pytest_asyncio.fixture(loop_scope="session")
async def phone(
    console: Any, chromium: Browser, ready_page: Callable[..., Any]
) -> AsyncIterator[Page]:
    """Yield a phone with tasks; nothing moves by itself on it, as somebody may want it."""
    StandInTasks(console.bus.join()).tell()
    more = {"viewport": PHONE, "has_touch": True, "reduced_motion": "reduce"}
    async with ready_page(chromium, console, **more) as page:
        await expect(sheet(page)).to_have_attribute("data-height", "closed")
        yield page


def sheet(page: Page) -> Locator:
    return page.locator(".bottom-sheet")


async def box(one: Locator) -> FloatRect:
    found = await one.bounding_box()
    assert found is not None
    return found


async def middle(one: Locator) -> Vec2:
    at = await box(one)
    return at["x"] + at["width"] / 2, at["y"] + at["height"] / 2


async def on_stage(page: Page, shown: str) -> None:
    await expect(page.locator(".app")).to_have_attribute("data-swapped", shown)


async def drag_handle(page: Page, up: float) -> None:
    """Drag the sheet by the bar at its top, so far up [px]."""
    at = await box(page.locator(".bottom-sheet .handle"))
    await swipe(page, (at["x"] + at["width"] / 2, at["y"] + 8.0), 0.0, -up)


async def test_a_swipe_changes_between_map_and_picture_and_chooses_no_goal(phone: Page) -> None:
    switch = phone.get_by_role("group", name="On the stage")
    at = await middle(phone.locator(".plan-view"))
    await swipe(phone, at, 150.0)
    await on_stage(phone, MAP)
    await swipe(phone, at, -40.0)
    await on_stage(phone, MAP)
    await swipe(phone, at, -90.0, 90.0)
    await on_stage(phone, MAP)
    await swipe(phone, at, -150.0)
    await on_stage(phone, PICTURE)
    await expect(switch.get_by_role("button", name="Picture")).to_have_attribute(
        "aria-pressed", "true"
    )
    wide = await box(phone.locator(".view.video"))
    assert wide["width"] > 0.9 * PHONE["width"]
    await swipe(phone, await middle(phone.locator(".view.video")), 150.0)
    await on_stage(phone, MAP)
    await expect(phone.locator(".ghost")).to_have_count(0)
    await switch.get_by_role("button", name="Picture").focus()
    await phone.keyboard.press("Enter")
    await on_stage(phone, PICTURE)


async def test_one_finger_moves_a_map_that_was_brought_nearer_and_swipes_nothing(
    phone: Page,
) -> None:
    await phone.get_by_role("button", name="Zoom in").tap()
    plan = phone.locator(".plan-view")
    await expect(plan).to_have_attribute("data-zoomed", "true")
    await expect(plan).to_have_attribute("data-moving", "false")
    before = await phone.locator(".plan-view > svg").get_attribute("data-origin")
    await swipe(phone, await middle(plan), -150.0)
    await expect(phone.locator(".plan-view > svg")).not_to_have_attribute(
        "data-origin", str(before)
    )
    await on_stage(phone, MAP)


async def test_the_sheet_has_three_heights_by_its_handle_and_covers_no_order_and_never_stop(
    phone: Page, console: Any
) -> None:
    for in_flight in (False, True):
        if in_flight:
            flying(console.pilot)
            await expect(phone.locator(".stopbar")).to_have_attribute("data-whole", "true")
        for size in PHONES:
            await phone.set_viewport_size(size)
            opener = ".acts" if in_flight else ".quick"
            # Chromium makes no click of the first tap after it was given another size.
            await phone.locator(opener).get_by_role("button", name="Fly to …").click()
            await heights_keep_stop_free(phone, f"{size} {in_flight}")


async def heights_keep_stop_free(page: Page, where: str) -> None:
    await expect(sheet(page)).to_have_attribute("data-height", "half")
    await is_free(page, where)
    await drag_handle(page, 220.0)
    await expect(sheet(page)).to_have_attribute("data-height", "full")
    await is_free(page, where)
    await drag_handle(page, -0.45 * (await box(sheet(page)))["height"])
    await expect(sheet(page)).to_have_attribute("data-height", "half")
    await is_free(page, where)
    await drag_handle(page, -300.0)
    await expect(sheet(page)).to_have_attribute("data-height", "closed")
    await expect(sheet(page)).to_be_hidden()
    await is_free(page, where)


async def is_free(page: Page, where: str) -> None:
    """Check that STOP, and the orders while there are any, can be pressed everywhere."""
    for one in await page.locator(".stop, .acts > *").all():
        assert await one.evaluate(COVERED) == 0, f"{where}: {await one.inner_text()}"


async def test_a_place_is_chosen_on_the_sheet_and_it_closes_in_every_way_a_person_tries(
    phone: Page,
) -> None:
    await phone.emulate_media(reduced_motion="no-preference")
    opener = phone.locator(".quick .to-fly")
    tab = sheet(phone).get_by_role("button", name="Fly to …")
    await opener.tap()
    await expect(tab).to_be_focused()
    await phone.keyboard.press("Escape")
    await expect(sheet(phone)).to_be_hidden()
    await expect(opener).to_be_focused()
    await opener.tap()
    await expect(tab).to_be_focused()
    await phone.go_back()
    await expect(sheet(phone)).to_be_hidden()
    await opener.tap()
    await expect(tab).to_be_focused()
    plan = await box(phone.locator(".plan-view"))
    await phone.touchscreen.tap(plan["x"] + 40.0, plan["y"] + 90.0)
    await expect(sheet(phone)).to_be_hidden()
    await expect(phone.locator(".ghost")).to_have_count(0)
    await opener.tap()
    await sheet(phone).get_by_role("button", name="Entrance", exact=True).tap()
    await expect(sheet(phone)).to_be_hidden()
    await expect(phone.locator(".plan .way")).to_contain_text("Entrance")


async def test_the_tasks_are_on_the_sheet_and_no_longer_at_the_top(phone: Page) -> None:
    await expect(phone.get_by_role("navigation", name="Screens")).to_be_hidden()
    await phone.locator(".quick").get_by_role("button", name="Tasks").tap()
    await expect(sheet(phone).get_by_role("region", name="Now")).to_be_visible()
    places = [await middle(one) for one in await sheet(phone).get_by_role("button").all()]
    assert min(y for _, y in places) > 0.3 * PHONE["height"], "within the thumb's reach"
    assert await axe_findings(phone, ((390, 844), (360, 640))) == []
    for key in 3 * ["Shift+Tab"] + 12 * ["Tab"]:  # to the sheet, what is below it, and STOP
        await phone.keyboard.press(key)
        held = "document.activeElement.closest('.who, .view, .stage-switch') === null"
        assert await phone.evaluate(held)
    await sheet(phone).get_by_role("button", name="All tasks").tap()
    await expect(phone.get_by_role("region", name="Services")).to_be_visible()
    await phone.get_by_role("navigation", name="Screens").get_by_text("Live").tap()
    await expect(phone.locator(".scene")).to_be_visible()


async def test_why_it_is_not_ready_is_said_once(phone: Page, console: Any) -> None:
    first, *others = console.pilot.checks
    console.pilot.checks = (replace(first, passed=False, value="12%"), *others)
    await expect(phone.locator(".headline")).to_contain_text("the battery is too low (12%)")
    for size in PHONES:
        await phone.set_viewport_size(size)
        for opened in (False, True):
            if opened:
                await phone.locator(".quick .to-fly").click()
                await expect(sheet(phone)).to_be_visible()
            shown = await phone.locator(".app").inner_text()
            assert shown.count("the battery is too low") == 1, f"{size}: {shown}"
        await phone.keyboard.press("Escape")
    console.pilot.checks = (first, *others)


async def test_who_has_control_is_said_once_beside_the_orders(phone: Page, console: Any) -> None:
    watcher = await phone.context.new_page()
    await watcher.goto(console.origin)
    console.pilot.status, console.pilot.phase = DroneStatus.FLYING, Phase.HOLDING
    await expect(watcher.locator(".caption")).to_contain_text("Viewer 1 has control")
    shown = await watcher.locator(".dock").inner_text()
    assert shown.count("has control") == 1 and shown.count("You watch") == 1, shown
    await watcher.close()
