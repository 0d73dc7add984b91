"""The page of ``housefly new`` in real Chromium: a room drawn from nothing, and the site of it."""

from __future__ import annotations

from collections.abc import AsyncIterator
from typing import Any

import pytest
import pytest_asyncio
from plan_pixels import drawn_plan
from playwright.async_api import Browser, FilePayload, Page, ViewportSize, expect

from housefly.app.doctor import check_machine
from housefly.app.new_site.answers import BODY_HEIGHT
from housefly.room.draft.files import load_draft
from housefly.room.draft.model import SiteDraft
from housefly.sites.loaded_site import load_site

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

DESKTOP: ViewportSize = {"width": 1280, "height": 800}
PHONE: ViewportSize = {"width": 390, "height": 844}
Point = tuple[float, float]


@pytest_asyncio.fixture(loop_scope="session")
async def page(page_of_nothing: Any, chromium: Browser) -> AsyncIterator[Page]:
    """Yield the page of an empty folder; fails on any error of the page."""
    context = await chromium.new_context(viewport=DESKTOP)
    page = await context.new_page()
    troubles: list[str] = []
    page.on("pageerror", lambda error: troubles.append(str(error)))
    await page.goto(page_of_nothing.link)
    await expect(button(page, "Make this room")).to_be_visible()
    yield page
    await context.close()
    assert troubles == []


def button(page: Page, name: str) -> Any:
    return page.get_by_role("button", name=name, exact=True)


def number(page: Page, name: str) -> Any:
    return page.get_by_label(name, exact=True)


async def size(page: Page, length: str = "8", width: str = "5") -> None:
    await number(page, "length (x)").fill(length)
    await number(page, "width (y)").fill(width)
    await button(page, "Make this room").click()
    await expect(button(page, "Change the size")).to_be_visible()


async def open_step(page: Page, title: str) -> None:
    await page.locator(".steps h2 button").get_by_text(title, exact=True).click()


async def pixel(page: Page, at: Point) -> Point:
    """Return where a point of the room [m] is on the screen."""
    return (await drawn_plan(page, ".plan svg")).pixel(*at)


async def drag(page: Page, a: Point, b: Point) -> None:
    await page.mouse.move(*await pixel(page, a))
    await page.mouse.down()
    await page.mouse.move(*await pixel(page, b), steps=4)
    await page.mouse.up()


async def tap(page: Page, at: Point) -> None:
    await page.mouse.click(*await pixel(page, at))


async def kept(page: Page, drawer: Any) -> SiteDraft:
    """Return the draft on disk once everything is kept."""
    await expect(page.locator(".kept")).to_have_attribute("data-kept", "true")
    draft = load_draft(drawer.folder)
    assert draft is not None
    return draft


async def test_a_room_is_drawn_from_nothing_and_its_site_passes_the_doctor(
    page: Page, page_of_nothing: Any
) -> None:
    await size(page)
    await button(page, "Next: Walls and furniture").click()
    await drag(page, (0.5, 3.61), (2.1, 4.39))
    await button(page, "Draw walls").click()
    await drag(page, (4.02, 5.0), (4.0, 3.2))
    await button(page, "Next: Pad").click()
    await tap(page, (1.2, 1.2))
    await page.reload()  # nothing of it is lost, and the step is still open
    await expect(number(page, "x")).to_have_value("1.2")
    await button(page, "Next: Places").click()
    await expect(page.locator(".lack").first).to_contain_text("There is no place to fly to.")
    await tap(page, (6.5, 3.5))
    await number(page, "Name").fill("Window seat")
    await open_step(page, "No-fly zones")
    await drag(page, (2.5, 0.3), (3.6, 1.0))
    await number(page, "Reason").fill("Wet floor")
    draft = await kept(page, page_of_nothing)
    (table,), wall = draft.furniture, draft.walls[-1]
    assert (table.name, table.x, table.y, table.length, table.width, table.top) == (
        *("table", 1.3, 4.0, 1.6, 0.8),
        0.75,
    )
    assert (wall.start, wall.end) == ((4.0, 5.0), (4.0, 3.2))
    assert draft.zones[0].rectangle == (2.5, 0.3, 3.6, 1.0)
    await open_step(page, "Write the site")
    await page.locator(".body").get_by_role("button", name="Write the site").click()
    await expect(page.get_by_text("housefly doctor --site")).to_be_visible()
    await button(page, "Open it now").click()
    await expect(page.get_by_text("compiling the control loop")).to_be_visible()
    await expect(page.get_by_role("link", name="Go to your room")).to_have_attribute(
        "href", "http://127.0.0.1:1/site.toml"
    )
    loaded = load_site(str(page_of_nothing.folder))
    checks = [one for one in check_machine(loaded.site) if not one.name.startswith("ports")]
    assert all(one.well or one.optional for one in checks)
    answer = loaded.plan("window-seat")
    assert answer.path is not None, answer


