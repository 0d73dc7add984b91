"""Whether the drone may take off, as people read it in real Chromium before it does."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from typing import Any

import pytest
import pytest_asyncio
from console_page import open_orders
from playwright.async_api import Browser, FloatRect, Page, expect

from housefly.config.limits import LimitsConfig
from housefly.messages import (
    DroneStatus,
    Estimate,
    OrderKind,
    PreflightCheck,
    Severity,
    Telemetry,
)
from housefly.pilot.behavior.mission import VehicleStatus
from housefly.pilot.behavior.preflight import PreflightInputs, preflight
from housefly.pilot.estimation.consistency import TrackingConsistency

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

SIZES = [(1440, 900), (1024, 768), (768, 1024), (390, 844), (844, 390)]
DEAF = "the ultrasound sensor is deaf"


def checks(
    battery: float = 0.9, *, sees_people: bool = True, is_tracked: bool = True
) -> tuple[PreflightCheck, ...]:
    """Return what the pilot's own checks find of a drone that stands on its pad."""
    place = Estimate(10.0, (1.0, 1.0, 0.05), (0.0, 0.0, 0.0), 0.0, 0.02, 0.001)
    vehicle = VehicleStatus(
        now=10.0,
        status=DroneStatus.LANDED,
        battery=battery,
        telemetry_age=0.0,
        estimate=place if is_tracked else None,
        landing_forced=False,
        telemetry=Telemetry(10.0, DroneStatus.LANDED, battery),
        consistency=TrackingConsistency(height_error=0.0),
    )
    return preflight(PreflightInputs(vehicle, LimitsConfig(), sees_people=sees_people))


@pytest_asyncio.fixture(loop_scope="session")
async def page(console: Any, chromium: Browser) -> AsyncIterator[Page]:
    """Yield the console on a phone; fails on errors of the page."""
    context = await chromium.new_context(viewport={"width": 390, "height": 844})
    page = await context.new_page()
    troubles: list[str] = []
    page.on("pageerror", lambda error: troubles.append(str(error)))
    await page.goto(console.link)
    await expect(line(page)).to_contain_text("Ready")
    yield page
    await context.close()
    assert troubles == []


def line(page: Page) -> Any:
    return page.locator(".readiness")


async def box(page: Page, selector: str) -> FloatRect:
    found = await page.locator(selector).bounding_box()
    assert found is not None, f"{selector} is not on the page"
    return found


def lie_apart(one: FloatRect, other: FloatRect) -> bool:
    """Return whether one box is above another, or left of it."""
    above = one["y"] + one["height"] <= other["y"]
    return above or one["x"] + one["width"] <= other["x"]


ORDERS = (".command", ".acts")


async def hold_take_off(page: Page) -> None:
    if await page.locator(".drawer").count() == 0:
        await open_orders(page)
        await page.get_by_role("button", name="More", exact=True).click()
    await page.locator("role=button[name='Take off']").hover()
    await page.mouse.down()
    await asyncio.sleep(0.9)
    await page.mouse.up()


async def test_a_low_battery_is_told_and_refuses_the_take_off_until_it_is_mended(
    page: Page, console: Any, until: Any
) -> None:
    console.pilot.checks = checks(battery=0.12)
    await expect(line(page)).to_contain_text("Not ready: the battery is too low (12%)")
    await expect(page.locator(".headline")).to_contain_text("Not ready")
    await hold_take_off(page)
    await expect(page.locator(".said")).to_contain_text("Not ready: the battery is too low (12%)")
    assert console.pilot.orders == []
    console.pilot.checks = checks()
    await expect(page.locator(".headline")).to_contain_text("Your drone is home")
    await expect(page.locator(".said")).to_have_count(0)
    await hold_take_off(page)
    await until(lambda: [one.kind for one in console.pilot.orders] == [OrderKind.TAKE_OFF])


async def test_a_press_that_does_nothing_says_why(page: Page) -> None:
    await open_orders(page)
    await page.get_by_role("button", name="Land").click(force=True)
    await expect(page.locator(".said")).to_have_text("The drone is on the ground.")
    await expect(page.locator(".resume")).to_have_count(0)


