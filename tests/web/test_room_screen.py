"""People, things and the past on the live scene in Chromium, with a real hub behind it."""

from __future__ import annotations

import asyncio
import re
import time
from collections.abc import AsyncIterator, Callable
from dataclasses import dataclass
from math import pi
from pathlib import Path
from typing import Any

import pytest
import pytest_asyncio
from console_page import open_details, open_earlier
from playwright.async_api import Browser, Page, expect

from housefly.config.hub import HubConfig
from housefly.config.site import Site
from housefly.geometry import Vec3
from housefly.hub.api.answers import ObstacleAnswer, SituationAnswer
from housefly.hub.hub import Hub
from housefly.hub.things.thing import Thing, ThingKind
from housefly.messages import Observation, OrderKind, RoomEvent
from housefly.messages.words import literal
from housefly.sensors.contracts import SensorHealth
from housefly.web.api.coverage_layer import CoverageView

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

DESKTOP = {"width": 1280, "height": 800}
HEALTH = (
    SensorHealth("floor-1", "floor", "floor sensing", True, 10.0, 0.05, ""),
    SensorHealth(
        "cabinet",
        "cabinet",
        "the cabinet's own report",
        False,
        0.0,
        95.0,
        "offline: its battery may be empty",
    ),
)


@dataclass
class Room:
    """A hub that is told things, and the console before it."""

    hub: Hub
    console: Any
    began: float

    def see(
        self,
        thing: str,
        position: Vec3 | None = None,
        *,
        inside: str = "",
        source: str = "floor-1",
        ago: float = 0.0,
    ) -> None:
        at = time.time() - ago
        self.hub.memory.add(Observation(thing, source, at, at, position, inside=inside))

    def happen(self, kind: str, thing: str, source: str, ago: float) -> None:
        self.hub.memory.add(RoomEvent(kind, thing, time.time() - ago, source))


@pytest_asyncio.fixture(loop_scope="session")
async def room(serving: Any, loopback: str, tmp_path: Path) -> AsyncIterator[Room]:
    rows = tuple("0123456789abcdefgh01234567890a"[:30] for _ in range(16))
    view = CoverageView(1.1, 18, 2, (0.0, 0.0), 0.25, rows)
    async with serving(loopback, coverage=lambda: view) as console:
        site = Site(hub=HubConfig(store=str(tmp_path / "room.db")))
        hub = Hub(site, tmp_path, console.bus.join())
        hub.status.add_health_source(lambda: HEALTH)
        found = Room(hub, console, time.time())
        for thing in (
            Thing("cup", "the red cup", aliases=("mug",)),
            Thing("cabinet", "the cabinet", ThingKind.FURNITURE, position=(6.0, 2.5, 0.6)),
            Thing(
                "refrigerator-2",
                "the small refrigerator",
                ThingKind.FURNITURE,
                position=(1.0, 3.0, 0.6),
            ),
            Thing("person-1", "the resident", ThingKind.PERSON),
        ):
            hub.memory.world.add_thing(thing)
        found.see("cup", inside="refrigerator-2", source="refrigerator", ago=120.0)
        found.see("cup", inside="cabinet", source="cabinet", ago=30.0)
        found.see("person-1", (2.0, 3.0, 0.0), ago=100.0)
        found.see("person-1", (3.0, 0.8, 0.0))
        found.happen("object put", "cup", "cabinet", 30.0)
        telling = asyncio.create_task(hub.run())
        yield found
        telling.cancel()
        await asyncio.gather(telling, return_exceptions=True)
        await asyncio.to_thread(hub.close)


@pytest_asyncio.fixture(loop_scope="session")
async def page(room: Room, chromium: Browser) -> AsyncIterator[Page]:
    """Yield the live scene; fails on any error of the page and any request to another host."""
    context = await chromium.new_context(viewport=DESKTOP)
    page = await context.new_page()
    troubles: list[str] = []
    own = (room.console.origin + "/", room.console.origin.replace("http", "ws") + "/", "data:")
    page.on("pageerror", lambda error: troubles.append(str(error)))
    page.on(
        "console", lambda message: troubles.append(message.text) if is_trouble(message) else None
    )
    page.on(
        "request",
        lambda request: troubles.append(request.url) if not request.url.startswith(own) else None,
    )
    await page.goto(room.console.link)
    await expect(mark(page, "person-1")).to_be_visible()
    yield page
    await context.close()
    assert troubles == []