async def test_what_is_drawn_is_moved_resized_removed_and_all_of_it_undone(
    page: Page, page_of_nothing: Any
) -> None:
    await size(page)
    await open_step(page, "Walls and furniture")
    await drag(page, (2.0, 2.0), (3.0, 3.0))
    await button(page, "Move").click()
    await drag(page, (2.5, 2.5), (4.5, 2.72))
    await drag(page, (5.0, 3.2), (5.5, 3.5))
    (table,) = (await kept(page, page_of_nothing)).furniture
    assert (table.x, table.y, table.length, table.width) == (4.75, 2.85, 1.5, 1.3)
    await button(page, "Remove table").click()
    assert (await kept(page, page_of_nothing)).furniture == ()
    await page.locator("body").click(position={"x": 5, "y": 5})
    for undone in (1, 2, 3):
        await page.keyboard.press("Control+z")
        await expect(page.locator(".kept")).to_contain_text("Undone")
        assert len((await kept(page, page_of_nothing)).furniture) == 1, undone
        await page.wait_for_timeout(50)
    (table,) = (await kept(page, page_of_nothing)).furniture
    assert (table.x, table.y, table.length) == (2.5, 2.5, 1.0)


async def test_all_of_it_works_by_keyboard(page: Page, page_of_nothing: Any) -> None:
    for name, value in (("length (x)", "6"), ("width (y)", "4")):
        await number(page, name).focus()
        await page.keyboard.press("Control+a")
        await page.keyboard.type(value)
    await page.keyboard.press("Enter")
    await expect(button(page, "Change the size")).to_be_visible()
    for name in ("Next: Walls and furniture", "Add a table", "Next: Pad", "Choose a roomy spot"):
        await button(page, name).focus()
        await page.keyboard.press("Enter")
    await expect(number(page, "nose looks to")).to_be_visible()
    await open_step(page, "Walls and furniture")
    table = page.locator(".plan").get_by_role("button", name="table")
    await table.focus()
    for key in ("ArrowRight", "ArrowRight", "Shift+ArrowUp"):
        await page.keyboard.press(key)
    draft = await kept(page, page_of_nothing)
    assert (draft.furniture[0].x, draft.furniture[0].y) == (3.1, 2.5) and draft.pad is not None
    await table.focus()
    await page.keyboard.press("Delete")
    assert (await kept(page, page_of_nothing)).furniture == ()


async def test_a_value_that_is_not_allowed_is_shown_with_its_range_and_not_kept(
    page: Page, page_of_nothing: Any
) -> None:
    await number(page, "length (x)").fill("900")
    await button(page, "Make this room").click()
    await expect(page.get_by_role("alert")).to_contain_text("1 to 200 m")
    await size(page)
    await open_step(page, "Walls and furniture")
    await button(page, "Add a table").click()
    await number(page, "top").fill("300")
    await expect(page.get_by_role("alert")).to_contain_text("Furniture.0.top: is 300")
    await expect(page.locator(".kept")).to_contain_text("Not kept")
    draft = load_draft(page_of_nothing.folder)
    assert draft is not None and draft.furniture[0].top == 0.75
    await number(page, "top").fill("1.2")
    assert (await kept(page, page_of_nothing)).furniture[0].top == 1.2
    await expect(page.get_by_role("alert")).to_have_count(0)


def ros_map() -> list[FilePayload]:
    """Return a map of 6 x 4 m with walls around, and a block of 1 x 1 m in its middle."""
    picture = [[254] * 60 for _ in range(40)]
    for row in range(40):
        for column in range(60):
            is_wall = row in (0, 39) or column in (0, 59)
            if is_wall or (15 <= row < 25 and 25 <= column < 35):
                picture[row][column] = 0
    pgm = b"P5\n60 40\n255\n" + b"".join(bytes(row) for row in picture)
    yaml = "image: map.pgm\nresolution: 0.1\norigin: [0.0, 0.0, 0.0]\nnegate: 0\n"
    yaml += "occupied_thresh: 0.65\nfree_thresh: 0.196\n"
    return [
        {"name": "map.pgm", "mimeType": "image/x-portable-graymap", "buffer": pgm},
        {"name": "map.yaml", "mimeType": "text/yaml", "buffer": yaml.encode()},
    ]


async def test_a_map_is_brought_read_and_what_is_gone_since_is_erased(
    page: Page, page_of_nothing: Any
) -> None:
    files = page.get_by_label("ROS map")
    await files.set_input_files(ros_map()[:1])
    await expect(page.get_by_role("alert")).to_contain_text("None of these is a room")
    await files.set_input_files(ros_map())
    await button(page, "Read map.yaml").click()
    await expect(page.get_by_text("Read from map.yaml.")).to_be_visible(timeout=30_000)
    before = await kept(page, page_of_nothing)
    assert before.bounds is not None and before.bounds[2] == pytest.approx(6.0, abs=0.3)
    await open_step(page, "Walls and furniture")
    await button(page, "Erase scan").click()
    await drag(page, (2.2, 1.2), (3.8, 2.8))
    await expect(page.locator(".kept")).to_contain_text("Erased")
    after = await kept(page, page_of_nothing)
    assert 0 < len(after.scanned) < len(before.scanned)


