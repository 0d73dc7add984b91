"""The console in real Chromium: what a person sees, clicks and presses."""

from __future__ import annotations

import asyncio
import re
from collections.abc import AsyncIterator, Callable
from fractions import Fraction
from typing import Any

import av
import numpy as np
import pytest
import pytest_asyncio
from console_page import choose_place, open_details, open_orders
from plan_pixels import drawn_plan
from playwright.async_api import Browser, Page, expect

from housefly.bus.topics import DroneTopics
from housefly.clock import RealClock
from housefly.messages import DroneStatus, OrderKind, Phase, Severity, VideoFrame

TOPICS = DroneTopics()

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

Until = Callable[..., Any]
DESKTOP, PHONE = {"width": 1280, "height": 800}, {"width": 390, "height": 844}


@pytest_asyncio.fixture(loop_scope="session")
async def page(console: Any, chromium: Browser) -> AsyncIterator[Page]:
    """Yield the console, opened by its link; fails on page errors and requests to other hosts."""
    context = await chromium.new_context(viewport=DESKTOP)
    page = await context.new_page()
    troubles: list[str] = []
    page.on("pageerror", lambda error: troubles.append(str(error)))
    page.on(
        "console",
        # Chromium says itself that no hub answers here.
        lambda message: (
            troubles.append(message.text)
            if message.type == "error" and "Failed to load resource" not in message.text
            else None
        ),
    )
    page.on(
        "request",
        lambda request: (
            troubles.append(request.url) if foreign(request.url, console.origin) else None
        ),
    )
    await page.goto(console.link)
    await expect(page.locator(".headline")).to_contain_text("Your drone is home")
    yield page
    await context.close()
    assert troubles == []


def foreign(url: str, origin: str) -> bool:
    return not url.startswith((origin + "/", origin.replace("http", "ws") + "/", "data:"))


async def watcher_of(page: Page, console: Any) -> Page:
    """Open a second tab of the same browser."""
    other = await page.context.new_page()
    await other.goto(console.origin)
    await expect(other.locator(".drone")).to_be_visible()
    return other


async def hold(page: Page, selector: str, seconds: float) -> None:
    await page.locator(selector).hover()
    await page.mouse.down()
    await asyncio.sleep(seconds)
    await page.mouse.up()


async def drawer(page: Page) -> None:
    """Open what is rarely meant: take off, home, cut."""
    await open_orders(page)
    await page.get_by_role("button", name="More", exact=True).click()
    await expect(page.locator(".cut")).to_be_visible()
    await expect(page.locator(".bottom-sheet")).to_be_hidden()


def kinds(console: Any) -> list[OrderKind]:
    return [order.kind for order in console.pilot.orders]


async def click_map(page: Page, x: float, y: float) -> None:
    """Click a world point of the map."""
    await page.mouse.click(*(await drawn_plan(page)).pixel(x, y))


async def test_the_token_is_gone_from_the_address_and_a_reload_still_works(
    page: Page, console: Any
) -> None:
    assert page.url == f"{console.origin}/"
    await page.reload()
    await expect(page.locator(".headline")).to_contain_text("Your drone is home")


async def test_a_place_is_chosen_previewed_held_and_flown_to(
    page: Page, console: Any, until: Until
) -> None:
    await choose_place(page, "Entrance")
    await expect(page.locator(".ghost .tag")).to_contain_text("5.4 m")
    await expect(page.locator(".plan .way")).to_contain_text("Entrance")
    assert kinds(console) == []
    await hold(page, ".primary", 0.8)
    await until(lambda: kinds(console) == [OrderKind.SERVICE])
    assert console.pilot.orders[0].place == "entrance"
    await expect(page.locator(".headline")).to_contain_text("Flying to Entrance", timeout=10_000)
    await open_details(page)
    await expect(page.locator(".log")).to_contain_text("Service entrance by Viewer 1")


