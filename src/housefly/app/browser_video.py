"""Asks a browser of this machine whether it can show the drone's video: H.264 by WebCodecs."""

from __future__ import annotations

import shutil
import subprocess
import tempfile
import threading
from dataclasses import dataclass
from http.server import BaseHTTPRequestHandler, HTTPServer

_BROWSERS = (
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
    "microsoft-edge",
    "chromium-headless-shell",
)
_HEADLESS = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome")
"""The one without windows draws the same pages for two thirds of the processor's time."""
_FLAGS = (
    "--headless",
    "--disable-gpu",
    "--no-sandbox",
    "--no-first-run",
    "--disable-background-networking",
    "--dump-dom",
)
_TIMEOUT = 20.0
_PAGE = b"""<!doctype html><title>?</title><p id=answer>unknown</p><script>
const tell = (word) => { document.getElementById("answer").textContent = word };
if (typeof VideoDecoder === "undefined") tell("no-webcodecs");
else VideoDecoder.isConfigSupported({codec: "avc1.42e01e"})
  .then((r) => tell(r.supported ? "h264" : "no-h264"));
</script>"""
_WORDS = {
    "h264": "shows H.264 through WebCodecs",
    "no-h264": "knows WebCodecs but not H.264: the console falls back to single pictures",
    "no-webcodecs": "knows no WebCodecs: the console falls back to single pictures",
}


@dataclass(frozen=True, slots=True)
class BrowserVideo:
    """Whether a browser shows the video, and what was found, in words."""

    shows: bool
    words: str


def chromium_path() -> str | None:
    """Return the Chromium that draws a page for a program at the least cost, or None."""
    return next(filter(None, map(shutil.which, _HEADLESS)), None)


class _Page(BaseHTTPRequestHandler):
    def do_GET(self) -> None:
        self.send_response(200)
        self.send_header("Content-Type", "text/html")
        self.end_headers()
        self.wfile.write(_PAGE)

    def log_message(self, format: str, *arguments: object) -> None:
        """Say nothing."""


def video_of_the_browser() -> BrowserVideo:
    """Start the first known browser without a window and ask it."""
    name = next((name for name in _BROWSERS if shutil.which(name)), "")
    if not name:
        return BrowserVideo(
            False, f"none of {', '.join(_BROWSERS)} is installed; another one may do"
        )
    with HTTPServer(("127.0.0.1", 0), _Page) as server, tempfile.TemporaryDirectory() as profile:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        page = f"http://127.0.0.1:{server.server_port}/"
        command = [name, *_FLAGS, f"--user-data-dir={profile}", "--virtual-time-budget=3000", page]
        try:
            shown = subprocess.run(
                command, capture_output=True, text=True, timeout=_TIMEOUT, check=False
            ).stdout
        except (OSError, subprocess.TimeoutExpired):
            return BrowserVideo(False, f"{name} did not answer")
        finally:
            server.shutdown()
    answer = next(
        (word for word in ("no-webcodecs", "no-h264", "h264") if f">{word}<" in shown), ""
    )
    return BrowserVideo(answer == "h264", f"{name} {_WORDS.get(answer, 'did not say')}")