async def test_three_points_align_the_frame_with_what_tracking_sees(
    page: Page, page_of_nothing: Any
) -> None:
    await size(page)
    await open_step(page, "Tracking")
    await button(page, "Real hardware").click()
    await number(page, "Address").fill("10.0.0.5")
    await button(page, "Listen for 3 s").click()
    await expect(page.locator(".notes").first).to_contain_text(
        "100 frames a second", timeout=30_000
    )
    await open_step(page, "Tracking frame")
    seen = page.get_by_role("group", name="As tracking sees it [m]")
    for x, y in ((1.0, 1.0), (6.0, 1.0), (1.0, 4.0)):
        await tap(page, (x, y))
        await seen.get_by_label("x").fill(str(x + 2.0))
        await seen.get_by_label("y").fill(str(y - 1.0))
    words = page.get_by_label("What the points say")
    await expect(words).to_contain_text("point 3 0.0 cm")
    await expect(words).to_contain_text("origin at (-2.000, 1.000, 0.0")
    await button(page, "Take what tracking sees now").click()
    await expect(seen.get_by_label("x")).to_have_value("1.5")
    await expect(words).to_contain_text("measure the points again")
    point = (await kept(page, page_of_nothing)).frame_points[2]
    assert (point.on_map, point.seen) == ((1.0, 4.0, BODY_HEIGHT), (1.5, 2.5, 0.05))


TOO_SMALL_OR_OUTSIDE = """
[...document.querySelectorAll("button, select, input:not([type=checkbox])")].filter((one) => {
  const box = one.getBoundingClientRect();
  return box.height < 44 || box.left < 0 || box.right > document.documentElement.clientWidth;
}).map((one) => one.outerHTML)
"""


@pytest.mark.parametrize(
    "screen",
    [DESKTOP, PHONE, {"width": 640, "height": 400}],
    ids=["desktop", "phone", "desktop at 200 %"],
)
async def test_everything_can_be_reached_on_any_screen(page: Page, screen: Any) -> None:
    await page.set_viewport_size(screen)
    await size(page)
    for title in ("Walls and furniture", "Places", "Tracking", "Write the site"):
        await open_step(page, title)
        overflow = await page.evaluate(
            "document.documentElement.scrollWidth - document.documentElement.clientWidth"
        )
        assert overflow <= 0, "the page must not scroll sideways"
        assert await page.evaluate(TOO_SMALL_OR_OUTSIDE) == []
    last = button(page, "Write the site").last
    await last.scroll_into_view_if_needed()
    box = await last.bounding_box()
    assert box is not None and box["y"] + box["height"] <= screen["height"] + 1


async def test_a_decimal_comma_is_typed_as_a_decimal_point(page: Page) -> None:
    await number(page, "length (x)").fill("")
    await number(page, "length (x)").press_sequentially("6,5")
    await number(page, "width (y)").fill("4")
    await button(page, "Make this room").click()
    await expect(page.get_by_text("6.50 \u00d7 4.00 m")).to_be_visible()


async def test_at_double_size_on_a_phone_the_head_leaves_room_for_the_steps(page: Page) -> None:
    await page.set_viewport_size({"width": 195, "height": 422})
    await size(page)
    await expect(page.get_by_role("status")).to_be_visible()
    head = await page.locator("header.top").bounding_box()
    assert head is not None and head["height"] < 140
    assert await page.evaluate("document.documentElement.scrollWidth <= innerWidth")


@pytest.mark.interop
async def test_what_is_typed_slowly_stays_while_answers_of_the_server_come(
    page: Page, page_of_nothing: Any
) -> None:
    await size(page)
    await open_step(page, "Walls and furniture")
    await button(page, "Add a table").click()
    name = number(page, "Name")
    await name.fill("")
    await expect(page.locator(".wrong")).to_contain_text("at least 1 character")
    for n in range(1, 5):
        await page.keyboard.type("Desk"[n - 1])
        await expect(page.locator(".kept")).to_have_attribute("data-kept", "true")
        await expect(name).to_have_value("Desk"[:n])
    width = number(page, "width")
    await width.press("Control+a")
    for key, shown in zip("1.25", ("1", "1", "1.2", "1.25"), strict=True):
        await page.keyboard.press(key)
        await expect(page.locator(".kept")).to_have_attribute("data-kept", "true")
        assert (await width.input_value()).rstrip(".") == shown
    (table,) = (await kept(page, page_of_nothing)).furniture
    assert (table.name, table.width) == ("Desk", 1.25)