def is_trouble(message: Any) -> bool:
    """Return whether a message is an error, other than Chromium's own on every refused request."""
    return message.type == "error" and "Failed to load resource" not in message.text


def mark(page: Page, thing: str) -> Any:
    return page.locator(f".thing-mark[data-thing='{thing}']")


async def details(page: Page) -> None:
    await page.get_by_role("button", name="Details", exact=True).click()


async def ask(page: Page, words: str) -> None:
    field = page.get_by_role("combobox", name="Where is")
    if not await field.is_visible():  # orders have its place
        await page.get_by_role("banner").get_by_role("button", name="Ask", exact=True).click()
    await field.fill(words)
    await page.keyboard.press("Enter")


async def middle(locator: Any) -> tuple[float, float]:
    box = await locator.bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


async def test_people_are_drawn_where_they_are_and_move(page: Page, room: Room) -> None:
    await expect(mark(page, "person-1")).to_contain_text("the resident")
    before = await middle(mark(page, "person-1").locator("circle.reach"))
    room.see("person-1", (5.0, 0.8, 0.0))
    await asyncio.sleep(1.0)
    after = await middle(mark(page, "person-1").locator("circle.reach"))
    scale = float(await page.locator(".plan-view > svg").get_attribute("data-scale") or 0)
    assert after[0] - before[0] == pytest.approx(2.0 * scale, abs=2.0)


async def test_what_is_in_something_is_written_beside_it(page: Page) -> None:
    await expect(mark(page, "cabinet")).to_contain_text("in it: the red cup")
    await expect(mark(page, "cup")).to_have_count(0)


async def test_old_things_fade_and_say_their_age(page: Page, room: Room) -> None:
    room.see("book", (4.2, 3.3, 0.4), ago=70.0)
    await expect(mark(page, "book")).to_contain_text("70 s ago")
    faded = await mark(page, "book").evaluate("e => Number(getComputedStyle(e).opacity)")
    assert faded < 0.9


async def test_a_nickname_is_answered_in_words_and_ringed_on_the_map(page: Page) -> None:
    await ask(page, "mug")
    await expect(page.locator(".answer .words")).to_contain_text("the red cup: in the cabinet")
    await expect(page.locator(".answer .words")).to_contain_text("last seen")
    ring, cabinet = (
        await middle(page.locator(".found")),
        await middle(mark(page, "cabinet").locator("circle.reach")),
    )
    assert abs(ring[0] - cabinet[0]) < 3 and abs(ring[1] - cabinet[1]) < 3
    await page.locator(".answer").get_by_role("button", name="the cabinet").click()
    await expect(page.locator(".answer .words")).to_contain_text("the cabinet: at")


async def test_what_nobody_knows_is_said_and_what_was_meant_is_one_press_away(page: Page) -> None:
    await ask(page, "rad cub")
    await expect(page.locator(".answer")).to_contain_text("Nothing is called 'rad cub'")
    await page.locator(".answer").get_by_role("button", name="the red cup").click()
    await expect(page.locator(".answer .words")).to_contain_text("in the cabinet")


async def test_a_thing_on_the_map_is_found_by_keyboard(page: Page, room: Room) -> None:
    await mark(page, "person-1").focus()
    await page.keyboard.press("Enter")
    await expect(page.locator(".answer .words")).to_contain_text(
        "the resident: at (3.00, 0.80, 0.00) m"
    )
    assert room.console.pilot.orders == []


async def test_a_sensor_that_is_ill_comes_first_and_says_why(page: Page) -> None:
    await details(page)
    first = page.locator(".sensors li").filter(has_text="own report").filter(has_text="cabinet")
    await expect(first).to_contain_text("offline: its battery may be empty")
    await expect(first.locator(".mark")).to_have_text("✕")
    await expect(page.locator(".sensors li").first).to_have_attribute("data-health", "fault")
    await expect(page.locator(".sensors li").filter(has_text="floor sensing")).to_contain_text(
        "10 Hz · 50 ms"
    )


