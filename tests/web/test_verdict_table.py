"""Every state with every fault at five sizes in Chromium, with pictures: ``make interop``.

The pilot is the fake one, which knows where it is: each headline is held against that.
"""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import pytest_asyncio
from console_report import FIVE_SIZES, ConsoleReport, console_report
from fake_room import EXAMPLE_CHECKS
from playwright.async_api import Browser, Page, expect

from housefly.messages import DroneStatus, Order, OrderKind, Phase, SafetyMode, Severity

pytestmark = [
    pytest.mark.browser,
    pytest.mark.interop,
    pytest.mark.slow,
    pytest.mark.asyncio(loop_scope="session"),
]

Change = Callable[[Any], None]


def on_pad(pilot: Any) -> None:
    pilot.status, pilot.phase, pilot.position, pilot.height = _DOWN, Phase.IDLE, (1.0, 1.0), 0.0
    pilot.mission, pilot.path = None, None


def flying(pilot: Any) -> None:
    pilot.status, pilot.position, pilot.height = DroneStatus.FLYING, (1.0, 1.0), 1.1
    pilot._set_out(Order(OrderKind.SERVICE, "entrance", look_s=60.0), True)


def landed_away(pilot: Any) -> None:
    on_pad(pilot)
    pilot.position = (4.2, 3.3)


def low_battery(pilot: Any) -> None:
    pilot.battery = 0.12
    pilot.checks = (replace(EXAMPLE_CHECKS[0], passed=False, value="12%"), *EXAMPLE_CHECKS[1:])


def crash(pilot: Any) -> None:
    on_pad(pilot)
    pilot.status, pilot.position = DroneStatus.EMERGENCY, (3.4, 2.0)


def twin_gone(pilot: Any) -> None:
    pilot.telemetry_age, pilot.pose_age, pilot.connected = 9.0, 9.0, False
    pilot.link_notes = ("nobody answers at 127.0.0.1:8010",)


def camera_gone(pilot: Any) -> None:
    pilot.link_notes = ("no picture for 9 s",)


def refusal(pilot: Any) -> None:
    words = "service sofa refused: the charge is not enough for the way"
    pilot.add_event(Severity.WARNING, "order_refused", words)


_DOWN = DroneStatus.LANDED
STATES: dict[str, Change] = {"on the pad": on_pad, "flying": flying, "landed away": landed_away}
FAULTS: dict[str, Change] = {
    "no fault": lambda pilot: None,
    "tracking lost": lambda pilot: setattr(pilot, "pose_age", 9.8),
    "pilot gone": lambda pilot: setattr(pilot, "publishing", False),
    "twin gone": twin_gone,
    "camera gone": camera_gone,
    "refusal": refusal,
    "crash": crash,
    "battery low": low_battery,
    "STOP": lambda pilot: None,
    "STOP unconfirmed": lambda pilot: setattr(pilot, "publishing", False),
}
"""The console's own death is flown in ``test_browser_verdict``; hub and tasks are no flight's."""
ROWS = [(state, fault) for state in STATES for fault in FAULTS]


@pytest_asyncio.fixture(loop_scope="session", scope="module")
async def house(
    chromium: Browser, serving: Any, tmp_path_factory: pytest.TempPathFactory
) -> AsyncIterator[tuple[Any, Page, ConsoleReport]]:
    report = console_report("fake", tmp_path_factory.mktemp("report"))
    async with serving("127.0.0.1") as served:
        page = await chromium.new_page()
        await page.goto(served.link)
        yield served, page, report
        await page.close()


@pytest.mark.parametrize(("state", "fault"), ROWS, ids=[" - ".join(row) for row in ROWS])
async def test_the_headline_is_true(
    house: tuple[Any, Page, ConsoleReport], state: str, fault: str
) -> None:
    served, page, report = house
    pilot = served.pilot
    await restore(pilot, page)
    STATES[state](pilot)
    await asyncio.sleep(1.5)
    FAULTS[fault](pilot)
    if fault.startswith("STOP"):
        await asyncio.sleep(2.5 if "unconfirmed" in fault else 0.3)
        await page.locator(".stop").click()
    await asyncio.sleep(4.0 if not pilot.publishing else 1.5)
    pictures: list[str] = []
    for width, height in FIVE_SIZES:
        await page.set_viewport_size({"width": width, "height": height})
        await asyncio.sleep(0.2)
        name = f"{state}-{fault}-{width}x{height}.png".replace(" ", "-")
        await page.screenshot(path=Path(report.folder, name))
        pictures.append(name)
        await expect(page.locator(".headline")).to_be_in_viewport(ratio=1)
        await expect(page.locator(".stop")).to_be_in_viewport(ratio=1)
        await banner_is_read(page)
    line = " / ".join((await page.locator(".headline").inner_text()).split("\n"))
    bar = " ".join((await page.locator(".stop").inner_text()).split())
    x, y = pilot.position
    truth = f"{pilot.status.value} at {x:.1f}, {y:.1f} m, pad at 1.0, 1.0 m"
    report.add(state, fault, f"{line} | {bar}", truth, pictures)
    hold_against(pilot, fault, line, bar)


async def banner_is_read(page: Page) -> None:
    """Fail when what must be read first is cut off, or covers STOP."""
    banner = await page.locator(".banner").bounding_box()
    stop = await page.locator(".stop").bounding_box()
    if banner is None or stop is None:
        return
    await expect(page.locator(".banner")).to_be_in_viewport(ratio=1)
    beside = banner["x"] + banner["width"] <= stop["x"]
    assert beside or banner["y"] + banner["height"] <= stop["y"], (banner, stop)


async def restore(pilot: Any, page: Page) -> None:
    pilot.publishing, pilot.pose_age, pilot.telemetry_age, pilot.connected = True, 0.024, 0.03, True
    pilot.checks, pilot.link_notes, pilot.battery, pilot.stopped = EXAMPLE_CHECKS, (), 0.86, True
    await asyncio.sleep(0.3)  # a STOP of the row before is taken, and then resumed
    pilot.stopped = False
    on_pad(pilot)
    await page.set_viewport_size({"width": 1280, "height": 800})
    await expect(page.locator(".stop")).to_have_attribute("data-progress", "none")
    await expect(page.locator(".headline")).to_contain_text("Your drone is home")


def hold_against(pilot: Any, fault: str, line: str, bar: str) -> None:
    """Compare what is said with what is so."""
    is_up = pilot.status in (DroneStatus.FLYING, DroneStatus.TAKING_OFF, DroneStatus.LANDING)
    at_home = pilot.position == (1.0, 1.0)
    is_heard = pilot.publishing and pilot.telemetry_age < 1.0
    is_well = is_heard and pilot.pose_age < 0.5 and pilot.battery > 0.2
    is_free = is_well and not pilot.stopped and pilot.status is DroneStatus.LANDED
    assert ("Your drone is home" in line) == (is_free and at_home), line
    assert ("Not on the pad" in line) == (is_free and not at_home), line
    assert ("No contact with the pilot" in line) == (not pilot.publishing), line
    assert is_heard or not line.startswith(("Flying", "Hovering", "Stopped")), line
    assert is_up or not line.startswith(("Flying", "Hovering", "Landing")), line
    assert ("STOP FAILED" in bar) == (fault == "STOP unconfirmed"), bar
    assert ("STOPPED" in bar) == (fault == "STOP"), bar
    assert fault != "crash" or "Motors are cut" in line, line
    assert SafetyMode.STOPPED.value not in line or pilot.stopped
