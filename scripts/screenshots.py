"""Takes the pictures of the README: plays the story of the demo; console, tasks, clip, report.

``python scripts/screenshots.py`` writes docs/images/*.png.
"""

from __future__ import annotations

import re
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, Locator, Page, ViewportSize, expect, sync_playwright

from housefly import sites
from housefly.app.browser_video import chromium_path

IMAGES = Path(__file__).resolve().parents[1] / "docs" / "images"
DESKTOP: ViewportSize = {"width": 1280, "height": 800}
PHONE: ViewportSize = {"width": 390, "height": 844}
FLAGS = [
    "--no-sandbox",
    "--disable-background-networking",
    "--disable-component-update",
    "--no-first-run",
]

SPACE_FLAGS = [
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--ignore-gpu-blocklist",
]
"""With these the room is drawn in space without a graphics card, slowly."""
IN_SPACE = "localStorage.setItem('housefly space', 'true')"

MORE = """
[drone]
address = "127.30.1.2"
[tracking]
address = "127.30.1.2"
[hub]
store = "{folder}/room.db"
[web]
port = {port}
"""
"""What the demo's own site gets for a run beside others, with an empty memory."""


def housefly(*arguments: str, **options: Any) -> subprocess.Popen[str]:
    """Start a command of Housefly."""
    started: subprocess.Popen[str] = subprocess.Popen(
        [sys.executable, "-m", "housefly.cli", *arguments], text=True, **options
    )
    return started


def address_in(log: Path) -> str:
    """Wait until the demo is ready and return the console's address."""
    for _ in range(1800):
        text = log.read_text()
        if "ready after" in text and (found := re.search(r"http://\S+", text)):
            return found[0]
        time.sleep(0.1)
    sys.exit(f"the demo did not get ready:\n{log.read_text()}")


def state(page: Page, words: str) -> Locator:
    """Return the state line of the console with these words."""
    return page.get_by_role("banner").get_by_text(words)


def photograph(pages: dict[str, Page], moment: str) -> None:
    """Save a picture of each page."""
    for name, page in pages.items():
        file = "-".join(part for part in (name, moment) if part) + ".png"
        page.screenshot(path=IMAGES / file)
        print(file, flush=True)


def hold(page: Page, button: Locator) -> None:
    """Hold a button as long as it asks for."""
    box = button.bounding_box()
    assert box is not None
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.wait_for_timeout(900)
    page.mouse.up()


def begin_with_space(browser: Browser, address: str, size: ViewportSize) -> Page:
    """Open the home screen with the room in space."""
    context = browser.new_context(viewport=size, color_scheme="light")
    context.add_init_script(IN_SPACE)
    page = context.new_page()
    page.goto(address)
    expect(state(page, "Your drone is home")).to_be_visible(timeout=60_000)
    expect(page.locator(".space-canvas canvas")).to_be_visible(timeout=30_000)
    page.wait_for_timeout(60_000)  # people have done something, and the start is over
    return page


def begin(browser: Browser, drawing: Browser, address: str) -> dict[str, Page]:
    """Photograph the home screen in the browser that draws in space; return the other's pages."""
    first = begin_with_space(drawing, address, DESKTOP)
    photograph({"console": first}, "home")
    first.set_viewport_size(PHONE)
    first.wait_for_timeout(4000)
    photograph({"phone": first}, "home")
    cookies = first.context.storage_state()
    first.context.close()
    context = browser.new_context(viewport=DESKTOP, color_scheme="light", storage_state=cookies)
    context.add_init_script("localStorage.removeItem('housefly space')")
    desktop, phone, dark = (context.new_page() for _ in range(3))
    phone.set_viewport_size(PHONE)
    dark.emulate_media(color_scheme="dark")
    home = address.split("?")[0]
    for page in (desktop, phone):
        page.goto(f"{home}#tasks")
    dark.goto(home)
    pages = {"tasks": desktop, "phone-tasks": phone}
    for page in pages.values():
        services = page.get_by_role("region", name="Services")
        expect(services.get_by_role("listitem").first).to_be_visible(timeout=30_000)
    desktop.get_by_role("button", name="Who is at the door?").click()
    expect(desktop.get_by_role("region", name="Ask").get_by_role("status")).to_contain_text(
        ".", timeout=30_000
    )
    photograph(pages, "first")
    return {"console": desktop, "phone": phone, "console-dark": dark}


def show(page: Page, screen: str) -> None:
    """Go to a screen; the live one of a phone has its tasks on a sheet, which a key passes by."""
    button = page.get_by_role("navigation").get_by_role("button", name=screen)
    if button.is_visible():
        button.click()
    elif screen == "Tasks":
        page.keyboard.press("t")