async def test_the_line_unfolds_to_all_checks_what_is_wrong_first_and_never_covers_stop(
    page: Page, console: Any
) -> None:
    found = console.pilot.checks = checks(is_tracked=False)
    wrong = next(one for one in found if one.code == "tracking")
    await expect(line(page)).to_contain_text("Not ready: tracking does not see the drone (never)")
    await page.locator(".readiness button").click()
    rows = page.locator(".checks li")
    await expect(rows).to_have_count(len(found))
    for words in (wrong.fault, wrong.value, wrong.limit, wrong.why, wrong.mend):
        await expect(rows.first).to_contain_text(words)
    for width, height in SIZES:
        await page.set_viewport_size({"width": width, "height": height})
        sheet, stop = await box(page, ".checks"), await box(page, ".stop")
        assert lie_apart(sheet, stop), f"{width}x{height}"
        assert sheet["x"] >= 0 and sheet["x"] + sheet["width"] <= width
    await page.keyboard.press("Escape")
    await expect(rows).to_have_count(0)


@pytest.mark.interop
async def test_that_people_are_not_seen_is_said_on_every_screen_to_everybody(
    page: Page, console: Any
) -> None:
    console.pilot.checks = checks(sees_people=False)
    watcher = await page.context.new_page()
    await watcher.goto(console.origin)
    await expect(watcher.locator(".who")).to_contain_text("Viewer 1 has")
    for viewer in (page, watcher):
        for screen in ("", "#tasks"):
            await viewer.goto(f"{console.origin}/{screen}")
            await viewer.reload()
            note = line(viewer).get_by_text("people without markers are unseen (no sensor)")
            for width, height in SIZES:
                await viewer.set_viewport_size({"width": width, "height": height})
                await expect(note).to_be_in_viewport(ratio=1)
                where, stop = await note.bounding_box(), await box(viewer, ".stop")
                assert where is not None and lie_apart(where, stop)
                assert where["x"] + where["width"] <= width


async def test_notes_of_the_drone_are_shown_on_the_ground_and_in_flight(
    page: Page, console: Any
) -> None:
    await page.set_viewport_size({"width": 1280, "height": 800})
    console.pilot.notes = (DEAF,)
    await expect(line(page)).to_contain_text(DEAF)
    console.pilot.status = DroneStatus.FLYING
    await expect(line(page)).to_contain_text("In flight")
    await expect(line(page)).to_contain_text(DEAF)
    assert await page.get_by_text(DEAF).count() == 1


async def test_a_take_off_moves_none_of_the_orders_under_the_finger(
    page: Page, console: Any
) -> None:
    for width, height in ((390, 844), (1280, 800)):
        console.pilot.status = DroneStatus.LANDED
        await page.set_viewport_size({"width": width, "height": height})
        await expect(line(page)).to_contain_text("Ready")
        if await page.locator(".acts").count() == 0:
            await open_orders(page)
        before, at_rest = [await box(page, one) for one in ORDERS], await box(page, ".stop")
        console.pilot.status = DroneStatus.FLYING
        await expect(page.locator(".stopbar")).to_have_attribute("data-whole", "true")
        assert [await box(page, one) for one in ORDERS] == before
        stop = await box(page, ".stop")
        assert stop["y"] == at_rest["y"] and stop["width"] > 1.5 * at_rest["width"]
        assert stop["x"] < at_rest["x"], "it grows over where it was"
        assert before[1]["y"] + before[1]["height"] <= stop["y"], "all orders are on the screen"


async def test_what_the_pilot_refuses_is_told_beside_the_buttons(page: Page, console: Any) -> None:
    await open_orders(page)
    text = "service sofa refused: the charge is not enough for the way"
    console.pilot.add_event(Severity.WARNING, "order_refused", text)
    await expect(page.locator(".plan .why")).to_have_text(f"{text.capitalize()}.")
