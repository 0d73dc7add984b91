"""The map that two fingers turn: every pixel still is its point of the room."""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable
from math import cos, dist, pi, sin
from pathlib import Path
from typing import Any

import fingers
import pytest
import pytest_asyncio
from client_module import called
from console_page import open_earlier
from hypothesis import given
from hypothesis import strategies as st
from plan_pixels import drawn_plan
from playwright.async_api import Browser, Locator, Page, ViewportSize, expect

from housefly.geometry import Vec2

PHONE: ViewportSize = {"width": 390, "height": 844}
STEPS = 12
CORNERS = ((0.0, 0.0), (7.5, 0.0), (0.0, 4.0), (7.5, 4.0))
"""Of the fake pilot's room [m]."""
SOURCES = ("map/projection", "map/camera")

_metres = st.floats(-50.0, 50.0)
_points = st.tuples(_metres, _metres)
_angles = st.floats(-2 * pi, 2 * pi)
_pixels = st.tuples(st.floats(0.0, 390.0), st.floats(0.0, 600.0))
_TURNED = """
const [scale, point, pixel, angle, p, q] = values;
const to = module.turned(module.placed(scale, 390, 600, point, pixel), angle);
return [to.at(p), to.at(q), to.back(to.at(p))];
"""
_WHOLE = """
const [width, height, angle] = values;
const bounds = module.turnedBounds([0, 0, width, height], angle);
const to = module.turned(module.fit(bounds, 390, 600, 14), angle);
return [[0, 0], [width, 0], [0, height], [width, height]].map((corner) => to.at(corner));
"""
_AIMED = """
const [angle, point, pixel] = values;
const bounds = module.turnedBounds([0, 0, 40, 40], angle);
const sight = { bounds, whole: module.fit(bounds, 390, 600, 14) };
const camera = module.aimed(8, module.rotated(point, angle), pixel, sight);
return module.turned(module.seenBy(camera, sight), angle).at(point);
"""


def test_the_inverse_of_a_turned_map_is_exact_and_nothing_is_mirrored(tmp_path: Path) -> None:
    with called(SOURCES, _TURNED, tmp_path) as project:

        @given(st.floats(1.0, 800.0), _points, _pixels, _angles, _points)
        def holds(scale: float, anchor: Vec2, pixel: Vec2, angle: float, p: Vec2) -> None:
            east = (p[0] + 1.0, p[1])
            at, at_east, back = project(scale, anchor, pixel, angle, p, east)
            assert back == pytest.approx(p, abs=1e-9)
            right, down = at_east[0] - at[0], at_east[1] - at[1]
            assert right == pytest.approx(scale * cos(angle), abs=1e-6)
            assert down == pytest.approx(-scale * sin(angle), abs=1e-6)
            north = project(scale, anchor, pixel, angle, p, (p[0], p[1] + 1.0))[1]
            assert north[0] - at[0] == pytest.approx(down, abs=1e-6)
            assert north[1] - at[1] == pytest.approx(-right, abs=1e-6)

        holds()


def test_the_whole_room_is_on_the_screen_however_it_is_turned(tmp_path: Path) -> None:
    with called(SOURCES, _WHOLE, tmp_path) as corners:

        @given(st.floats(1.0, 40.0), st.floats(1.0, 40.0), _angles)
        def holds(width: float, height: float, angle: float) -> None:
            for u, v in corners(width, height, angle):
                assert 13.9 <= u <= 376.1 and 13.9 <= v <= 586.1

        holds()


def test_a_point_stays_under_the_fingers_that_turn_the_map(tmp_path: Path) -> None:
    with called(SOURCES, _AIMED, tmp_path) as seen:
        inner = st.floats(15.0, 25.0)

        @given(_angles, st.tuples(inner, inner), _pixels)
        def holds(angle: float, point: Vec2, pixel: Vec2) -> None:
            assert seen(angle, point, pixel) == pytest.approx(pixel, abs=1e-6)

        holds()


