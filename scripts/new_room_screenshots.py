"""Takes the pictures of the page of ``housefly new``: a furnished room on a desktop and a phone.

``python scripts/new_room_screenshots.py`` writes docs/images/{new-room,phone-new-room}.png.
"""

from __future__ import annotations

import re
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

from playwright.sync_api import expect, sync_playwright
from screenshots import DESKTOP, FLAGS, IMAGES, PHONE, housefly

from housefly.app.browser_video import chromium_path

ROOM = (
    *("--room", "7x5x2.5", "--place", "window 6,2.5", "--place", "sofa 1.5,3.5"),
    *("--object", "wall 4.5,3.2 4.5,5", "--object", "table 3,1.2 1.6x0.9x0.75"),
    *("--object", "shelf 0.2,2.2 0.4x1.6x1.8", "--object", "sofa 2,4.4 1.8x0.8x0.8"),
    *("--object", "lamp 6,4 0.4x0.4x1.8", "--pad", "5.6,1.2"),
    *("--zone", "0,0,0.9,1.2 the cat sleeps"),
)
"""What one would type about the room in the pictures."""


def main() -> None:
    """Describe the room on the command line, then photograph how the page shows it."""
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as play:
        name = str(Path(folder) / "flat")
        housefly("new", name, *ROOM, "--yes", stdout=subprocess.DEVNULL).wait()
        server = housefly("new", name, "--page", "--no-test", stdout=subprocess.PIPE)
        assert server.stdout is not None
        found = re.search(r"http://\S+", server.stdout.readline())
        if not found:
            sys.exit("the page did not say where it is")
        browser = play.chromium.launch(executable_path=chromium_path(), args=FLAGS)
        page = browser.new_page(viewport=DESKTOP)
        page.goto(found.group(0))
        for picture, size in (("new-room", DESKTOP), ("phone-new-room", PHONE)):
            page.set_viewport_size(size)
            page.locator(".steps h2 button").get_by_text("Walls and furniture", exact=True).click()
            expect(page.get_by_text("Add a wall")).to_be_visible()
            page.wait_for_timeout(1000)
            page.screenshot(path=IMAGES / f"{picture}.png")
            print(f"{picture}.png")
            page.reload()
        browser.close()
        server.send_signal(signal.SIGINT)
        server.wait(20)


if __name__ == "__main__":
    main()