async def test_the_past_is_shown_unmistakably_and_now_is_one_press_away(page: Page) -> None:
    await ask(page, "the red cup")
    await open_earlier(page)
    slider = page.get_by_role("slider", name="Time shown")
    now = await middle(mark(page, "person-1").locator("circle.reach"))
    await slider.fill("-60")
    await expect(page.locator(".past-banner")).to_contain_text("The past")
    await expect(page.locator(".answer")).to_contain_text("in the small refrigerator")
    await expect(mark(page, "refrigerator-2")).to_contain_text("in it: the red cup")
    await expect(page.locator(".live")).to_have_attribute("data-past", "true")
    assert re.search(
        r"\d\d:\d\d:\d\d, \d+ s ago", await slider.get_attribute("aria-valuetext") or ""
    )
    then = await middle(mark(page, "person-1").locator("circle.reach"))
    assert abs(now[0] - then[0]) + abs(now[1] - then[1]) > 50
    await page.get_by_role("button", name="Back to live", exact=True).click()
    await expect(page.locator(".past-banner")).to_have_count(0)
    await expect(page.locator(".answer .words")).to_contain_text("in the cabinet")


async def test_the_slider_is_moved_by_keys_and_space_on_it_is_stop(page: Page, room: Room) -> None:
    await open_earlier(page)
    slider = page.get_by_role("slider", name="Time shown")
    await slider.focus()
    for _ in range(3):
        await page.keyboard.press("ArrowLeft")
    await expect(page.locator(".past-banner")).to_be_visible()
    await page.keyboard.press("Space")
    await expect(page.locator(".stop")).to_contain_text("STOPPED")
    assert len(room.console.stops) == 1


async def test_an_event_is_listed_filtered_and_shows_its_moment(page: Page, room: Room) -> None:
    room.happen("door opened", "entrance-door", "entrance-door", 1.0)
    await open_earlier(page)
    await open_details(page)
    event = page.locator(".log li").filter(has_text="Object put: the red cup (the cabinet)")
    await expect(event).to_be_visible()
    await expect(page.locator(".log")).to_contain_text("Door opened: entrance door")
    assert await page.locator(".slider i").count() >= 2
    await page.get_by_label("Which lines").select_option("room")
    await page.get_by_label("Only of").select_option("cup")
    await expect(page.locator(".log")).not_to_contain_text("Door opened")
    # One Tab stop for all lines: STOP is never behind a hundred of them.
    await page.locator(".log ol").focus()
    await page.keyboard.press("ArrowDown")
    await expect(page.locator(".log ol button").first).to_be_focused()
    await page.keyboard.press("Tab")
    await expect(page.locator(".log :focus")).to_have_count(0)
    await event.get_by_role("button").click()
    await expect(page.locator(".past-banner")).to_be_visible()
    await expect(mark(page, "cabinet")).to_contain_text("in it: the red cup")


async def test_what_holds_and_what_is_in_the_way_is_drawn_and_said(page: Page, room: Room) -> None:
    room.hub.status.set_situations(
        [
            SituationAnswer(
                "lies on the floor",
                "person-1",
                time.time(),
                0.84,
                "low for 12 s",
                words=literal("lies on the floor"),
            )
        ]
    )
    room.hub.status.set_obstacles(
        [ObstacleAnswer("o-1", 4.0, 3.5, 0.3, 0.5, 0.0, 0.9, 0.0, "laser-1")]
    )
    await expect(mark(page, "person-1")).to_contain_text("△ lies on the floor, 84 %")
    await expect(page.locator(".live .legend")).to_contain_text("low for 12 s")
    await expect(page.locator(".obstacle")).to_contain_text("0.5 m/s, 90 % sure")
    await open_earlier(page)
    await page.get_by_role("slider", name="Time shown").fill("-60")
    await expect(page.locator(".past-banner")).to_be_visible()
    assert await page.locator(".obstacle").count() == 0


async def test_tracked_furniture_is_drawn_as_it_lies_and_called_by_its_name(
    page: Page, room: Room
) -> None:
    sofa = ObstacleAnswer(
        "tracking/the sofa", 4.0, 3.0, 1.25, 0.0, 0.0, 1.0, 0.0, "tracking", 2.4, 0.8, 0.5 * pi
    )
    room.hub.status.set_obstacles([sofa])
    await expect(page.locator(".obstacle.tracked")).to_contain_text("the sofa")
    box = await page.locator(".obstacle.tracked rect").bounding_box()
    scale = float(await page.locator(".plan-view > svg").get_attribute("data-scale") or 0)
    assert box is not None
    assert (box["width"] / scale, box["height"] / scale) == (
        pytest.approx(0.8, abs=0.1),
        pytest.approx(2.4, abs=0.1),
    )


async def test_tracking_coverage_is_switched_on_and_off(page: Page) -> None:
    await page.get_by_text("Layers").click()
    button = page.get_by_role("button", name="Tracking coverage")
    await button.click()
    await expect(page.locator(".coverage text").first).to_be_visible()
    await expect(page.locator(".live .legend")).to_contain_text("18 cameras")
    await expect(button).to_have_attribute("aria-pressed", "true")
    await button.click()
    await expect(page.locator(".coverage")).to_have_count(0)


