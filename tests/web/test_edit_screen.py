"""Editing places and zones of the room, in real Chromium, with a real edit service."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from pathlib import Path
from typing import Any

import pytest
import pytest_asyncio
from axe_audit import axe_findings
from plan_pixels import drawn_plan
from playwright.async_api import Browser, Page, expect

from housefly.app.views import room_view
from housefly.config.edits import Edits
from housefly.messages import DroneStatus, Phase
from housefly.room.bsen import bsen
from housefly.room.edit_versions import EditVersions
from housefly.sites.loaded_site import open_site, read_site
from housefly.web.api.edit_service import EditService

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

DESKTOP, PHONE = {"width": 1280, "height": 800}, {"width": 390, "height": 844}


@pytest.fixture
def versions(tmp_path: Path) -> EditVersions:
    return EditVersions(tmp_path / "edits")


@pytest_asyncio.fixture(loop_scope="session")
async def console(serving: Any, loopback: str, versions: EditVersions) -> AsyncIterator[Any]:
    loaded = open_site(read_site("bsen"))
    async with serving(
        loopback, edits=EditService(bsen, loaded.site, versions), view=room_view(loaded)
    ) as console:
        yield console


@pytest_asyncio.fixture(loop_scope="session")
async def page(console: Any, chromium: Browser) -> AsyncIterator[Page]:
    """Yield the room being edited; fails on any error of the page."""
    context = await chromium.new_context(viewport=DESKTOP)
    page = await context.new_page()
    troubles: list[str] = []
    page.on("pageerror", lambda error: troubles.append(str(error)))
    await page.goto(console.link + "#edit")
    await expect(panel(page)).to_contain_text("Meeting table")
    yield page
    await context.close()
    assert troubles == []


def panel(page: Page) -> Any:
    return page.get_by_role("region", name="Edit places and zones")


def button(page: Page, name: str) -> Any:
    return panel(page).get_by_role("button", name=name, exact=True)


async def pixel(page: Page, x: float, y: float) -> tuple[float, float]:
    """Return where a point of the room [m] is on the screen."""
    return (await drawn_plan(page)).pixel(x, y)


async def drag(page: Page, a: tuple[float, float], b: tuple[float, float]) -> None:
    await page.mouse.move(*await pixel(page, *a))
    await page.mouse.down()
    await page.mouse.move(*await pixel(page, *b), steps=4)
    await page.mouse.up()


async def type_into(page: Page, label: str, words: str) -> None:
    """Type into the field that has the focus by itself."""
    await expect(panel(page).get_by_label(label)).to_be_focused()
    await page.keyboard.type(words)


async def add_corner(page: Page) -> None:
    await page.mouse.click(*await pixel(page, 6.0, 4.25))
    await type_into(page, "Name", "Reading corner")
    await button(page, "Save").click()
    await expect(panel(page).get_by_role("status")).to_contain_text("Saved as version 1.")


async def test_a_place_is_added_on_the_map_seen_undone_and_gone(
    page: Page, versions: EditVersions, console: Any
) -> None:
    await add_corner(page)
    await expect(panel(page).get_by_role("status")).to_contain_text(
        "from the next start of Housefly on"
    )
    await expect(page.locator(".edits")).to_contain_text("Reading corner")
    (place,) = versions.newest().edits.places
    assert (place.name, place.title, place.viewpoint) == (
        "reading-corner",
        "Reading corner",
        (6.0, 4.25),
    )
    await page.reload()
    await expect(panel(page)).to_contain_text("Reading corner")
    await button(page, "Undo").click()
    await expect(panel(page).get_by_role("status")).to_contain_text("Undone; this is version 2.")
    await expect(panel(page)).not_to_contain_text("Reading corner")
    await expect(page.locator(".edits")).not_to_contain_text("Reading corner")
    assert versions.newest().edits == Edits()
    assert console.pilot.orders == []


async def test_what_is_not_saved_survives_a_reload_and_says_from_when_it_counts(
    page: Page, versions: EditVersions
) -> None:
    await drag(page, (5.0, 3.0), (6.0, 4.0))
    await type_into(page, "Reason", "Wet floor")
    await expect(panel(page)).to_contain_text("counts from the next start of Housefly on")
    await page.reload()
    await expect(page.locator(".edits .zone")).to_contain_text("Wet floor")
    await expect(panel(page)).to_contain_text("These changes were not saved before")
    assert versions.newest().number == 0
    await button(page, "Save").click()
    await expect(panel(page).get_by_role("status")).to_contain_text("Saved as version 1.")
    await page.reload()
    await expect(panel(page)).not_to_contain_text("not saved before")


async def test_what_was_saved_is_used_now_on_the_ground_by_a_hold_and_said_to_be_in_use(
    chromium: Browser, serving: Any, loopback: str, versions: EditVersions, tmp_path: Path
) -> None:
    loaded, used = open_site(read_site("bsen")), []
    site = loaded.site

    def use(number: int) -> str:
        nonlocal site
        used.append(number)
        site = site.model_copy(update={"edits": versions.newest().edits})
        return ""

    service = EditService(bsen, site, versions, in_force=lambda: site.edits, use=use)
    async with serving(loopback, edits=service, view=room_view(loaded)) as console:
        page = await chromium.new_page(viewport=DESKTOP)
        await page.goto(console.link + "#edit")
        await expect(panel(page)).to_contain_text("Meeting table")
        await add_corner(page)
        offer = panel(page).locator(".hold")
        await expect(panel(page)).to_contain_text("The pilot starts again, about 10 s")
        console.pilot.status, console.pilot.phase = DroneStatus.FLYING, Phase.HOLDING
        await expect(panel(page)).to_contain_text("In the air the drone keeps the map")
        await expect(offer).to_have_count(0)
        console.pilot.status, console.pilot.phase = DroneStatus.LANDED, Phase.IDLE
        await offer.click()
        await asyncio.sleep(0.3)
        assert used == [], "a tap is no hold"
        await page.screenshot(path=tmp_path / "use-now.png")
        await offer.hover()
        await page.mouse.down()
        await expect(panel(page)).to_contain_text("No flight meanwhile")
        await expect(offer).to_have_count(0)
        await page.mouse.up()
        await page.screenshot(path=tmp_path / "using.png")
        console.pilot.sequence = 0  # as a pilot that has started again
        await expect(panel(page)).to_contain_text("In use: the drone has this map now.")
        assert used == [1]
        await page.screenshot(path=tmp_path / "in-use.png")
        await page.close()


async def test_a_watcher_is_told_at_once_that_it_may_not_edit(page: Page, console: Any) -> None:
    watcher = await page.context.new_page()
    await watcher.goto(console.origin + "/#edit")
    await expect(panel(watcher)).to_contain_text("Viewer 1 has control, and only who has control")
    await button(watcher, "Add a zone").click(force=True)
    await drag(watcher, (5.0, 3.0), (6.0, 4.0))
    await expect(watcher.locator(".edits .zone")).to_have_count(0)
    await expect(panel(watcher).locator("form")).to_have_count(0)


async def test_a_zone_over_the_home_pad_is_refused_in_words_beside_its_form(
    page: Page, versions: EditVersions
) -> None:
    await drag(page, (9.9, 0.8), (11.2, 1.8))
    await type_into(page, "Reason", "Wet floor")
    await button(page, "Save").click()
    form = panel(page).locator("li form")
    await expect(form.get_by_role("alert")).to_contain_text("covers the home pad")
    assert versions.newest().number == 0
    await button(page, "Discard").click()
    await expect(page.locator(".edits .zone")).to_have_count(0)


async def test_a_zone_is_drawn_saved_and_drawn_again(page: Page, versions: EditVersions) -> None:
    await drag(page, (5.0, 3.0), (6.0, 4.0))
    await type_into(page, "Reason", "Wet floor")
    await drag(page, (5.0, 3.0), (6.5, 4.0))
    await button(page, "Save").click()
    await expect(panel(page).get_by_role("status")).to_contain_text("Saved as version 1.")
    (zone,) = versions.newest().edits.zones
    assert (zone.reason, zone.rectangle) == ("Wet floor", (5.0, 3.0, 6.5, 4.0))


async def test_all_of_it_works_by_keyboard(page: Page, versions: EditVersions) -> None:
    await button(page, "Add a place").focus()
    await page.keyboard.press("Enter")
    await type_into(page, "Name", "Middle")
    for value in ("6", "4.25"):
        await page.keyboard.press("Tab")
        await page.keyboard.press("Control+a")
        await page.keyboard.type(value)
    await page.keyboard.press("Enter")
    await expect(panel(page).locator("form")).to_have_count(0)
    await button(page, "Remove Bed").focus()
    await page.keyboard.press("Enter")
    await button(page, "Save").focus()
    await page.keyboard.press("Enter")
    await expect(panel(page).get_by_role("status")).to_contain_text("Saved as version 1.")
    edits = versions.newest().edits
    assert edits.removed == ("bed",) and edits.places[0].viewpoint == (6.0, 4.25)


async def test_a_place_of_the_room_is_shown_under_another_name_and_looks_elsewhere(
    page: Page, versions: EditVersions
) -> None:
    await page.mouse.click(*await pixel(page, 3.05, 4.25))
    await expect(panel(page).get_by_label("Name")).to_be_focused()
    await panel(page).get_by_label("Name").fill("Front door")
    await panel(page).locator("fieldset").nth(1).get_by_role("button", name="on map").click()
    await page.mouse.click(*await pixel(page, 1.0, 4.0))
    await button(page, "Save").click()
    await expect(panel(page).get_by_role("status")).to_contain_text("Saved as version 1.")
    (place,) = versions.newest().edits.places
    assert (place.name, place.title, place.viewpoint, place.look_at) == (
        "entrance",
        "Front door",
        (3.05, 4.25),
        (1.0, 4.0, 1.35),
    )


async def test_who_was_overtaken_is_told_and_takes_what_the_other_saved(
    page: Page, versions: EditVersions
) -> None:
    versions.save(Edits(removed=("tv",)), 0, "Bob")
    await button(page, "Remove Bed").click()
    await button(page, "Save").click()
    await expect(panel(page).get_by_role("alert")).to_contain_text(
        "Version 1 was saved by Bob in between"
    )
    await button(page, "Discard").click()
    await expect(button(page, "Bed")).to_be_visible()
    await expect(button(page, "TV")).to_have_count(0)


@pytest.mark.interop
async def test_axe_finds_nothing_while_a_zone_and_a_place_are_edited(
    page: Page, versions: EditVersions
) -> None:
    sizes = (tuple(DESKTOP.values()), tuple(PHONE.values()))
    await drag(page, (9.9, 0.8), (11.2, 1.8))
    await type_into(page, "Reason", "Wet floor")
    await button(page, "Save").click()
    await expect(panel(page).get_by_role("alert")).to_contain_text("covers the home pad")
    assert await axe_findings(page, sizes) == []
    await page.set_viewport_size(DESKTOP)
    await button(page, "Discard").click()
    await add_corner(page)
    assert await axe_findings(page, sizes) == []


@pytest.mark.parametrize(
    "size",
    [DESKTOP, PHONE, {"width": 640, "height": 400}],
    ids=["desktop", "phone", "desktop at 200 %"],
)
async def test_stop_stays_where_it_is_and_everything_can_be_reached(
    page: Page, console: Any, size: Any
) -> None:
    await page.set_viewport_size(size)
    await button(page, "Add a zone").click()
    stop = await page.locator(".stop").bounding_box()
    assert stop is not None
    assert stop["height"] >= 56 and stop["y"] + stop["height"] <= size["height"]
    lowest = stop["y"] if size["height"] > 560 else size["height"]
    overflow = await page.evaluate(
        "document.documentElement.scrollWidth - document.documentElement.clientWidth"
    )
    assert overflow <= 0, "the page must not scroll sideways"
    for name in ("Save", "Close", "Done"):
        await button(page, name).scroll_into_view_if_needed()
        box = await button(page, name).bounding_box()
        assert box is not None and box["height"] >= 44 and box["y"] + box["height"] <= lowest
    await page.evaluate("document.activeElement.blur()")
    await page.keyboard.press("Space")
    await expect(page.locator(".stop")).to_contain_text("STOPPED")