async def test_letting_go_too_early_sends_nothing(page: Page, console: Any) -> None:
    await choose_place(page, "Entrance")
    await expect(page.locator(".ghost .tag")).to_be_visible()
    await hold(page, ".primary", 0.3)
    await asyncio.sleep(0.6)
    assert kinds(console) == []


async def test_a_point_on_the_map_becomes_a_goal(page: Page, console: Any, until: Until) -> None:
    await click_map(page, 5.6, 1.4)
    await expect(page.locator(".ghost .tag")).to_be_visible()
    await hold(page, ".primary", 0.8)
    await until(lambda: kinds(console) == [OrderKind.SERVICE])
    x, y = console.pilot.orders[0].goal
    assert abs(x - 5.6) < 0.13 and abs(y - 1.4) < 0.13


async def test_a_goal_in_an_obstacle_is_moved_to_the_nearest_free_point_and_says_so(
    page: Page,
) -> None:
    await click_map(page, 3.4, 1.6)
    await expect(page.locator(".plan .why")).to_contain_text("nearest free point")
    await expect(page.locator(".ghost .asked")).to_be_visible()
    await expect(page.locator(".ghost .preview")).to_be_visible()


async def test_stop_is_one_click_at_once_and_stays_until_resume_is_held(
    page: Page, console: Any, until: Until
) -> None:
    await page.locator(".stop").click()
    await until(lambda: len(console.stops) == 1 and console.pilot.stopped)
    await expect(page.locator(".stop")).to_contain_text("STOPPED")
    await expect(page.locator(".headline")).to_contain_text("Stopped")
    await choose_place(page, "Entrance")
    await expect(page.locator(".primary")).to_have_text(re.compile("Resume"))
    await hold(page, ".resume", 0.8)
    await until(lambda: kinds(console)[-1] is OrderKind.RESUME)
    await expect(page.locator(".stop")).not_to_contain_text("STOPPED")


@pytest.mark.parametrize(
    "focus",
    [
        *("body", ".cut", ".primary"),
        *(
            pytest.param(focus, marks=pytest.mark.interop)
            for focus in (".acts .action", ".plan-view > svg", ".lately")
        ),
    ],
)
async def test_in_flight_space_stops_whatever_has_the_focus_and_presses_nothing_else(
    page: Page, console: Any, focus: str
) -> None:
    console.pilot.status, console.pilot.phase = DroneStatus.FLYING, Phase.HOLDING
    await expect(page.locator(".headline")).to_contain_text("Hovering")
    if focus == ".cut":
        await drawer(page)
    await page.locator(focus).first.focus()
    await page.keyboard.press("Space")
    await expect(page.locator(".stop")).to_contain_text("STOPPED")
    assert len(console.stops) == 1
    assert kinds(console) == [OrderKind.STOP]
    assert await page.locator(".place[aria-pressed=true]").count() == 0


async def test_a_name_half_typed_stays_when_somebody_else_opens_the_console(
    page: Page, console: Any
) -> None:
    await page.get_by_role("button", name="You have control").click()
    field = page.get_by_label("Your name")
    await field.press_sequentially("Ann")
    await watcher_of(page, console)
    await expect(page.locator(".people li")).to_have_count(2)
    await field.press_sequentially("a")
    assert await field.input_value() == "Anna"


async def test_space_types_a_space_on_the_ground_and_stops_in_flight(
    page: Page, console: Any, until: Until
) -> None:
    await page.get_by_role("button", name="You have control").click()
    field = page.get_by_label("Your name")
    await field.fill("Anna")
    await field.press("Space")
    assert await field.input_value() == "Anna "
    assert console.stops == []
    console.pilot.status, console.pilot.phase = DroneStatus.FLYING, Phase.HOLDING
    await expect(page.locator(".headline")).to_contain_text("Hovering")
    await field.press("Space")
    await until(lambda: len(console.stops) == 1)


