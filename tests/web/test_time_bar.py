"""Time at the foot of the console: what was recorded is never taken for what is."""

from __future__ import annotations

import asyncio
import re
import time
from collections.abc import AsyncIterator, Callable
from pathlib import Path as FilePath
from typing import Any

import pytest
import pytest_asyncio
from console_page import choose_place, open_earlier
from playwright.async_api import Browser, Page, expect

from housefly.bus.topics import DroneTopics
from housefly.messages import (
    DroneStatus,
    Path,
    Phase,
    PlannedTrajectory,
    SafetyMode,
    Severity,
    TrajectoryPoint,
)
from housefly.web.flights.flight_log import (
    FlightEnd,
    FlightHead,
    FlightNote,
    FlightPath,
    Line,
    LoggedPose,
    LoggedStage,
    line_text,
)

TOPICS = DroneTopics()

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

Until = Callable[..., Any]
FLIGHT = re.compile("Flight at .* to Entrance, 10:00 long, with warnings")
WAY = tuple((1.0 + 0.25 * k, 1.0 + 0.05 * k) for k in range(17))
HEIGHTS = tuple(1.0 + 0.02 * k for k in range(17))
SPEEDS = tuple(0.5 * min(k, 16 - k) / 8 for k in range(17))
TIMES = tuple(0.8 * k for k in range(17))


