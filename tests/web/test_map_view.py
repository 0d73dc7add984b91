"""The map under a hand, in real Chromium: nearer, moved, and a goal where it was tapped."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from pathlib import Path as FilePath
from typing import Any

import fingers
import pytest
import pytest_asyncio
from console_page import open_earlier
from plan_pixels import PLAN, drawn_plan
from playwright.async_api import Browser, Locator, Page, ViewportSize, expect

from housefly.app.views import room_view
from housefly.bus.topics import DroneTopics
from housefly.geometry import Vec2
from housefly.messages import (
    DroneStatus,
    OrderKind,
    Path,
    Phase,
    PlannedTrajectory,
    TrajectoryPoint,
)
from housefly.room.bsen import bsen
from housefly.room.edit_versions import EditVersions
from housefly.sites.loaded_site import open_site, read_site
from housefly.web.api.edit_service import EditService

TOPICS = DroneTopics()

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

Until = Callable[..., Any]
FIVE_SIZES = [(390, 844), (844, 390), (768, 1024), (1024, 768), (1440, 900)]
PHONES = FIVE_SIZES[:2]
DESKTOP: ViewportSize = {"width": 1440, "height": 900}
PHONE: ViewportSize = {"width": 390, "height": 844}
ROOM = (7.5, 4.0)
"""The fake pilot's room [m]."""


async def laid_out(page: Page) -> None:
    """Wait for the last line under the map: no hub answers here."""
    await expect(page.locator(".map .legend")).to_contain_text("People and things are not shown")
    drawn = 0.0
    while drawn != (drawn := await scale(page)):
        await asyncio.sleep(0.5)


@pytest_asyncio.fixture(loop_scope="session")
async def page(
    console: Any, chromium: Browser, ready_page: Callable[..., Any]
) -> AsyncIterator[Page]:
    async with ready_page(chromium, console, viewport=DESKTOP) as page:
        await laid_out(page)
        yield page


@pytest_asyncio.fixture(loop_scope="session")
async def phone(
    console: Any, chromium: Browser, ready_page: Callable[..., Any]
) -> AsyncIterator[Page]:
    async with ready_page(chromium, console, viewport=PHONE, has_touch=True) as page:
        await laid_out(page)
        yield page


@pytest_asyncio.fixture(loop_scope="session")
async def edited(
    serving: Any, chromium: Browser, loopback: str, tmp_path: FilePath
) -> AsyncIterator[Page]:
    """Yield a phone with the room being edited."""
    loaded = open_site(read_site("bsen"))
    edits = EditService(bsen, loaded.site, EditVersions(tmp_path / "edits"))
    async with serving(loopback, edits=edits, view=room_view(loaded)) as console:
        context = await chromium.new_context(viewport=PHONE, has_touch=True)
        page = await context.new_page()
        await page.goto(console.link + "#edit")
        await expect(page.locator(".edits .spot-mark").first).to_be_visible()
        yield page
        await context.close()


async def scale(page: Page) -> float:
    """Return how large the room is drawn [px/m]."""
    return (await drawn_plan(page)).scale


async def pixel(page: Page, x: float, y: float) -> Vec2:
    """Return where a point of the room [m] is on the screen."""
    return (await drawn_plan(page)).pixel(x, y)


async def wheel(page: Page, at: Vec2, steps: int) -> None:
    """Turn the wheel over a pixel, towards the screen for steps above 0."""
    await page.mouse.move(*at)
    for _ in range(abs(steps)):
        await page.mouse.wheel(0, -120 if steps > 0 else 120)
    await settled(page)


async def settled(page: Page) -> None:
    """Wait until hands have been heard, which is once a frame, and the map stands still."""
    await page.evaluate(
        "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
    )
    await expect(page.locator(".plan-view")).to_have_attribute("data-moving", "false")


async def drag(page: Page, a: Vec2, b: Vec2) -> None:
    await page.mouse.move(*a)
    await page.mouse.down()
    await page.mouse.move(*b, steps=5)
    await page.mouse.up()
    await settled(page)


async def touch(page: Page, *frames: list[Vec2]) -> None:
    """Let fingers move the map, and wait until it stands still."""
    await fingers.touch(page, *frames)
    await settled(page)


async def pinch(page: Page, middle: Vec2, before: float, after: float) -> None:
    """Move two fingers from one distance to another [px]."""
    x, y = middle
    apart = [before + (after - before) * k / 8 for k in range(9)]
    await touch(page, *([(x - d / 2, y), (x + d / 2, y)] for d in apart))


async def send(page: Page) -> None:
    """Hold what sends the drone to the goal."""
    await page.locator(".primary").hover()
    await page.mouse.down()
    await asyncio.sleep(0.8)
    await page.mouse.up()


def no_goal(page: Page) -> Any:
    return expect(page.locator(".ghost")).to_have_count(0)


