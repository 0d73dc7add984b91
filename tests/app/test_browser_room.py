"""A simulated person puts the cup into the cabinet, and the ROOM screen shows it."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest
from installed_chromium import chromium_path
from playwright.sync_api import Page, expect, sync_playwright

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

SCENE = """
name = "A cup is tidied away"
seed = 1
loop = false

[[things]]
name = "cup"
tag = "E200-0001"
weight = 0.21
inside = "refrigerator"

[[devices]]
kind = "floor"
id = "floor-1"
area = [4.8, 0.6, 14.7, 6.2]

[[devices]]
kind = "cabinet"
id = "cabinet"
position = [11.50, 4.20, 0.60]

[[devices]]
kind = "refrigerator"
id = "refrigerator"
position = [7.18, 5.82, 0.60]

[[people]]
name = "person-1"
start = [7.25, 4.95]
steps = [
    { do = "wait", seconds = 24.0 },
    { do = "open", what = "refrigerator" },
    { do = "take", thing = "cup" },
    { do = "close", what = "refrigerator" },
    { do = "go", to = [9.6, 4.3], speed = 1.5 },
    { do = "go", to = [11.95, 4.65], speed = 1.5 },
    { do = "go", to = [11.95, 4.2], speed = 1.5 },
    { do = "put", thing = "cup", into = "cabinet" },
    { do = "wait", seconds = 60.0 },
]
"""

THINGS = """
[[thing]]
id = "cup"
name = "the cup"
aliases = ["mug"]

[[thing]]
id = "cabinet"
name = "the cabinet"
kind = "furniture"
position = [11.50, 4.20, 0.60]

[[thing]]
id = "person-1"
name = "the resident"
kind = "person"
"""

SITE = """
scene = "{folder}/scene.toml"
[mqtt]
broker = "127.0.0.1"
port = 0
start = true
[[mqtt.tags]]
tag = "E200-0001"
thing = "cup"
"""


def wait_for(log: Path, pattern: str, seconds: float) -> str:
    """Wait until a line with the pattern was printed, and return what matched."""
    deadline = time.monotonic() + seconds
    while time.monotonic() < deadline:
        if found := re.search(pattern, log.read_text()):
            return found[0]
        time.sleep(0.1)
    raise AssertionError(f"{pattern!r} was not printed:\n{log.read_text()}")


@pytest.fixture
def address(tmp_path: Path, write_site: Any) -> Iterator[str]:
    """Run the site with its scene and yield the console's address."""
    (tmp_path / "scene.toml").write_text(SCENE)
    (tmp_path / "things.toml").write_text(THINGS)
    site: Path = write_site()
    things = f'[hub]\nthings = "{tmp_path}/things.toml"\n'
    text = site.read_text().replace("[hub]\n", things)
    site.write_text(text + SITE.format(folder=tmp_path))
    log = tmp_path / "run.log"
    with log.open("w") as output:
        command = [sys.executable, "-m", "housefly.cli", "run", "--site", str(site)]
        process = subprocess.Popen(command, stdout=output, stderr=subprocess.STDOUT)
    try:
        found = wait_for(log, r"http://\S+", 90.0)
        wait_for(log, "ready after", 60.0)
        yield found
    finally:
        process.send_signal(signal.SIGINT)
        process.wait(60)


@pytest.fixture
def page() -> Iterator[Page]:
    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=chromium_path(), args=FLAGS)
        yield browser.new_page(viewport={"width": 1280, "height": 800})
        browser.close()


@pytest.mark.timeout(300)
def test_the_room_says_where_the_cup_is_and_where_it_was(address: str, page: Page) -> None:
    hosts: set[str] = set()
    page.on("request", lambda request: hosts.add(request.url.split("/")[2].split(":")[0]))
    before = time.time()
    page.goto(address)
    answer, past = page.locator(".answer"), page.locator(".past-banner")
    expect(page.locator(".thing-mark[data-thing='person-1']")).to_contain_text(
        "the resident", timeout=15_000
    )
    page.get_by_role("combobox", name="Where is").fill("mug")
    page.keyboard.press("Enter")
    expect(answer).to_contain_text("in the cabinet", timeout=60_000)
    expect(page.locator(".thing-mark[data-thing='cabinet']")).to_contain_text("in it: the cup")
    expect(page.locator(".feed")).to_contain_text("The cup")
    page.get_by_role("button", name="Details", exact=True).click()
    expect(page.locator(".log")).to_contain_text("Object put: the cup (the cabinet)")
    expect(page.locator(".sensors li").filter(has_text="cabinet")).to_have_attribute(
        "data-health", "well"
    )
    expect(past).to_have_count(0)

    page.get_by_role("button", name="Earlier", exact=True).first.click()
    slider = page.get_by_role("slider", name="Time shown")
    for earlier in range(0, 60, 3):  # the resident may have been faster than a slow browser
        slider.fill(str(-round(time.time() - before) - earlier))
        expect(past).to_contain_text("The past")
        with suppress(AssertionError):
            expect(answer).to_contain_text("in refrigerator", timeout=2_000)
            break
    expect(answer).to_contain_text("in refrigerator")
    expect(page.locator(".thing-mark[data-thing='refrigerator']")).to_contain_text("in it: the cup")
    expect(page.locator(".stop")).to_be_visible()

    page.get_by_role("button", name="Back to now").click()
    expect(past).to_have_count(0)
    expect(answer).to_contain_text("in the cabinet")
    assert hosts == {"127.0.0.1"}
