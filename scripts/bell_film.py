"""Makes the film of the README from the real page: the bell rings, the drone looks, comes home.

``python scripts/bell_film.py`` writes docs/images/bell.gif: about 20 s, under 3 MB.
"""

from __future__ import annotations

import io
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path

from PIL import Image
from playwright.sync_api import Browser, Page, ViewportSize, expect, sync_playwright
from screenshots import (
    FLAGS,
    IMAGES,
    address_in,
    demo_command,
    hold,
    housefly,
    state,
)

from housefly.app.browser_video import chromium_path

SIZE: ViewportSize = {"width": 1100, "height": 688}
SHOWN = (800, 500)
"""Size of the film [px]."""
RATE = 4.0
"""Pictures a second of the film."""
COLOURS = (128, 96, 64, 48)
"""Tried in turn until the file is small enough; all pictures share them, which makes it small."""
LIMIT = 3_000_000
PACES = {"home": 1.0, "bell": 1.0, "way": 5.0, "look": 2.0, "back": 9.0, "after": 1.0}
"""How much faster than the world each part is shown."""


@dataclass
class Film:
    """What was seen, by part of the story."""

    page: Page
    frames: list[tuple[float, bytes]] = field(default_factory=list)
    """Time in the film [s] and picture."""
    at: float = 0.0

    def take(self, part: str, seconds: float) -> None:
        """Film for so long."""
        end = time.monotonic() + seconds
        self.until(part, lambda: time.monotonic() >= end)

    def until(self, part: str, is_over: object, patience: float = 180.0) -> None:
        """Film until something is so."""
        assert callable(is_over)
        began = last = time.monotonic()
        while not is_over():
            if last - began > patience:
                sys.exit(f"the part {part!r} took longer than {patience:.0f} s")
            picture = self.page.screenshot(type="jpeg", quality=90)
            now = time.monotonic()
            self.at += (now - last) / PACES[part]
            last = now
            self.frames.append((self.at, picture))

    def save(self, file: Path) -> None:
        """Write it, with as many colours as its size allows."""
        chosen: list[Image.Image] = []
        due = 0.0
        for at, picture in self.frames:
            if at >= due:
                shown = Image.open(io.BytesIO(picture)).convert("RGB")
                chosen.append(shown.resize(SHOWN, Image.Resampling.LANCZOS))
                due += 1.0 / RATE
        kept = chosen[:: max(1, len(chosen) // 8)]
        sheet = Image.new("RGB", (SHOWN[0], SHOWN[1] * len(kept)))
        for row, picture_shown in enumerate(kept):
            sheet.paste(picture_shown, (0, row * SHOWN[1]))
        for colours in COLOURS:
            palette = sheet.quantize(colours, method=Image.Quantize.MEDIANCUT)
            drawn = [one.quantize(palette=palette, dither=Image.Dither.NONE) for one in chosen]
            duration = round(1000.0 / RATE)
            drawn[0].save(
                file,
                save_all=True,
                append_images=drawn[1:],
                duration=duration,
                loop=0,
                optimize=True,
            )
            if file.stat().st_size < LIMIT:
                break
        seconds = len(chosen) / RATE
        print(f"{file.name}: {seconds:.0f} s, {file.stat().st_size / 1e6:.1f} MB")


def play(browser: Browser, address: str) -> None:
    """Play the story on the page and film it."""
    page = browser.new_page(viewport=SIZE)
    page.goto(address)
    expect(state(page, "Your drone is home")).to_be_visible(timeout=60_000)
    page.wait_for_timeout(40_000)  # people have done something, and the start is over
    film = Film(page)
    film.take("home", 2.5)
    page.get_by_role("button", name="Ring the doorbell").click()
    yes = page.get_by_role("article").get_by_role("button").first
    film.until("bell", yes.is_visible)
    film.take("bell", 3.0)
    rehearsed = page.locator(".rehearsal[data-may=true]")
    expect(rehearsed).to_be_visible(timeout=120_000)
    hold(page, yes)
    film.until("way", state(page, "Looking at").is_visible)
    film.take("look", 8.0)
    page.get_by_role("button", name="Come home").first.click()
    home = state(page, "Your drone is home")
    film.until("back", home.is_visible)
    film.take("after", 3.0)
    film.save(IMAGES / "bell.gif")


def main() -> None:
    """Run the demo with a memory of its own and film it."""
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as driver:
        log = Path(folder) / "demo.log"
        command = demo_command(Path(folder))
        demo = housefly(*command, stdout=log.open("w"), stderr=subprocess.STDOUT)
        flags = [*FLAGS, "--disable-gpu"]
        browser = driver.chromium.launch(executable_path=chromium_path(), args=flags)
        try:
            play(browser, address_in(log))
        finally:
            browser.close()
            demo.send_signal(signal.SIGINT)
            demo.wait(60)


if __name__ == "__main__":
    main()