async def test_a_watcher_sees_who_flies_and_can_still_stop(
    page: Page, console: Any, until: Until
) -> None:
    watcher = await watcher_of(page, console)
    await expect(watcher.locator(".who")).to_contain_text("Viewer 1 has control")
    await choose_place(watcher, "Entrance")
    await expect(watcher.locator(".ghost .tag")).to_be_visible()
    await expect(watcher.locator(".caption")).to_contain_text("You watch")
    await expect(watcher.locator(".caption")).to_contain_text("Viewer 1 has control")
    assert await watcher.locator(".primary").count() == 0
    console.pilot.status, console.pilot.phase = DroneStatus.FLYING, Phase.HOLDING
    await expect(watcher.locator(".headline")).to_contain_text("Hovering")
    await watcher.keyboard.press("Space")
    await until(lambda: len(console.stops) == 1)
    await watcher.locator(".stop").click()
    await until(lambda: len(console.stops) == 2)
    await expect(page.locator(".stop")).to_contain_text("STOPPED")


async def test_taking_over_in_flight_is_a_hold(page: Page, console: Any) -> None:
    watcher = await watcher_of(page, console)
    await drawer(page)
    await hold(page, "role=button[name='Take off']", 0.8)
    await expect(watcher.locator(".headline")).to_contain_text("Hovering", timeout=10_000)
    await watcher.get_by_role("button", name="Viewer 1 has control").click()
    await hold(watcher, "role=button[name='Take over']", 0.8)
    await expect(watcher.locator(".who")).to_contain_text("You have control")
    await expect(page.locator(".who")).to_contain_text("Viewer 2 has control")


async def test_the_motors_are_cut_only_by_a_hold_of_a_second(
    page: Page, console: Any, until: Until
) -> None:
    await drawer(page)
    await page.locator(".cut").click()
    await hold(page, ".cut", 0.7)
    await asyncio.sleep(0.5)
    assert kinds(console) == []
    await hold(page, ".cut", 1.2)
    await until(lambda: kinds(console) == [OrderKind.CUT])
    await expect(page.locator(".headline")).to_contain_text("Motors are cut")


@pytest.mark.interop
async def test_the_motors_are_cut_by_shift_and_escape_held_for_a_second(
    page: Page, console: Any, until: Until
) -> None:
    await page.keyboard.down("Shift")
    await page.keyboard.down("Escape")
    await asyncio.sleep(0.6)
    await page.keyboard.up("Escape")
    await asyncio.sleep(0.6)
    assert kinds(console) == []
    await page.keyboard.down("Escape")
    await until(lambda: kinds(console) == [OrderKind.CUT])
    await page.keyboard.up("Escape")
    await page.keyboard.up("Shift")


async def test_a_whole_mission_is_flown_by_keyboard_alone(
    page: Page, console: Any, until: Until
) -> None:
    for _ in range(6):
        await page.keyboard.press("ArrowRight")
    await expect(page.locator(".plan .way")).to_contain_text("Point 1.8, 1.1 m")
    await expect(page.locator(".ghost .preview")).to_be_visible()
    await page.keyboard.down("Enter")
    await until(lambda: kinds(console) == [OrderKind.SERVICE])
    await page.keyboard.up("Enter")
    await expect(page.locator(".headline")).to_contain_text(
        "Flying to the chosen point", timeout=10_000
    )
    await page.keyboard.press("h")
    await until(lambda: kinds(console)[-1] is OrderKind.HOME)
    await page.keyboard.press("l")
    await until(lambda: kinds(console)[-1] is OrderKind.LAND)
    await expect(page.locator(".headline")).to_contain_text("Your drone is home", timeout=10_000)
    await page.keyboard.press("?")
    await expect(page.get_by_role("dialog", name="Keys")).to_be_visible()
    await page.keyboard.press("Escape")
    await expect(page.get_by_role("dialog", name="Keys")).to_be_hidden()


