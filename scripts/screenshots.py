"""Takes the pictures of the README: flies one service in a demo; console, room and report.

``python scripts/screenshots.py`` writes docs/images/*.png.
"""

from __future__ import annotations

import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

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


def hold(page: Page, name: str) -> None:
    """Hold a button as long as it asks for."""
    box = page.get_by_role("button", name=name).bounding_box()
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
    hold(desktop, "Send to look and come back")
    expect(state(desktop, "Flying to Entrance")).to_be_visible(timeout=30_000)
    desktop.wait_for_timeout(7500)
    photograph({"console": desktop, "phone": phone}, "flying")
    expect(state(desktop, "Looking at Entrance")).to_be_visible(timeout=60_000)
    desktop.wait_for_timeout(1500)
    photograph({"console": desktop, "phone": phone, "console-dark": dark}, "arrived")
    expect(state(desktop, "Ready on the pad")).to_be_visible(timeout=90_000)


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
