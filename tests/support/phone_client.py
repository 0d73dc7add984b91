"""A phone on another machine: opens the address of the QR code in Chromium and flies by touch.

``python phone_client.py FOLDER``: FOLDER/said is what the server has printed. Prints what it saw as
JSON. Nothing is ignored of what is wrong with the certificate.
"""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path
from typing import Any

from installed_chromium import chromium_path
from playwright.sync_api import Page, expect, sync_playwright

FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-background-networking",
    "--disable-component-update",
    "--no-first-run",
]
FLIGHT_MS = 120_000


def main(folder: Path) -> None:
    printed = (folder / "said").read_text()
    link = re.search(r"^phone: +(https://\S+)", printed, re.MULTILINE)
    assert link is not None, printed
    seen: dict[str, Any] = {"link": link[1]}
    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=chromium_path(), args=FLAGS)
        page = browser.new_page(
            viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True
        )
        page.goto(link[1])
        expect(headline(page)).to_contain_text("Your drone is home", timeout=60_000)
        seen["address"], seen["secure"] = page.url, page.evaluate("isSecureContext")
        fly(page)
        seen["said"] = headline(page).inner_text()
        seen["kept"] = page.evaluate("caches.keys()")
        page.screenshot(path=folder / "phone.png")
        again = browser.new_page()
        answer = again.goto(link[1])
        seen["again"] = answer.status if answer else 0
        browser.close()
    print(json.dumps(seen))


def headline(page: Page) -> Any:
    return page.locator(".headline")


def fly(page: Page) -> None:
    """Look at the entrance and come back: two taps and one hold."""
    page.get_by_role("button", name="Fly to …").first.tap()
    page.get_by_role("button", name="Entrance", exact=True).tap()
    go = page.get_by_role("button", name="Look at Entrance and come back")
    expect(go).to_be_enabled()
    page.wait_for_timeout(500)
    box = go.bounding_box()
    assert box is not None
    at = {"x": box["x"] + box["width"] / 2, "y": box["y"] + box["height"] / 2}
    finger = page.context.new_cdp_session(page)
    finger.send("Input.dispatchTouchEvent", {"type": "touchStart", "touchPoints": [at]})
    page.wait_for_timeout(2000)
    finger.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    expect(headline(page)).to_contain_text("Looking at Entrance", timeout=FLIGHT_MS)
    expect(headline(page)).to_contain_text("Your drone is home", timeout=FLIGHT_MS)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