async def test_a_goal_at_four_times_is_flown_to_where_it_was_tapped(
    page: Page, console: Any, until: Until
) -> None:
    whole = await scale(page)
    await wheel(page, await pixel(page, 5.6, 1.4), 6)
    assert await scale(page) > 4.0 * whole
    # Moved too: what is under the pointer then is neither of the first picture nor of the second.
    await drag(page, await pixel(page, 5.6, 1.4), await pixel(page, 5.35, 1.52))
    await page.mouse.click(*await pixel(page, 5.93, 1.27))
    await expect(page.locator(".ghost .tag")).to_be_visible()
    await send(page)
    await until(lambda: [one.kind for one in console.pilot.orders] == [OrderKind.SERVICE])
    x, y = console.pilot.orders[0].goal
    assert abs(x - 5.93) < 0.012 and abs(y - 1.27) < 0.012


async def test_a_point_under_the_wheel_stays_where_it_is(page: Page) -> None:
    await wheel(page, await pixel(page, 4.6, 1.7), 4)
    before = await pixel(page, 4.6, 1.7)
    await wheel(page, before, 3)
    after = await pixel(page, 4.6, 1.7)
    assert abs(after[0] - before[0]) < 1.0 and abs(after[1] - before[1]) < 1.0


async def test_a_drag_moves_the_map_and_is_never_a_goal(page: Page) -> None:
    a, b = await pixel(page, 4.0, 1.2), await pixel(page, 5.0, 1.4)
    await drag(page, a, b)
    await no_goal(page)
    await wheel(page, await pixel(page, 4.5, 1.2), 5)
    a = await pixel(page, 4.5, 1.2)
    await drag(page, a, (a[0] - 90.0, a[1] - 40.0))
    await no_goal(page)
    after = await pixel(page, 4.5, 1.2)
    assert after[0] == pytest.approx(a[0] - 90.0, abs=1.0)
    assert after[1] == pytest.approx(a[1] - 40.0, abs=1.0)


@pytest.mark.interop
async def test_the_map_is_no_farther_than_the_room_no_nearer_than_eight_times_and_keeps_the_room(
    page: Page,
) -> None:
    whole, middle = await scale(page), await pixel(page, 3.75, 2.0)
    await wheel(page, middle, -5)
    assert await scale(page) == pytest.approx(whole)
    await wheel(page, middle, 14)
    assert await scale(page) == pytest.approx(8.0 * whole)
    for right, down in ((1, 0), (-1, 0), (0, 1), (0, -1)):
        near = middle[0] - 150.0 * right, middle[1] - 150.0 * down
        far = middle[0] + 350.0 * right, middle[1] + 150.0 * down
        for _ in range(10 if right else 7):
            await drag(page, near, far)
        box = await page.locator(PLAN).bounding_box()
        assert box is not None
        left, foot = await pixel(page, 0.0, 0.0)
        end, top = await pixel(page, *ROOM)
        assert left <= box["x"] + 57 and end >= box["x"] + box["width"] - 57, (right, down)
        assert top <= box["y"] + 57 and foot >= box["y"] + box["height"] - 57, (right, down)


async def test_the_whole_room_is_one_press_away_and_only_when_it_is_not_shown(page: Page) -> None:
    whole, button = await scale(page), page.get_by_role("button", name="Whole room")
    await expect(button).to_have_count(0)
    await page.get_by_role("button", name="Zoom in").click()
    await settled(page)
    assert await scale(page) == pytest.approx(1.6 * whole)
    await button.press("Enter")
    await expect(button).to_have_count(0)
    await settled(page)
    assert await scale(page) == pytest.approx(whole)
    await expect(page.locator(PLAN)).to_be_focused()


@pytest.mark.interop
async def test_keys_bring_the_map_nearer_when_it_has_the_focus_and_arrows_stay_the_goals(
    page: Page,
) -> None:
    whole = await scale(page)
    await page.keyboard.press("+")
    assert await scale(page) == whole, "the map has no focus"
    await page.locator(PLAN).focus()
    for key, times in (("+", 1.6), ("+", 2.56), ("-", 1.6), ("0", 1.0)):
        await page.keyboard.press(key)
        await settled(page)
        assert await scale(page) == pytest.approx(times * whole), key
    await page.keyboard.press("ArrowRight")
    await expect(page.locator(".ghost")).to_be_visible()


@pytest.mark.interop
async def test_in_the_past_arrows_move_the_map_and_no_tap_is_a_goal(page: Page) -> None:
    await open_earlier(page)
    await page.get_by_role("slider", name="Time shown").fill("-60")
    await expect(page.locator(".past-banner")).to_be_visible()
    await wheel(page, await pixel(page, 3.75, 2.0), 5)
    before = await pixel(page, 3.75, 2.0)
    await page.locator(PLAN).focus()
    await page.keyboard.press("ArrowRight")
    await settled(page)
    after = await pixel(page, 3.75, 2.0)
    assert after[0] < before[0] - 50.0
    await page.mouse.click(*after)
    await no_goal(page)
    await expect(page.locator(".past-banner")).to_be_visible()


