"""Takes the pictures of the live scene: plays the B-sen scene until the cup is in the cabinet.

``python scripts/room_screenshots.py`` writes
docs/images/{room-live,room-history,phone-room,room-edit}.png. Needs mosquitto.
"""

from __future__ import annotations

import io
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from PIL import Image
from playwright.sync_api import Page, expect, sync_playwright
from screenshots import DESKTOP, FLAGS, IMAGES, PHONE, address_in, housefly

from housefly import sites
from housefly.app.browser_video import chromium_path

FOLDER = Path(sites.__file__).parent
THINGS = """
thing = [
    { id = "cup", name = "the cup", aliases = ["mug"] },
    { id = "tea-bottle", name = "the tea bottle" },
    { id = "book", name = "the book" },
    { id = "cabinet", name = "the cabinet", kind = "furniture", position = [11.50, 4.20, 0.60] },
    { id = "person-1", name = "the resident", kind = "person" },
    { id = "person-2", name = "the guest", kind = "person" },
]
"""
MORE = """
[hub]
store = "{folder}/room.db"
things = "{folder}/things.toml"
[mqtt]
broker = "127.0.0.1"
port = 0
start = true
[drone]
address = "127.90.9.1"
[tracking]
address = "127.90.9.1"
[web]
port = {web}
"""


def free_port() -> int:
    """Return a TCP port that is free now."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


def write_site(folder: Path) -> Path:
    """Write B-sen with its scene, in which the cup is in the refrigerator at first."""
    scene = (FOLDER / "bsen_scene.toml").read_text()
    (folder / "scene.toml").write_text(
        scene.replace('inside = "cabinet"', 'inside = "refrigerator"', 1)
    )
    (folder / "things.toml").write_text(THINGS)
    site = (
        (FOLDER / "bsen.toml")
        .read_text()
        .replace("[twin]\n", f'[twin]\nscene = "{folder}/scene.toml"\n', 1)
    )
    file = folder / "site.toml"
    file.write_text(site + MORE.format(folder=folder, web=free_port()))
    return file


def photograph(page: Page, name: str) -> None:
    """Save a picture with nothing focused and nothing under the pointer."""
    page.evaluate("document.activeElement.blur()")
    page.mouse.move(3, 65)
    page.wait_for_timeout(600)
    picture = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
    picture.quantize(256, dither=Image.Dither.NONE).save(IMAGES / f"{name}.png", optimize=True)
    print(f"{name}.png")


def visit(page: Page, address: str) -> None:
    """Wait for the cup, look, go back, and look again on a phone."""
    page.goto(address)
    page.get_by_role("combobox", name="Where is").fill("mug")
    page.keyboard.press("Enter")
    answer = page.locator(".answer")
    expect(answer).to_contain_text("in refrigerator", timeout=20_000)
    began = time.time()
    expect(answer).to_contain_text("in the cabinet", timeout=150_000)
    page.wait_for_timeout(1500)
    photograph(page, "room-live")
    page.get_by_role("button", name="Earlier", exact=True).first.click()
    page.get_by_role("slider", name="Time shown").fill(str(-round(0.7 * (time.time() - began))))
    expect(answer).to_contain_text("in refrigerator")
    photograph(page, "room-history")
    page.get_by_role("button", name="Back to now").click()
    expect(answer).to_contain_text("in the cabinet")
    page.set_viewport_size(PHONE)
    photograph(page, "phone-room")
    page.set_viewport_size(DESKTOP)
    edit(page)


def edit(page: Page) -> None:
    """Draw a zone and a place, and leave without saving."""
    page.get_by_role("button", name="Close the answer").click()
    page.get_by_text("Layers").click()
    page.get_by_role("button", name="Edit the room").click()
    panel = page.get_by_role("region", name="Edit places and zones")
    expect(panel).to_contain_text("Meeting table")
    plan = page.locator(".plan-view > svg").bounding_box() or sys.exit("there is no map")
    u, v = plan["x"] + 0.43 * plan["width"], plan["y"] + 0.46 * plan["height"]
    page.mouse.move(u, v)
    page.mouse.down()
    page.mouse.move(u + 62, v + 58, steps=4)
    page.mouse.up()
    panel.get_by_label("Reason").fill("Wet floor")
    panel.get_by_role("button", name="Done").click()
    page.mouse.click(u, v - 28)
    panel.get_by_label("Name").fill("Reading corner")
    photograph(page, "room-edit")
    panel.get_by_role("button", name="Discard").click()


def main() -> None:
    """Take all pictures."""
    with tempfile.TemporaryDirectory() as name, sync_playwright() as play:
        folder = Path(name)
        log = folder / "run.log"
        run = housefly(
            "run", "--site", str(write_site(folder)), stdout=log.open("w"), stderr=subprocess.STDOUT
        )
        try:
            browser = play.chromium.launch(executable_path=chromium_path(), args=FLAGS)
            visit(browser.new_page(viewport=DESKTOP), address_in(log))
            browser.close()
        finally:
            run.send_signal(signal.SIGINT)
            run.wait(60)


if __name__ == "__main__":
    main()
