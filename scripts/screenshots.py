"""Takes the pictures of the README: flies services in a simulated room; console, tasks, report.

``python scripts/screenshots.py`` writes docs/images/*.png.
"""

from __future__ import annotations

import json
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from paho.mqtt import publish
from playwright.sync_api import Browser, Locator, Page, expect, sync_playwright

IMAGES = Path(__file__).resolve().parents[1] / "docs" / "images"
DESKTOP, PHONE = {"width": 1280, "height": 800}, {"width": 390, "height": 844}
FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-background-networking",
    "--disable-component-update",
    "--no-first-run",
]

SCENE = """
name = "Somebody stands at the door"
seed = 1
loop = false

[[people]]
name = "visitor"
visitor = true
steps = [
    { do = "wait", seconds = 0.2 },
    { do = "appear", at = [0.85, 4.20] },
    { do = "wait", seconds = 900.0 },
]
"""
SITE = """
name = "Home"
[drone]
address = "127.30.1.2"
has_video = true
[tracking]
kind = "vicon"
address = "127.30.1.2"
[hub]
store = "{folder}/room.db"
[web]
port = 8091
[twin]
seed = 1
video = true
scene = "{folder}/scene.toml"
[mqtt]
broker = "127.0.0.1"
port = {port}
start = true
site = "home"
"""
BELL = "housefly/home/doorbell/doorbell/event"


def housefly(*arguments: str, **options: object) -> subprocess.Popen[str]:
    """Start a command of Housefly."""
    return subprocess.Popen(
        [sys.executable, "-m", "housefly.cli", *arguments], text=True, **options
    )  # type: ignore[call-overload,no-any-return]


def address_in(log: Path) -> str:
    """Wait until the demo is ready and return the console's address."""
    for _ in range(600):
        text = log.read_text()
        if "ready after" in text:
            return re.findall(r"http://\S+", text)[0]
        time.sleep(0.1)
    sys.exit(f"the demo did not get ready:\n{log.read_text()}")


def state(page: Page, words: str) -> Locator:
    """Return the state line of the console with these words."""
    return page.get_by_role("banner").get_by_text(words)


def photograph(pages: dict[str, Page], moment: str) -> None:
    """Save a picture of each page."""
    for name, page in pages.items():
        page.screenshot(path=IMAGES / f"{name}-{moment}.png")
        print(f"{name}-{moment}.png")


def hold(page: Page, button: Locator) -> None:
    """Hold a button as long as it asks for."""
    box = button.bounding_box()
    assert box is not None
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.wait_for_timeout(900)
    page.mouse.up()


def fly(browser: Browser, address: str) -> None:
    """Fly the service and photograph it on its way."""
    context = browser.new_context(viewport=DESKTOP, color_scheme="light")
    desktop = context.new_page()
    desktop.goto(address)
    phone = context.new_page()
    phone.set_viewport_size(PHONE)
    phone.goto(address.split("?")[0])
    dark = context.new_page()
    dark.emulate_media(color_scheme="dark")
    dark.goto(address.split("?")[0])
    expect(state(desktop, "Ready on the pad")).to_be_visible(timeout=15_000)
    desktop.get_by_role("button", name="Entrance", exact=True).click()
    desktop.wait_for_timeout(2000)
    photograph({"console": desktop, "phone": phone}, "ready")
    hold(desktop, desktop.get_by_role("button", name="Send to look and come back"))
    expect(state(desktop, "Flying to Entrance")).to_be_visible(timeout=30_000)
    desktop.wait_for_timeout(7500)
    photograph({"console": desktop, "phone": phone}, "flying")
    expect(state(desktop, "Looking at Entrance")).to_be_visible(timeout=60_000)
    desktop.wait_for_timeout(1500)
    photograph({"console": desktop, "phone": phone, "console-dark": dark}, "arrived")
    expect(state(desktop, "Ready on the pad")).to_be_visible(timeout=90_000)


def ring(port: int) -> None:
    """Press the bell at the door, as a device does."""
    publish.single(BELL, json.dumps({"event": "pressed"}), hostname="127.0.0.1", port=port)