async def test_no_key_sends_the_drone_where_its_goal_cannot_be_seen(page: Page, room: Room) -> None:
    await page.keyboard.press("r")
    await expect(page.locator(".edit-deck")).to_be_visible()
    for key in ("ArrowRight", "ArrowUp"):
        await page.keyboard.press(key)
    await page.keyboard.down("Enter")
    await asyncio.sleep(0.9)
    await page.keyboard.up("Enter")
    assert room.console.pilot.orders == []
    await page.keyboard.press("r")
    await expect(page.locator(".ask-line")).to_be_visible()
    await expect(page.locator(".ghost .tag")).to_have_count(0)


async def test_only_the_newest_question_is_answered_whatever_comes_first(page: Page) -> None:
    async def late(route: Any) -> None:
        await asyncio.sleep(1.0)
        await route.continue_()

    await page.route("**/api/v1/where/the%20red%20cup*", late)
    await ask(page, "the red cup")
    await ask(page, "the small refrigerator")
    await expect(page.locator(".answer .words")).to_contain_text("the small refrigerator: at")
    await asyncio.sleep(1.3)
    await expect(page.locator(".answer .words")).to_contain_text("the small refrigerator: at")
    await ask(page, "salt/pepper")
    await expect(page.locator(".answer")).to_contain_text("Nothing is called 'salt pepper'")


async def test_what_was_found_is_one_hold_from_being_looked_at(page: Page, room: Room) -> None:
    await ask(page, "where is the resident")
    await expect(page.locator(".answer .words")).to_contain_text("the resident")
    look = page.get_by_role("button", name="Look there")
    await look.hover()
    await page.mouse.down()
    await asyncio.sleep(0.9)
    await page.mouse.up()
    await expect(page.locator(".primary")).to_contain_text("Look at the resident and come back")
    assert room.console.pilot.orders == []
    await ask(page, "go to Sofa")
    await expect(page.locator(".primary")).to_contain_text("Look at Sofa and come back")


async def test_a_bell_is_a_card_in_words_and_in_the_title_and_the_picture_takes_the_stage(
    page: Page, room: Room, until: Callable[..., Any]
) -> None:
    assert await page.title() == "Housefly"
    await ask(page, "the red cup")
    await expect(page.locator(".answer")).to_be_visible()
    room.happen("bell pressed", "doorbell", "doorbell", 0.0)
    card = page.get_by_role("article", name="Doorbell")
    await expect(card).to_contain_text("Someone at the entrance")
    await expect(page).to_have_title(re.compile("Someone at the entrance"))
    await expect(page.locator(".app")).to_have_attribute("data-swapped", "true")
    await expect(page.locator(".answer")).to_have_count(0)
    stage, card_at = await page.locator(".view.video").bounding_box(), await card.bounding_box()
    assert stage is not None and card_at is not None
    assert stage["width"] > 600 and card_at["y"] > stage["y"] + 0.4 * stage["height"]
    assert card_at["y"] + card_at["height"] <= stage["y"] + stage["height"], "over no order"
    await card.get_by_role("button", name="Ignore").click()
    await expect(card).to_have_count(0)
    await expect(page.locator(".app")).to_have_attribute("data-swapped", "false")
    assert room.console.pilot.orders == []
    room.happen("bell pressed", "doorbell", "doorbell", 0.0)
    await card.get_by_role("button", name="Look").hover()
    await page.mouse.down()
    await asyncio.sleep(0.9)
    await page.mouse.up()
    await until(lambda: room.console.pilot.orders)
    (order,) = room.console.pilot.orders
    assert (order.kind, order.place) == (OrderKind.SERVICE, "entrance")


async def test_a_memory_that_is_silent_is_said_to_be(page: Page, room: Room) -> None:
    await page.route(
        "**/api/v1/**",
        lambda route: route.fulfill(
            status=503, json={"error": "the room's memory does not answer"}
        ),
    )
    # Who still tells news is there: here nobody does.
    await page.route_web_socket("**/api/v1/watch", lambda _: None)
    await page.reload()
    legend = page.locator(".live .legend")
    await expect(legend).to_contain_text("memory does not answer", timeout=20_000)
    await page.unroute("**/api/v1/**")
    await expect(page.locator(".live .legend")).not_to_contain_text("memory", timeout=10_000)