async def test_a_place_is_chosen_and_sent_to_by_keyboard(
    page: Page, console: Any, until: Until
) -> None:
    await open_orders(page)
    await page.get_by_role("button", name="Sofa", exact=True).focus()
    await page.keyboard.press("Enter")
    await expect(page.locator(".ghost .preview")).to_be_visible()
    assert kinds(console) == []
    await page.keyboard.down("Enter")
    await until(lambda: kinds(console) == [OrderKind.SERVICE])
    await page.keyboard.up("Enter")
    assert console.pilot.orders[0].place == "sofa"


async def test_old_numbers_are_greyed_then_struck_out_and_a_banner_says_what_the_drone_does(
    page: Page, console: Any
) -> None:
    await page.get_by_role("button", name="Details", exact=True).click()
    reading = page.locator(".reading", has_text="Position")
    await expect(reading).to_have_attribute("data-age", "fresh")
    console.pilot.publishing = False
    await expect(reading).to_have_attribute("data-age", "old")
    await expect(reading).to_have_attribute("data-age", "dead", timeout=5000)
    await expect(page.locator(".banner")).to_contain_text("No word from the pilot")
    await expect(page.locator(".banner")).to_contain_text("without a pilot nothing moves it")
    console.pilot.publishing = True
    await expect(reading).to_have_attribute("data-age", "fresh")
    await expect(page.locator(".banner")).to_be_hidden()


async def test_faults_are_announced(page: Page, console: Any) -> None:
    await open_details(page)
    console.pilot.add_event(Severity.FAULT, "battery_low", "Battery is empty")
    await expect(page.locator("[role=alert].spoken")).to_have_text("Battery is empty")
    await expect(page.locator(".log [data-severity=fault]")).to_contain_text("Battery is empty")


@pytest.mark.parametrize(
    "size",
    [DESKTOP, PHONE, {"width": 640, "height": 400}],
    ids=["desktop", "phone", "desktop at 200 %"],
)
async def test_stop_and_cut_are_always_on_the_screen_and_nothing_is_too_small_to_touch(
    page: Page, size: Any
) -> None:
    await page.set_viewport_size(size)
    await drawer(page)
    stop, cut = (
        await page.locator(".stop").bounding_box(),
        await page.locator(".cut").bounding_box(),
    )
    assert stop is not None and cut is not None
    assert stop["height"] >= 56 and stop["width"] >= 88
    assert stop["y"] + stop["height"] <= size["height"] and cut["y"] >= 0
    assert cut["x"] + cut["width"] <= size["width"]
    away = max(stop["y"] - cut["y"] - cut["height"], stop["x"] - cut["x"] - cut["width"])
    assert away > 100, "STOP and the cut must lie far apart"
    # All at once: some come and go while they are counted.
    small = await page.evaluate(
        """[...document.querySelectorAll("button:not(.clear)")]
            .filter((one) => one.checkVisibility({ visibilityProperty: true }))
            .filter((one) => one.getBoundingClientRect().height < 44)
            .map((one) => one.textContent)"""
    )
    assert small == []
    overflow = await page.evaluate(
        "document.documentElement.scrollWidth - document.documentElement.clientWidth"
    )
    assert overflow <= 0, "the page must not scroll sideways"


async def test_choosing_a_goal_moves_nothing(page: Page) -> None:
    places = [
        "header",
        ".map",
        ".video",
        ".dock",
        ".stop",
        ".side",
    ]
    before = [await page.locator(place).bounding_box() for place in places]
    await choose_place(page, "Entrance")
    await expect(page.locator(".ghost .tag")).to_be_visible()
    await click_map(page, 3.4, 1.6)
    await expect(page.locator(".plan .why")).to_contain_text("nearest free point")
    assert [await page.locator(place).bounding_box() for place in places] == before