def kept_flight(folder: FilePath, minutes: float) -> None:
    """Write the log of a flight of so many minutes that ended half a minute ago."""
    began, seconds = time.time() - 60.0 * minutes - 30.0, 60.0 * minutes
    lines: list[Line] = [FlightHead(1, "Rehearsal", began)]
    lines.append(LoggedStage(0.0, Phase.OUTBOUND, SafetyMode.NOMINAL, "Entrance"))
    lines.append(FlightPath(0.0, WAY, HEIGHTS, TIMES, SPEEDS))
    lines.append(FlightNote(0.0, Severity.INFO, "airborne", "off it went"))
    for k in range(round(10 * seconds)):
        x, y = WAY[k // 40 % len(WAY)]
        lines.append(LoggedPose(k / 10, (x, y, 1.1), 0.1, 0.4, 0.9))
        if k == round(5 * seconds):
            half = FlightNote(k / 10, Severity.WARNING, "test", "the middle of the flight")
            lines.append(half)
    lines.append(FlightEnd(seconds, "Entrance", Severity.WARNING))
    folder.mkdir()
    (folder / "20270115T080000250Z.jsonl").write_text("".join(map(line_text, lines)))


@pytest_asyncio.fixture(loop_scope="session")
async def kept(
    serving: Any, chromium: Browser, loopback: str, tmp_path: FilePath
) -> AsyncIterator[tuple[Page, Any]]:
    """Yield a console that has a flight of ten minutes to look at again, and who serves it."""
    kept_flight(tmp_path / "flights", 10.0)
    async with serving(loopback, flights=tmp_path / "flights") as console:
        context = await chromium.new_context(viewport={"width": 1280, "height": 800})
        page = await context.new_page()
        troubles: list[str] = []
        page.on("pageerror", lambda error: troubles.append(str(error)))
        await page.goto(console.link)
        await expect(page.locator(".headline")).to_contain_text("Your drone is home")
        await open_earlier(page)
        yield page, console
        await context.close()
        assert troubles == []


async def opened(page: Page) -> None:
    """Open the flight."""
    await page.get_by_label("How far back").select_option("1 h")
    await page.get_by_role("button", name=FLIGHT).click()
    await expect(page.locator(".recorded-layer .then")).to_be_visible()


async def scrub(page: Page, moment: float) -> None:
    """Drag the bar to a moment of the flight [s]."""
    await page.get_by_label("Moment of the recording").fill(str(moment))


async def is_live(page: Page) -> None:
    await expect(page.locator(".drone")).to_be_visible()
    await expect(page.locator(".recorded-layer, .recorded-banner, .recorded-log")).to_have_count(0)
    await expect(page.locator(".map")).to_have_attribute("data-recorded", "false")


async def test_a_flight_is_looked_at_again_in_place_and_says_that_it_is_recorded(
    kept: tuple[Page, Any],
) -> None:
    page, _ = kept
    await opened(page)
    # Nothing live is left on the map, and what is there says what it is in words.
    await expect(page.locator(".map .drone, .map .ghost, .map .way")).to_have_count(0)
    await expect(page.locator(".recorded-banner")).to_contain_text("Recorded, not live")
    await expect(page.locator(".recorded-layer")).to_contain_text("RECORDED")
    await expect(page.locator(".recorded-picture")).to_contain_text("No picture of this moment")
    log = page.get_by_label("Log of the recording")
    await expect(log).to_contain_text("Off it went")
    await expect(log).not_to_contain_text("The middle of the flight")
    there = page.locator(".recorded-layer .then")
    first = await there.get_attribute("transform")
    await scrub(page, 320.0)
    await expect(log).to_contain_text("The middle of the flight")
    await expect(there).not_to_have_attribute("transform", first or "")
    # The headline, the orders and STOP are those of now.
    await expect(page.locator(".headline")).to_contain_text("Your drone is home")
    await page.go_back()
    await is_live(page)


async def test_a_flight_of_ten_minutes_opens_within_a_second_and_draws_each_frame(
    kept: tuple[Page, Any],
) -> None:
    page, _ = kept
    await page.get_by_label("How far back").select_option("1 h")
    await expect(page.locator(".time-bar .block")).to_be_visible()
    took = await page.evaluate(
        """() => new Promise((done) => {
          const began = performance.now();
          document.querySelector(".time-bar .block").click();
          const look = () =>
            document.querySelector(".recorded-layer .then")?.getAttribute("transform")
              ? done(performance.now() - began) : requestAnimationFrame(look);
          look();
        })"""
    )
    # What a frame costs counts here, and not how many this machine draws beside other work.
    work = await page.evaluate(
        """() => {
          const bar = document.querySelector(".time-bar input");
          const began = performance.now();
          for (let k = 0; k < 100; k++) {
            bar.value = String(6 * k);
            bar.dispatchEvent(new Event("input", { bubbles: true }));
          }
          return (performance.now() - began) / 100;
        }"""
    )
    assert took < 3000.0, f"opened after {took:.0f} ms; 80 to 100 where nothing else runs"
    assert work < 16.0, f"{work:.1f} ms a frame"


@pytest.mark.parametrize(
    "what",
    [
        "fault",
        *(pytest.param(what, marks=pytest.mark.interop) for what in ("flight", "stop", "goal")),
    ],
)
async def test_what_happens_now_brings_the_present_back(
    kept: tuple[Page, Any], until: Until, what: str
) -> None:
    page, console = kept
    await opened(page)
    words = {
        "fault": "Live again: the battery is loose",
        "flight": "Live again: the drone may be in the air",
        "stop": "Live again: STOP was pressed",
        "goal": "Live again: a goal was chosen",
    }[what]
    if what == "fault":
        console.pilot.add_event(Severity.FAULT, "going_on", "the battery is loose")
    elif what == "flight":
        console.pilot.status = DroneStatus.FLYING
        console.pilot.phase = Phase.HOLDING
    elif what == "stop":
        await page.locator(".stop").click()
        await until(lambda: console.stops)
    else:
        await choose_place(page, "Entrance")
    await expect(page.locator(".time-bar")).to_contain_text(words)
    await is_live(page)


async def test_no_recording_is_opened_while_the_drone_flies(kept: tuple[Page, Any]) -> None:
    page, console = kept
    console.pilot.status, console.pilot.phase = DroneStatus.FLYING, Phase.HOLDING
    await page.get_by_label("How far back").select_option("1 h")
    await expect(page.locator(".app")).to_have_attribute("data-flying", "true")
    await page.get_by_role("button", name=FLIGHT).click(force=True)
    await expect(page.locator(".time-bar")).to_contain_text("what is live stays on the screen")
    await is_live(page)


async def test_a_damaged_log_is_refused_in_words(kept: tuple[Page, Any], tmp_path: Any) -> None:
    page, _ = kept
    (log,) = (tmp_path / "flights").iterdir()
    rows = log.read_text().splitlines(keepends=True)
    log.write_text("".join([rows[0], "rubbish\n", *rows[1:]]))
    await page.get_by_label("How far back").select_option("1 h")
    await page.get_by_role("button", name=FLIGHT).click()
    await expect(page.locator(".time-bar")).to_contain_text("is damaged in line 2")
    await is_live(page)


async def test_the_curve_that_is_flown_shows_speed_height_and_where_it_can_stop(
    page_in_space: Page,
) -> None:
    page = page_in_space
    kinds = await page.locator(".curve .speed").evaluate_all(
        "all => all.map((one) => one.dataset.speed)"
    )
    assert kinds == sorted(kinds[: len(kinds) // 2]) + sorted(
        kinds[len(kinds) // 2 :], reverse=True
    )
    assert {"0", "4"} <= set(kinds)
    assert await page.locator(".curve .second").count() == int(TIMES[-1])
    profile = page.locator(".profile svg")
    await expect(profile).to_have_attribute(
        "aria-label", re.compile(r"height 1\.0 to 1\.3 m over 4\.1 m in 13 s, up to 0\.5 m/s")
    )
    await expect(page.locator(".profile")).to_contain_text("± 4 mm in the plane")
    await expect(page.locator(".map .legend")).to_contain_text("0 to 0.5 m/s")


@pytest_asyncio.fixture(loop_scope="session")
async def page_in_space(console: Any, chromium: Browser) -> AsyncIterator[Page]:
    """Yield the console while a path in space is flown."""
    context = await chromium.new_context(viewport={"width": 1280, "height": 800})
    page = await context.new_page()
    await page.goto(console.link)
    points = [
        TrajectoryPoint((*place, height), at, speed)
        for place, height, at, speed in zip(WAY, HEIGHTS, TIMES, SPEEDS, strict=True)
    ]
    console.pilot.path = Path(WAY, 4.1, 0.4)
    console.bus.publish(TOPICS.trajectory, PlannedTrajectory(0.0, tuple(points)))
    console.pilot.status, console.pilot.phase = DroneStatus.FLYING, Phase.HOLDING
    await expect(page.locator(".curve .speed").first).to_be_visible()
    yield page
    await context.close()


async def test_without_webgl_the_view_in_space_says_so_and_the_plan_comes_back(
    console: Any, chromium: Browser
) -> None:
    context = await chromium.new_context(viewport={"width": 1280, "height": 800})
    page = await context.new_page()
    await page.add_init_script(
        """const real = HTMLCanvasElement.prototype.getContext;
        HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
          return /webgl/.test(kind) ? null : real.call(this, kind, ...more);
        };"""
    )
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    await page.goto(console.link)
    await expect(page.locator(".drone")).to_be_visible()
    await asyncio.sleep(2.0)
    assert not [url for url in asked if "room-in-space" in url], "fetched before it is wanted"
    await page.get_by_role("button", name="3-D").click()
    await expect(page.locator(".space-view")).to_contain_text("cannot draw in space")
    await page.locator(".turns .to-space").click()
    await expect(page.locator(".drone")).to_be_visible()
    await context.close()