def look_who_rings(browser: Browser, address: str, port: int) -> None:
    """Let the bell ring, say yes, and photograph question, tasks and clip."""
    context = browser.new_context(viewport=DESKTOP, color_scheme="light")
    desktop = context.new_page()
    desktop.goto(address)
    phone = context.new_page()
    phone.set_viewport_size(PHONE)
    phone.goto(address.split("?")[0] + "#tasks")
    expect(state(desktop, "Ready on the pad")).to_be_visible(timeout=30_000)
    expect(
        phone.get_by_role("region", name="Services").get_by_role("listitem").first
    ).to_be_visible(timeout=30_000)
    ring(port)
    question = desktop.get_by_role("article")
    expect(question.locator(".rehearsal")).to_be_visible(timeout=60_000)
    photograph({"console": desktop, "phone": phone}, "question")
    hold(desktop, question.get_by_role("button").first)
    desktop.get_by_role("navigation").get_by_role("button", name="Tasks").click()
    expect(desktop.get_by_role("banner")).to_contain_text("recording", timeout=120_000)
    desktop.wait_for_timeout(6000)
    desktop.screenshot(path=IMAGES / "tasks.png")
    phone.screenshot(path=IMAGES / "phone-tasks.png")
    desktop.get_by_role("button", name="Come home").click(timeout=60_000)
    expect(state(desktop, "Ready on the pad")).to_be_visible(timeout=120_000)
    expect(desktop.get_by_role("region", name="Now").get_by_role("listitem")).to_have_count(
        0, timeout=30_000
    )
    for page in (desktop, phone):
        page.get_by_role("tabpanel").locator("summary").first.click()
    desktop.wait_for_timeout(1000)
    desktop.screenshot(path=IMAGES / "tasks-history.png")
    for page, name in ((desktop, "tasks-clip.png"), (phone, "phone-tasks-clip.png")):
        page.get_by_role("button", name="Show clip").click()
        page.wait_for_timeout(8000)
        page.screenshot(path=IMAGES / name)
        print(name)


def photograph_tasks(browser: Browser, folder: Path) -> None:
    """Run a site with a bell at the door, and photograph what is asked for there."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = int(probe.getsockname()[1])
    (folder / "scene.toml").write_text(SCENE)
    (folder / "site.toml").write_text(SITE.format(folder=folder, port=port))
    log = folder / "tasks.log"
    command = ("run", "--site", str(folder / "site.toml"))
    home = housefly(*command, stdout=log.open("w"), stderr=subprocess.STDOUT)
    try:
        look_who_rings(browser, address_in(log), port)
    finally:
        home.send_signal(signal.SIGINT)
        home.wait(60)


def photograph_report(browser: Browser, folder: Path) -> None:
    """Fly in lock step and photograph the report."""
    housefly(
        "fly",
        "entrance",
        "--headless",
        "--lockstep",
        "--out",
        str(folder),
        stdout=subprocess.DEVNULL,
    ).wait()
    page = browser.new_page(viewport={"width": 1100, "height": 1300})
    page.goto((folder / "report.html").as_uri())
    page.screenshot(path=IMAGES / "report.png")
    print("report.png")


def main() -> None:
    """Take all pictures."""
    IMAGES.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as play:
        log = Path(folder) / "demo.log"
        browser = play.chromium.launch(executable_path=shutil.which("chromium"), args=FLAGS)
        demo = housefly("demo", "--port", "8090", stdout=log.open("w"), stderr=subprocess.STDOUT)
        try:
            fly(browser, address_in(log))
        finally:
            demo.send_signal(signal.SIGINT)
            demo.wait(60)
        photograph_tasks(browser, Path(folder))
        photograph_report(browser, Path(folder) / "flight")
        browser.close()
    housefly(
        "plan", "--to", "entrance", "--png", str(IMAGES / "room.png"), stdout=subprocess.DEVNULL
    ).wait()
    housefly(
        "plan",
        "--to",
        "entrance",
        "--mode",
        "paper",
        "--png",
        str(IMAGES / "room-paper.png"),
        stdout=subprocess.DEVNULL,
    ).wait()
    print("room.png\nroom-paper.png")


if __name__ == "__main__":
    main()
