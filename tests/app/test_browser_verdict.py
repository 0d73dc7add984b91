"""What the console says in a fault, held against the truth of one live house in Chromium.

One house for all tests of this file, in this order; its room is outside of it.
"""

from __future__ import annotations

import os
import re
import signal
import time
from collections.abc import Callable, Iterator
from math import dist
from typing import Any

import pytest
from console_report import FIVE_SIZES, ConsoleReport, console_report
from installed_chromium import chromium_path
from outside_room import OutsideRoom, Run, outside_site, running_outside, wait_for
from playwright.sync_api import Locator, Page, expect, sync_playwright

from housefly.geometry import Vec2, yaw_of
from housefly.twin.contracts import FlightState
from housefly.twin.disturbance import Disturbances
from housefly.twin.hands import CarryOrder

pytestmark = [
    pytest.mark.wire,
    pytest.mark.realtime,
    pytest.mark.browser,
    pytest.mark.slow,
    pytest.mark.interop,
    pytest.mark.timeout(300),
]

UNDER_THE_TABLE = (5.7, 1.5)
FLAGS = ["--no-sandbox", "--disable-gpu", "--disable-background-networking", "--no-first-run"]
DOWN = ("Your drone is home", "Not on the pad", "Not ready", "On the pad", "On the ground")
UP = ("Taking off", "Flying to", "Looking at", "Coming home", "Hovering", "Landing", "HOLDING")


class House:
    """The run, its room, and the page of who flies."""

    def __init__(self, room: OutsideRoom, run: Run, page: Page, report: ConsoleReport) -> None:
        self.room, self.run, self.page, self.report = room, run, page, report
        self.pad = room.world.truth().pose.position[:2]

    @property
    def away(self) -> float:
        """How far the drone truly is from its pad [m]."""
        return dist(self.room.world.truth().pose.position[:2], self.pad)

    @property
    def flies(self) -> bool:
        """Whether it is truly off the ground."""
        return self.room.world.onboard().flight is not FlightState.LANDED

    def kill(self, module: str) -> None:
        """Kill a process; the launcher starts it again."""
        os.kill(self.run.part(module).pid, signal.SIGKILL)

    def headline(self) -> str:
        return " / ".join(self.page.locator(".headline").inner_text().split("\n"))

    def says(self, words: str, patience: float = 30.0) -> None:
        expect(self.page.locator(".headline")).to_contain_text(words, timeout=1000 * patience)

    def hold_against_truth(self, state: str, fault: str) -> None:
        """Compare the headline with what is true, and keep a picture of each size."""
        pictures = []
        for width, height in FIVE_SIZES:
            self.page.set_viewport_size({"width": width, "height": height})
            self.page.wait_for_timeout(250)
            self.compare()
            name = f"{state}-{fault}-{width}x{height}.png".replace(" ", "-")
            self.page.screenshot(path=self.report.folder / name)
            pictures.append(name)
        self.page.set_viewport_size({"width": 1280, "height": 800})
        flight = "in the air" if self.flies else "on the ground"
        truth = f"{flight}, {self.away:.2f} m from the pad"
        self.report.add(state, fault, self.headline(), truth, pictures)

    def compare(self) -> None:
        """One headline against one truth; what has just changed is asked again."""
        for _ in range(8):
            if not (wrong := self._untruth()):
                return
            self.page.wait_for_timeout(250)
        raise AssertionError(wrong)

    def _untruth(self) -> str:
        line, flies, away = self.headline(), self.flies, self.away
        if line.startswith(DOWN) and flies:
            return f"{line!r}, and it flies"
        if line.startswith(UP) and not flies:
            return f"{line!r}, and it stands"
        if line.startswith("Your drone is home") and away > 0.5:
            return f"{line!r}, and it is {away:.1f} m from its pad"
        told = re.search(r"([\d.]+) m from the pad", line)
        if told and abs(float(told[1]) - away) > 0.3:
            return f"{line!r}, and it is {away:.1f} m from its pad"
        return ""


