"""axe-core finds nothing on the page of ``housefly new``, at any of its steps."""

from __future__ import annotations

from typing import Any

import pytest
from axe_audit import axe_findings
from playwright.async_api import Browser, expect

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

SIZES = ((390, 844), (1440, 900))
TABLE = {"name": "table", "x": 2.0, "y": 2.0, "length": 1.6, "width": 0.8, "top": 0.75}
DRAWN = {
    "name": "lab",
    "hardware": True,
    "bounds": [0, 0, 6, 4],
    "furniture": [TABLE],
    "pad": [1, 1],
    "places": [{"name": "far", "x": 5, "y": 3, "look_at": [5, 4, 1]}],
    "zones": [{"rectangle": [3, 1, 4, 2], "reason": "kept free"}],
    "frame_points": [{"name": "a", "on_map": [1, 1, 0], "seen": [1, 1, 0]}],
}


@pytest.mark.interop
async def test_axe_finds_nothing_at_any_step(drawer: Any, chromium: Browser) -> None:
    status, told = await drawer.post("/draft", draft=DRAWN)
    assert status == 200, told
    context = await chromium.new_context()
    name, _, value = drawer.cookie.partition("=")
    await context.add_cookies([{"name": name, "value": value, "url": drawer.origin}])
    page = await context.new_page()
    await page.goto(f"{drawer.origin}/?proof={drawer.proof}")
    steps = page.locator(".steps > li")
    await expect(steps).to_have_count(9)
    for index in range(9):
        await steps.nth(index).locator("h2 button").click()
        items = steps.nth(index).locator(".rows button.name")
        if await items.count():
            await items.first.click()
        assert await axe_findings(page, SIZES) == [], index
    await context.close()