def choose(pages: dict[str, Page]) -> None:
    """Choose where to fly, by hand, and photograph the way."""
    desktop, phone = pages["console"], pages["phone"]
    for page in (desktop, phone):
        close = page.get_by_role("button", name="Close", exact=True)
        if close.is_visible():
            close.click()
        show(page, "Live")
    take = desktop.get_by_role("button", name="Take control")
    if take.first.is_visible():  # a page that was silent for a moment has lost it
        take.first.click()
    desktop.get_by_role("button", name="Fly to …").first.click()
    desktop.get_by_role("button", name="Entrance", exact=True).click()
    desktop.wait_for_timeout(2000)
    photograph({"console": desktop, "phone": phone}, "ready")


def fly(pages: dict[str, Page]) -> None:
    """Fly to the chosen place by hand and photograph the service on its way."""
    desktop, phone = pages["console"], pages["phone"]
    both = {"console": desktop, "phone": phone}
    hold(desktop, desktop.get_by_role("button", name="Look at Entrance and come back"))
    expect(state(desktop, "Flying to Entrance")).to_be_visible(timeout=60_000)
    desktop.wait_for_timeout(7500)
    photograph(both, "flying")
    expect(state(desktop, "Looking at Entrance")).to_be_visible(timeout=120_000)
    desktop.wait_for_timeout(1500)
    photograph(pages, "arrived")
    expect(state(desktop, "Your drone is home")).to_be_visible(timeout=180_000)


def ring(page: Page) -> None:
    """Press the bell of the simulated room, and wait for the question."""
    page.get_by_role("button", name="Ring the doorbell").click()
    expect(page.get_by_role("article").first).to_be_visible(timeout=30_000)


def look_who_rings(pages: dict[str, Page]) -> None:
    """Let the bell ring, say yes, and photograph question, tasks and clip."""
    desktop, phone = pages["console"], pages["phone"]
    show(phone, "Live")
    show(desktop, "Live")
    ring(phone)
    question = desktop.get_by_role("article")
    expect(question.locator(".rehearsal")).to_be_visible(timeout=120_000)
    photograph({"console": desktop, "phone": phone}, "question")
    hold(desktop, question.get_by_role("button").first)
    show(desktop, "Tasks")
    expect(desktop.get_by_role("banner")).to_contain_text("recording", timeout=180_000)
    expect(desktop.get_by_role("button", name="Come home")).to_be_visible(timeout=60_000)
    desktop.wait_for_timeout(2500)
    photograph({"": desktop, "phone": phone}, "tasks")
    desktop.get_by_role("button", name="Come home").click(timeout=60_000)
    expect(state(desktop, "Your drone is home")).to_be_visible(timeout=180_000)
    expect(desktop.get_by_role("region", name="Now").get_by_role("listitem")).to_have_count(
        0, timeout=60_000
    )
    for page in (desktop, phone):
        show(page, "Tasks")
        page.get_by_role("tab", name="History").click()
        page.get_by_role("tabpanel").locator("summary").first.click()
    desktop.wait_for_timeout(1000)
    photograph({"tasks": desktop}, "history")
    for page, name in ((desktop, "tasks"), (phone, "phone-tasks")):
        page.get_by_role("button", name="Show clip").click()
        page.wait_for_timeout(8000)
        photograph({name: page}, "clip")


def demo_command(folder: Path) -> tuple[str, ...]:
    """Write a site with a memory of its own and return the command that shows it."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = int(probe.getsockname()[1])
    shipped = (Path(sites.__file__).parent / "bsen.toml").read_text()
    (folder / "site.toml").write_text(shipped + MORE.format(folder=folder, port=port))
    return ("demo", "--site", str(folder / "site.toml"))


def photograph_demo(browser: Browser, drawing: Browser, folder: Path) -> None:
    """Run the demo with a store of its own, and photograph its story."""
    log = folder / "demo.log"
    command = demo_command(folder)
    demo = housefly(*command, stdout=log.open("w"), stderr=subprocess.STDOUT)
    try:
        pages = begin(browser, drawing, address_in(log))
        drawing.close()
        choose(pages)
        look_who_rings(pages)
        choose(pages)
        fly(pages)
    finally:
        demo.send_signal(signal.SIGINT)
        demo.wait(60)


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
        chromium = chromium_path()
        drawing = play.chromium.launch(executable_path=chromium, args=[*FLAGS, *SPACE_FLAGS])
        browser = play.chromium.launch(executable_path=chromium, args=[*FLAGS, "--disable-gpu"])
        photograph_demo(browser, drawing, Path(folder))
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
