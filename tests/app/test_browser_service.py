"""A whole service by clicks in Chromium, on real processes, some of which die in between."""

import http.client
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import psutil
import pytest
from installed_chromium import chromium_path
from playwright.sync_api import Locator, Page, expect, sync_playwright

pytestmark = [
    pytest.mark.wire,
    pytest.mark.realtime,
    pytest.mark.interop,
    pytest.mark.browser,
    pytest.mark.slow,
]

FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-background-networking",
    "--disable-component-update",
    "--no-first-run",
]


class Demo:
    """A running ``housefly demo``."""

    def __init__(self, site: Path, log: Path) -> None:
        self._log = log
        command = [sys.executable, "-m", "housefly.cli", "run", "--site", str(site)]
        self.process = subprocess.Popen(command, stdout=log.open("w"), stderr=subprocess.STDOUT)
        try:
            self.url = self._wait_for(r"http://\S+", 60.0)
            assert answers(self.url), "the address is printed only once it answers"
            self._wait_for("ready after", 120.0)
        except AssertionError:
            self.leave()
            raise

    def part(self, words: str) -> psutil.Process:
        """Return the process whose command line has these words."""
        for child in psutil.Process(self.process.pid).children(recursive=True):
            with suppress(psutil.Error):
                if words in " ".join(child.cmdline()):
                    return child
        raise AssertionError(f"no process with {words!r}")

    def leave(self) -> int:
        """Press Ctrl-C and return the exit code."""
        self.process.send_signal(signal.SIGINT)
        return self.process.wait(60)

    def _wait_for(self, pattern: str, timeout: float) -> str:
        deadline = time.monotonic() + timeout
        while time.monotonic() < deadline:
            found = re.search(pattern, self._log.read_text())
            if found:
                return found.group(0)
            time.sleep(0.1)
        raise AssertionError(f"{pattern!r} was not printed:\n{self._log.read_text()}")


def answers(url: str) -> bool:
    """Return whether a server answers at the host of an address now, whatever it says."""
    host = url.split("/")[2]
    line = http.client.HTTPConnection(host, timeout=1.0)
    try:
        line.request("HEAD", "/")
        return line.getresponse().status < 500
    except OSError:
        return False
    finally:
        line.close()


@pytest.fixture
def demo(tmp_path: Path, write_site: Any) -> Iterator[Demo]:
    running = Demo(write_site(video=True), tmp_path / "demo.log")
    yield running
    if running.process.poll() is None:
        running.leave()


@pytest.fixture
def page() -> Iterator[Page]:
    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=chromium_path(), args=FLAGS)
        yield browser.new_page(viewport={"width": 1280, "height": 800})
        browser.close()


def hold(page: Page, button: Locator, seconds: float) -> None:
    box = button.bounding_box()
    assert box is not None
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.wait_for_timeout(seconds * 1000)
    page.mouse.up()


def state(page: Page, words: str) -> Locator:
    return page.get_by_role("banner").get_by_text(words)


def picture(page: Page) -> bytes:
    return page.locator("canvas").first.screenshot()


def send_to_the_entrance(page: Page) -> None:
    page.get_by_role("button", name="Fly to …").first.click()
    page.get_by_role("button", name="Entrance", exact=True).click()
    go = page.get_by_role("button", name="Look at Entrance and come back")
    expect(go).to_be_enabled()
    page.wait_for_timeout(500)
    hold(page, go, 0.9)
    with suppress(AssertionError):
        expect(state(page, "Your drone is home")).not_to_be_visible(timeout=10_000)
        return
    if not go.count():  # on a starved machine an order may be too old for the pilot
        page.get_by_role("button", name="Fly to …").first.click()
        page.get_by_role("button", name="Entrance", exact=True).click()
        page.wait_for_timeout(1500)
    hold(page, go, 3.0)  # a starved browser does not count the first one


@pytest.mark.interop
@pytest.mark.timeout(240)
def test_a_person_flies_the_whole_service_by_clicks_and_sees_pictures_change(
    demo: Demo, page: Page
) -> None:
    hosts: set[str] = set()
    page.on("request", lambda request: hosts.add(request.url.split("/")[2].split(":")[0]))
    page.goto(demo.url)
    expect(state(page, "Your drone is home")).to_be_visible(timeout=60_000)
    expect(page.get_by_text("people without markers are unseen")).to_be_visible()
    page.wait_for_timeout(1500)
    on_the_pad = picture(page)
    send_to_the_entrance(page)
    expect(state(page, "Looking at Entrance")).to_be_visible(timeout=60_000)
    at_the_door = picture(page)
    assert at_the_door != on_the_pad
    expect(state(page, "Your drone is home")).to_be_visible(timeout=90_000)
    assert picture(page) != at_the_door
    assert hosts == {"127.0.0.1"}
    assert demo.leave() == 0


