"""Takes pictures of the console during a flight, where the machine has a browser."""

from __future__ import annotations

import io
import threading
from typing import Any

import numpy as np
from PIL import Image

from housefly.app.browser_video import chromium_path
from housefly.lab.reproduction.fig17_service import RgbImage

_BROWSER_FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-background-networking",
    "--no-first-run",
]
_VIEWPORT = {"width": 1280, "height": 720}


def has_browser() -> bool:
    """Return whether there are Chromium and playwright."""
    return chromium_path() is not None and _playwright() is not None


class ConsoleCamera:
    """Takes pictures of the console in Chromium; does nothing without Chromium or playwright.

    Attributes:
        available: whether there is a browser.
    """

    def __init__(self, address: str) -> None:
        self._address = address
        self._wanted: list[str] = []
        self._taken: dict[str, RgbImage] = {}
        self._wake, self._ending = threading.Condition(), False
        self._thread = threading.Thread(target=self._work, name="console camera", daemon=True)
        self.available = has_browser()

    def __enter__(self) -> ConsoleCamera:
        if self.available:
            self._thread.start()
        return self

    def __exit__(self, *reason: object) -> None:
        with self._wake:
            self._ending = True
            self._wake.notify()
        if self.available:
            self._thread.join(30.0)

    def shoot(self, title: str) -> None:
        """Ask for a picture now."""
        with self._wake:
            self._wanted.append(title)
            self._wake.notify()

    def pictures(self) -> dict[str, RgbImage]:
        """Return the pictures by title."""
        with self._wake:
            return dict(self._taken)

    def _work(self) -> None:
        playwright = _playwright()
        assert playwright is not None
        with playwright.sync_playwright() as play:
            browser = play.chromium.launch(executable_path=chromium_path(), args=_BROWSER_FLAGS)
            page: Any = browser.new_page(viewport=_VIEWPORT, color_scheme="light")
            opened = False
            while True:
                with self._wake:
                    self._wake.wait_for(lambda: self._wanted or self._ending, timeout=0.5)
                    title = self._wanted.pop(0) if self._wanted else None
                    if title is None and self._ending:
                        return
                opened = opened or self._open(page, playwright.Error)
                if title is not None and opened:
                    picture = _decoded(page.screenshot())
                    with self._wake:
                        self._taken[title] = picture

    def _open(self, page: Any, not_up_yet: type[Exception]) -> bool:
        try:
            page.goto(self._address, timeout=2000)
        except not_up_yet:
            return False
        return True


def _playwright() -> Any | None:
    try:
        from playwright import sync_api
    except ImportError:
        return None
    return sync_api


def _decoded(png: bytes) -> RgbImage:
    return np.asarray(Image.open(io.BytesIO(png)).convert("RGB"))