@pytest.mark.parametrize("motion", ["reduce", "no-preference"])
async def test_the_map_jumps_for_those_who_want_no_motion(page: Page, motion: Any) -> None:
    await page.emulate_media(reduced_motion=motion)
    pictures = await page.evaluate(
        """async () => {
          const plan = document.querySelector(".plan-view > svg");
          const seen = new Set();
          const watch = new MutationObserver(() => seen.add(plan.dataset.scale));
          watch.observe(plan, { attributes: true });
          document.querySelector(".zoom button").click();
          const moves = () => document.querySelector(".plan-view").dataset.moving === "true";
          do await new Promise(requestAnimationFrame); while (moves());
          return seen.size;
        }"""
    )
    assert pictures == 1 if motion == "reduce" else pictures > 1


@pytest.mark.interop
async def test_a_drone_out_of_view_has_an_arrow_at_the_edge_that_brings_it_back(
    page: Page, console: Any
) -> None:
    arrow = page.get_by_role("button", name="The drone is out of view")
    await expect(arrow).to_have_count(0)
    x, y = console.pilot.position
    await wheel(page, await pixel(page, 6.4, 3.0), 6)
    spot, plan = await arrow.bounding_box(), await page.locator(PLAN).bounding_box()
    assert spot is not None and plan is not None
    assert spot["x"] < plan["x"] + 60, "the drone is to the left"
    near = await scale(page)
    await arrow.click()
    await expect(arrow).to_have_count(0)
    await settled(page)
    u, v = await pixel(page, x, y)
    assert plan["x"] < u < plan["x"] + plan["width"]
    assert plan["y"] < v < plan["y"] + plan["height"]
    assert await scale(page) == pytest.approx(near)


async def tap(page: Page, place: tuple[float, float], seen: Locator, count: int = 1) -> None:
    """Tap a place until so many are seen: a busy machine makes a long press of a tap."""
    for _ in range(3):
        await page.touchscreen.tap(*place)
        try:
            return await expect(seen).to_have_count(count, timeout=2000)
        except AssertionError:
            continue
    await expect(seen).to_have_count(count)


async def test_two_fingers_bring_the_map_nearer_one_moves_it_and_a_tap_is_a_goal(
    phone: Page, console: Any, until: Until
) -> None:
    whole = await scale(phone)
    await pinch(phone, await pixel(phone, 5.2, 1.2), 40.0, 100.0)
    middle = await pixel(phone, 5.2, 1.2)
    await pinch(phone, middle, 100.0, 160.0)
    assert await scale(phone) == pytest.approx(4.0 * whole, rel=0.02)
    after = await pixel(phone, 5.2, 1.2)
    assert abs(after[0] - middle[0]) < 2.0 and abs(after[1] - middle[1]) < 2.0
    await no_goal(phone)
    x, y = after
    await touch(phone, [(x, y)], [(x - 20, y - 5)], [(x - 60, y - 10)])
    moved = await pixel(phone, 5.2, 1.2)
    assert moved[0] == pytest.approx(x - 60.0, abs=1.5)
    assert moved[1] == pytest.approx(y - 10.0, abs=1.5)
    await no_goal(phone)
    await tap(phone, await pixel(phone, 5.37, 1.21), phone.locator(".ghost .tag"))
    await send(phone)
    await until(lambda: console.pilot.orders)
    goal = console.pilot.orders[0].goal
    assert abs(goal[0] - 5.37) < 0.012 and abs(goal[1] - 1.21) < 0.012
    await pinch(phone, await pixel(phone, 5.2, 1.2), 200.0, 20.0)
    assert await scale(phone) == pytest.approx(whole)


async def test_two_fingers_draw_nothing_where_one_draws(edited: Page) -> None:
    page = edited
    marks = page.locator(".edits .spot-mark, .edits .zone")
    count, whole = await marks.count(), await scale(page)
    await pinch(page, await pixel(page, 6.0, 4.25), 40.0, 160.0)
    assert await scale(page) == pytest.approx(4.0 * whole, rel=0.02)
    assert await marks.count() == count
    await tap(page, await pixel(page, 6.1, 4.3), marks, count + 1)
    new = page.locator(".edits .spot-mark[data-open=true] circle")
    u, v = [float(await new.get_attribute(name) or 0) for name in ("cx", "cy")]
    box, (x, y) = await page.locator(PLAN).bounding_box(), await pixel(page, 6.1, 4.3)
    assert box is not None
    # What is edited is kept to 5 cm.
    assert max(abs(box["x"] + u - x), abs(box["y"] + v - y)) < 0.03 * await scale(page)