@pytest.mark.interop
@pytest.mark.timeout(240)
def test_what_landed_away_is_put_back_and_charged_by_hands_and_flies_again(
    demo: Demo, page: Page
) -> None:
    page.goto(demo.url)
    expect(state(page, "Your drone is home")).to_be_visible(timeout=60_000)
    strip = page.get_by_role("region", name="Simulated room")
    strip.get_by_text("Simulated room").click()
    send_to_the_entrance(page)
    expect(state(page, "Flying to Entrance")).to_be_visible(timeout=60_000)
    page.wait_for_timeout(3000)
    strip.get_by_role("button", name="Put it on its pad").click()
    expect(strip.get_by_role("status")).to_contain_text("Nobody takes hold of a drone")
    page.get_by_role("button", name="Land", exact=True).click()
    expect(state(page, "Not on the pad")).to_be_visible(timeout=30_000)
    expect(page.get_by_role("button", name="Fly home")).to_be_enabled()
    strip.get_by_role("button", name="Put it on its pad").click()
    expect(strip.get_by_role("status")).to_contain_text("Somebody carries the drone to its pad")
    strip.get_by_role("button", name="Charge it").click()
    expect(strip.get_by_role("status")).to_contain_text("full battery")
    expect(state(page, "Your drone is home")).to_be_visible(timeout=60_000)
    page.get_by_role("button", name="Details", exact=True).click()
    expect(page.locator(".battery .number")).to_have_text("100 %")
    page.wait_for_timeout(3000)  # the hands have let go
    send_to_the_entrance(page)
    expect(state(page, "Flying to Entrance")).to_be_visible(timeout=60_000)
    assert demo.leave() == 0


@pytest.mark.timeout(240)
def test_the_flight_goes_on_when_console_and_camera_are_killed_and_both_come_back(
    demo: Demo, page: Page
) -> None:
    hosts: set[str] = set()
    page.on("request", lambda request: hosts.add(request.url.split("/")[2].split(":")[0]))
    page.goto(demo.url)
    expect(state(page, "Your drone is home")).to_be_visible(timeout=60_000)
    expect(page.get_by_text("people without markers are unseen")).to_be_visible()
    page.wait_for_timeout(1500)
    on_the_pad = picture(page)
    send_to_the_entrance(page)
    expect(state(page, "Flying to Entrance")).to_be_visible(timeout=30_000)
    for words in ("housefly.web.process", "camera"):
        os.kill(demo.part(words).pid, signal.SIGKILL)
    expect(state(page, "Looking at Entrance")).to_be_visible(timeout=60_000)
    page.wait_for_timeout(1000)
    at_the_door = picture(page)
    assert at_the_door != on_the_pad
    expect(state(page, "Coming home")).to_be_visible(timeout=30_000)
    page.wait_for_timeout(3000)
    assert picture(page) != at_the_door
    expect(state(page, "Your drone is home")).to_be_visible(timeout=90_000)
    assert hosts == {"127.0.0.1"}
    assert demo.leave() == 0


@pytest.mark.interop
@pytest.mark.timeout(240)
def test_a_killed_pilot_leaves_the_drone_to_its_watchdog_and_the_next_one_moves_nothing(
    demo: Demo, page: Page
) -> None:
    page.goto(demo.url)
    expect(state(page, "Your drone is home")).to_be_visible(timeout=60_000)
    send_to_the_entrance(page)
    expect(state(page, "Flying to Entrance")).to_be_visible(timeout=30_000)
    page.wait_for_timeout(3000)
    os.kill(demo.part("housefly.app.pilot_main").pid, signal.SIGKILL)
    page.wait_for_timeout(12_000)
    expect(state(page, "Flying to Entrance")).not_to_be_visible()
    page.get_by_role("button", name="Details", exact=True).click()
    position = page.get_by_text(re.compile(r"^\s*\d+\.\d\d\s+\d+\.\d\d"))
    before = position.first.inner_text()
    page.wait_for_timeout(4000)
    after = position.first.inner_text()
    x0, y0 = (float(part) for part in before.split()[:2])
    x1, y1 = (float(part) for part in after.split()[:2])
    assert abs(x1 - x0) < 0.5 and abs(y1 - y0) < 0.5