@pytest.fixture(scope="module")
def house(tmp_path_factory: pytest.TempPathFactory) -> Iterator[House]:
    folder = tmp_path_factory.mktemp("house")
    address = f"127.{1 + os.getpid() % 250}.77.11"
    site = outside_site(folder, address, has_video=True)
    log = folder / "run.log"
    with running_outside(site, log, films=True) as (room, run), sync_playwright() as play:
        found = re.search(r"http://\S+", log.read_text())
        assert found
        browser = play.chromium.launch(executable_path=chromium_path(), args=FLAGS)
        page = browser.new_page(viewport={"width": 1280, "height": 800})
        page.goto(found[0])
        yield House(room, run, page, console_report("live", folder))
        browser.close()
        run.process.send_signal(signal.SIGINT)
        run.process.wait(60)


def hold(page: Page, name: str) -> None:
    """Hold a button; a starved browser has lost control, and takes it back first."""
    take = page.get_by_role("button", name="Take control")
    if take.count():
        press(page, take.first)
        page.wait_for_timeout(500)
    press(page, page.locator(".hold").filter(has_text=name).first)


def press(page: Page, button: Locator) -> None:
    button.hover()
    page.mouse.down()
    page.wait_for_timeout(900)
    page.mouse.up()


def send(house: House, place: str) -> None:
    """Send the drone; a starved browser does not count the first hold."""
    for _ in range(3):
        house.page.get_by_role("button", name="Fly to …").first.click()
        house.page.get_by_role("button", name=place, exact=True).click()
        house.page.wait_for_timeout(800)
        hold(house.page, "and come back")
        try:
            wait_for(lambda: house.flies, 8.0, "a take-off")
        except AssertionError:
            continue
        return
    raise AssertionError(f"no take-off: {house.headline()}")


def test_on_its_pad_it_is_ready_and_without_tracking_it_is_not(house: House) -> None:
    house.says("Your drone is home", 60.0)
    house.hold_against_truth("on the pad", "no fault")
    seen: Callable[[list[Any]], None] = house.room._after_step
    house.room._after_step = lambda tracking: None  # type: ignore[method-assign]
    house.says("Not ready")
    house.says("tracking saw the drone last")
    expect(house.page.locator(".drone .age")).to_contain_text("seen")
    house.hold_against_truth("on the pad", "tracking lost")
    house.room._after_step = seen  # type: ignore[method-assign]
    house.says("Your drone is home")


def test_a_camera_or_a_memory_that_is_gone_is_said_and_hides_nothing_of_the_drone(
    house: House,
) -> None:
    picture = house.page.locator(".view.video")
    expect(picture.locator("canvas[data-picture]")).to_be_visible(timeout=20_000)
    house.room.films = False
    expect(picture).to_contain_text("No new picture", timeout=20_000)
    house.says("Your drone is home")
    house.hold_against_truth("on the pad", "camera gone")
    house.room.films = True
    expect(picture).not_to_contain_text("No new picture", timeout=20_000)
    hub = house.run.part("housefly.hub.process").pid
    os.kill(hub, signal.SIGSTOP)
    shown = house.page.locator(".view.map")
    expect(shown).to_contain_text("People and things are not shown", timeout=40_000)
    house.says("Your drone is home")
    house.hold_against_truth("on the pad", "hub gone")
    os.kill(hub, signal.SIGCONT)
    expect(shown).not_to_contain_text("People and things are not shown", timeout=40_000)


def charge(house: House, share: float) -> None:
    house.room.do(lambda: house.room.world.disturb(Disturbances(charge=share)))


def carry(house: House, place: Vec2) -> None:
    """Let somebody carry it: a drone that leaps is not believed to be the same one."""
    world = house.room.world
    yaw = yaw_of(world.truth().pose.orientation)
    house.room.do(lambda: world.carry_drone(CarryOrder((*place, 0.05), yaw, 4.0)))
    wait_for(lambda: dist(world.truth().pose.position[:2], place) < 0.1, 20.0, "hands")


def test_with_a_low_battery_it_is_not_ready_and_in_flight_it_comes_back_or_lands(
    house: House,
) -> None:
    charge(house, 0.1)
    house.says("Not ready")
    house.says("battery")
    house.hold_against_truth("on the pad", "battery low")
    charge(house, 1.0)
    house.says("Your drone is home", 60.0)
    send(house, "Entrance")
    wait_for(lambda: house.away > 0.7, 40.0, "a drone under way")
    charge(house, 0.1)
    expect(house.page.locator(".headline")).to_contain_text(
        re.compile("Coming home|Landing"), timeout=30_000
    )
    house.hold_against_truth("flying", "battery low")
    wait_for(house.room.is_standing, 60.0, "a landing")
    charge(house, 1.0)
    carry(house, house.pad)
    house.says("Your drone is home", 60.0)