async def fly(console: Any) -> None:
    """Let the drone fly a curve in space."""
    way = tuple((1.0 + 0.25 * k, 1.0 + 0.05 * k) for k in range(17))
    points = tuple(
        TrajectoryPoint((*place, 1.0 + 0.02 * k), 0.8 * k, 0.5 * min(k, 16 - k) / 8)
        for k, place in enumerate(way)
    )
    console.pilot.path, console.pilot.position, console.pilot.height = (
        Path(way, 4.1, 0.4),
        way[5],
        1.1,
    )
    console.bus.publish(TOPICS.trajectory, PlannedTrajectory(0.0, points))
    console.pilot.status, console.pilot.phase = DroneStatus.FLYING, Phase.HOLDING


SCROLLS = """(() => { const one = document.scrollingElement;
    return Math.max(0, one.scrollWidth - one.clientWidth, one.scrollHeight - one.clientHeight);
})()"""


async def inside(page: Page, selector: str, width: int, height: int) -> None:
    box = await page.locator(selector).first.bounding_box()
    assert box is not None, f"{selector} {width}x{height}"
    assert box["x"] >= 0 and box["x"] + box["width"] <= width, f"{selector} {width}x{height}"
    assert box["y"] >= 0 and box["y"] + box["height"] <= height, f"{selector} {width}x{height}"


async def test_nothing_scrolls_and_height_zoom_and_time_are_on_the_screen_at_five_sizes(
    page: Page, console: Any
) -> None:
    await fly(console)
    await expect(page.locator(".curve .speed").first).to_be_visible()
    await open_earlier(page)
    for width, height in FIVE_SIZES:
        await page.set_viewport_size({"width": width, "height": height})
        for one in (".profile .hull", ".zoom button >> nth=0", ".zoom button >> nth=1"):
            await inside(page, one, width, height)
        await inside(page, ".time-bar .now", width, height)
        await inside(page, ".time-bar select", width, height)
        await wheel(page, await pixel(page, 3.0, 2.0), 3)
        await inside(page, ".whole-room", width, height)
        assert await page.evaluate(SCROLLS) == 0, f"{width}x{height}"
        await wheel(page, await pixel(page, 3.0, 2.0), -5)


@pytest.mark.parametrize(("width", "height"), PHONES)
async def test_a_phone_shows_how_high_the_drone_is_with_a_curve_and_without(
    page: Page, console: Any, width: int, height: int
) -> None:
    await page.set_viewport_size({"width": width, "height": height})
    await expect(page.locator(".profile .value")).to_have_text("0.00 m")
    await expect(page.locator(".profile svg")).to_have_attribute(
        "aria-label", "height 0.0 m, no curve is flown"
    )
    await fly(console)
    await expect(page.locator(".profile .speed").first).to_be_visible()
    await expect(page.locator(".profile .value")).to_have_text("1.10 m")
    strip, picture = [
        await page.locator(one).bounding_box() for one in (".profile .chart", ".view.video")
    ]
    assert strip is not None and picture is not None
    apart = strip["x"] + strip["width"] <= picture["x"] + 1 or strip["y"] > picture["y"]
    assert apart, "the picture does not lie over it"
    assert strip["width"] > 90 and strip["height"] >= 40


@pytest.mark.parametrize(("width", "height"), PHONES)
async def test_the_time_bar_of_a_phone_reaches_back_and_its_words_are_whole(
    page: Page, width: int, height: int
) -> None:
    await page.set_viewport_size({"width": width, "height": height})
    await open_earlier(page)
    reach = page.get_by_label("How far back")
    for name in ("10 min", "1 week"):
        await reach.select_option(name)
        room, words = await reach.evaluate(
            """(one, name) => {
              const look = getComputedStyle(one);
              const pen = document.createElement("canvas").getContext("2d");
              pen.font = look.font;
              const inside = one.clientWidth - 2 * parseFloat(look.paddingLeft);
              return [inside, pen.measureText(name).width];
            }""",
            name,
        )
        assert room >= words, name
    await page.get_by_role("slider", name="Time shown").fill("-604")
    await expect(page.locator(".past-banner")).to_be_visible()
    await page.locator(".time-bar").get_by_role("button", name="Back to live").click()
    await expect(page.locator(".past-banner")).to_have_count(0)


async def test_no_button_lies_over_the_whole_room_on_a_desktop(page: Page) -> None:
    floor = await page.locator(".room .floor").bounding_box()
    assert floor is not None
    for one in (".turns .to-space", ".map > .layers summary", ".zoom"):
        box = await page.locator(one).bounding_box()
        assert box is not None
        beside = box["x"] >= floor["x"] + floor["width"] or box["x"] + box["width"] <= floor["x"]
        assert beside or box["y"] + box["height"] <= floor["y"], one