@pytest_asyncio.fixture(loop_scope="session")
async def phone(
    console: Any, chromium: Browser, ready_page: Callable[..., Any]
) -> AsyncIterator[Page]:
    more = {"viewport": PHONE, "has_touch": True, "reduced_motion": "reduce"}
    async with ready_page(chromium, console, **more) as page:
        await expect(page.locator(".bottom-sheet")).to_have_attribute("data-height", "closed")
        yield page


async def twist(page: Page, middle: Vec2, angle: float) -> None:
    """Turn two fingers about a pixel, counterclockwise [rad]."""
    frames: list[list[Vec2]] = []
    for k in range(STEPS + 1):
        right, up = 60.0 * cos(k * angle / STEPS), 60.0 * sin(k * angle / STEPS)
        frames.append([(middle[0] - right, middle[1] + up), (middle[0] + right, middle[1] - up)])
    await fingers.touch(page, *frames)
    await expect(page.locator(".plan-view")).to_have_attribute("data-moving", "false")


def way_back(page: Page) -> Locator:
    return page.get_by_role("button", name="Turn the map back")


@pytest.mark.browser
@pytest.mark.asyncio(loop_scope="session")
async def test_two_fingers_turn_the_map_a_tap_is_still_its_goal_and_one_press_turns_it_back(
    phone: Page, console: Any, until: Callable[..., Any]
) -> None:
    straight = await drawn_plan(phone)
    middle = straight.pixel(3.75, 2.0)
    await twist(phone, middle, 0.1)
    assert (await drawn_plan(phone)).angle == 0.0, "a pinch that turns a little turns nothing"
    await expect(way_back(phone)).to_have_count(0)
    await twist(phone, middle, pi / 2)
    turned = await drawn_plan(phone)
    assert 0.9 < turned.angle < pi / 2
    plan = await phone.locator(".plan-view").bounding_box()
    inset = await phone.locator(".view.video").bounding_box()
    assert plan is not None and inset is not None
    for corner in CORNERS:
        x, y = turned.pixel(*corner)
        assert plan["x"] < x < plan["x"] + plan["width"], "all of the room is on the screen"
        assert inset["y"] + inset["height"] - 8.0 < y < plan["y"] + plan["height"]
    await expect(way_back(phone)).to_be_visible()
    upright = await phone.evaluate(
        """() => [...document.querySelectorAll(".plan-view text")].every((one) => {
            const { b, c } = one.getScreenCTM(); return b === 0 && c === 0; })"""
    )
    assert upright, "words stay upright"
    await tap(phone, turned.pixel(5.37, 1.21), phone.locator(".ghost .tag"))
    go = phone.locator(".acts .primary")
    await go.hover()
    await phone.mouse.down()
    await until(lambda: console.pilot.orders)
    await phone.mouse.up()
    assert dist(console.pilot.orders[0].goal, (5.37, 1.21)) < 0.02
    await way_back(phone).tap()
    await expect(way_back(phone)).to_have_count(0)
    assert (await drawn_plan(phone)).angle == 0.0


async def tap(page: Page, place: Vec2, seen: Locator) -> None:
    """Tap a place until something is seen: a busy machine makes a long press of a tap."""
    for _ in range(3):
        await page.touchscreen.tap(*place)
        try:
            return await expect(seen).to_have_count(1, timeout=2000)
        except AssertionError:
            continue
    await expect(seen).to_have_count(1)


@pytest.mark.browser
@pytest.mark.asyncio(loop_scope="session")
async def test_the_past_is_turned_as_now_and_the_room_that_is_edited_is_not(phone: Page) -> None:
    middle = (await drawn_plan(phone)).pixel(3.75, 2.0)
    await twist(phone, middle, -1.0)
    turned = (await drawn_plan(phone)).angle
    assert turned < -0.5
    await open_earlier(phone)
    assert (await drawn_plan(phone)).angle == turned
    await phone.keyboard.press("r")
    await expect(phone.locator(".edits")).to_have_count(1)
    assert (await drawn_plan(phone)).angle == 0.0