def test_a_crash_under_furniture_is_said_with_where_it_lies_and_flies_only_after_a_reset(
    house: House,
) -> None:
    carry(house, UNDER_THE_TABLE)
    house.room.do(house.room.world.toggle_emergency)
    house.says("Motors are cut")
    house.hold_against_truth("landed away", "crash under the table")
    assert house.away > 1.0
    house.says("reset before the next flight")
    expect(house.page.locator(".headline")).not_to_contain_text("Ready")
    carry(house, house.pad)
    hold(house.page, "Reset")
    house.says("Your drone is home", 60.0)


def test_a_dead_console_says_that_the_flight_goes_on_and_comes_back_with_control_and_log(
    house: House,
) -> None:
    send(house, "Entrance")
    house.says("Flying to Entrance")
    wait_for(lambda: house.away > 0.7, 30.0, "a drone under way")
    house.hold_against_truth("flying", "no fault")
    before = house.away
    os.kill(house.run.part("housefly.web.process").pid, signal.SIGSTOP)
    banner = house.page.locator(".banner")
    expect(banner).to_contain_text("it flies on to Entrance, then comes home", timeout=10_000)
    house.says("No contact with the server")
    house.compare()
    assert house.flies and house.away > before, "it is true: the flight goes on"
    pictures = house.report.folder / "flying-console-killed.png"
    house.page.screenshot(path=pictures)
    house.report.add("flying", "console killed", banner.inner_text(), "flies on", [pictures.name])
    house.kill("housefly.web.process")
    expect(banner).to_be_hidden(timeout=30_000)
    expect(house.page.locator(".who")).to_contain_text("You have control")
    house.page.get_by_role("button", name="Details", exact=True).click()
    log = house.page.locator(".log ol")
    expect(log).to_contain_text("console was started again")
    expect(log).to_contain_text("Service entrance")


def test_a_stop_in_flight_outlives_the_pilot_and_what_lies_away_from_its_pad_is_said_to(
    house: House,
) -> None:
    house.says("Your drone is home", 90.0)
    send(house, "Entrance")
    wait_for(lambda: house.away > 1.5, 40.0, "a drone under way")
    house.page.keyboard.press("Space")
    expect(house.page.locator(".stop")).to_contain_text("STOPPED", timeout=10_000)
    house.hold_against_truth("flying", "STOP")
    house.kill("housefly.app.pilot_main")
    house.says("No contact with the pilot", 10.0)
    expect(house.page.locator(".banner")).to_contain_text("brakes and lands by itself")
    house.hold_against_truth("flying", "pilot killed")
    wait_for(house.room.is_standing, 30.0, "the landing of the driver's watchdog")
    expect(house.page.locator(".banner")).to_be_hidden(timeout=60_000)
    expect(house.page.locator(".stop")).to_contain_text("STOPPED", timeout=10_000)
    house.says("m from the pad; stays down until you resume")
    house.hold_against_truth("landed away", "pilot restarted under STOP")
    for _ in range(3):  # a starved browser does not count the first hold
        hold(house.page, "Resume")
        house.page.wait_for_timeout(1500)
        if house.page.locator(".resume").count() == 0:
            break
    expect(house.page.locator(".stop")).not_to_contain_text("STOPPED", timeout=10_000)
    house.says("Not on the pad")
    house.hold_against_truth("landed away", "no fault")


def test_without_the_room_nothing_is_said_to_be_ready(house: House) -> None:
    house.room._stop.set()
    house.says("Waiting for the drone", 20.0)
    started = time.monotonic()
    while time.monotonic() < started + 3.0:
        assert "Ready" not in house.headline() and "pad" not in house.headline()
    pictures = house.report.folder / "nothing-answers.png"
    house.page.screenshot(path=pictures)
    house.report.add("landed", "drone gone", house.headline(), "nobody knows", [pictures.name])