async def test_map_and_picture_swap_on_one_press(page: Page) -> None:
    async def width(selector: str) -> float:
        box = await page.locator(selector).bounding_box()
        assert box is not None
        return float(box["width"])

    assert await width(".map") > await width(".video")
    await page.keyboard.press("m")
    await expect(page.locator(".app")).to_have_attribute("data-swapped", "true")
    assert await width(".map") < await width(".video")


async def test_the_drones_pictures_move_on_the_canvas(page: Page, console: Any) -> None:
    assert await page.evaluate("'VideoDecoder' in window"), "loopback is a secure context"
    feeding = asyncio.create_task(feed(console.bus.join()))
    try:
        canvas = page.locator(".video canvas")
        await expect(canvas).to_have_attribute("data-picture", re.compile(r"\d+"), timeout=10_000)
        first = await canvas.evaluate(PIXEL)
        number = int(await canvas.get_attribute("data-picture") or 0)
        await expect(canvas).not_to_have_attribute("data-picture", str(number))
        seen = {tuple(first)}
        for _ in range(20):
            seen.add(tuple(await canvas.evaluate(PIXEL)))
            await asyncio.sleep(0.05)
        assert len(seen) > 3
        assert await canvas.evaluate("c => [c.width, c.height]") == [320, 180]
    finally:
        feeding.cancel()
    await expect(page.locator(".video .veil")).to_contain_text("No new picture", timeout=10_000)


async def test_a_browser_that_cannot_decode_video_gets_jpeg_pictures(
    page: Page, console: Any
) -> None:
    feeding = asyncio.create_task(feed(console.bus.join()))
    try:
        await page.context.add_init_script("delete window.VideoDecoder")
        await page.reload()
        picture = page.locator(".video img")
        await expect(picture).to_have_js_property("naturalWidth", 320, timeout=10_000)
        await expect(page.locator(".headline")).to_contain_text("Your drone is home")
    finally:
        feeding.cancel()


async def test_the_console_comes_back_by_itself_after_the_server_was_started_again(
    chromium: Browser, serving: Any, loopback: str
) -> None:
    context = await chromium.new_context()
    page = await context.new_page()
    async with serving(loopback) as first:
        port = first.port
        await page.goto(first.link)
        await expect(page.locator(".headline")).to_contain_text("Your drone is home")
    await expect(page.locator(".headline")).to_contain_text("No contact")
    await expect(page.locator(".banner")).to_be_visible()
    async with serving(loopback, port) as second:
        await expect(page.locator(".headline")).to_contain_text(
            "Your drone is home", timeout=10_000
        )
        await expect(page.locator(".banner")).to_be_hidden()
        await page.keyboard.press("Space")
        await expect(page.locator(".stop")).to_contain_text("STOPPED")
        assert len(second.stops) == 1
        await context.close()


PIXEL = """(canvas) => {
  const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d");
  copy.drawImage(canvas, 0, 0);
  return Array.from(copy.getImageData(160, 90, 1, 1).data);
}"""
"""A worker draws on the canvas: the page can only copy it."""


async def feed(bus: Any) -> None:
    """Publish real H.264 whose colour changes with every picture."""
    encoder = av.CodecContext.create("libx264", "w")
    encoder.width, encoder.height, encoder.pix_fmt, encoder.time_base = (
        320,
        180,
        "yuv420p",
        Fraction(1, 30),
    )
    encoder.options = {
        "preset": "ultrafast",
        "tune": "zerolatency",
        "x264-params": "keyint=15:annexb=1:repeat-headers=1",
    }
    clock = RealClock()
    for number in range(10_000):
        picture = np.full((180, 320, 3), [(number * 9) % 256, 128, 64], np.uint8)
        for packet in encoder.encode(av.VideoFrame.from_ndarray(picture, format="rgb24")):
            bus.publish(
                TOPICS.video,
                VideoFrame(bytes(packet), bool(packet.is_keyframe), 320, 180, number, clock.now()),
            )
        await asyncio.sleep(1 / 30)
