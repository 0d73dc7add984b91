"""Fingers on the screen of a page in Chromium, as the browser itself reports them."""

from __future__ import annotations

from playwright.async_api import Page

from housefly.geometry import Vec2

STEPS = 8


async def touch(page: Page, *frames: list[Vec2]) -> None:
    """Put fingers on the screen, move them from frame to frame [px], and lift them."""
    line = await page.context.new_cdp_session(page)
    for k, fingers in enumerate(frames):
        points = [{"x": x, "y": y, "id": n} for n, (x, y) in enumerate(fingers)]
        kind = "touchMove" if k else "touchStart"
        await line.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
    await line.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    await line.detach()


async def swipe(page: Page, start: Vec2, across: float, down: float = 0.0) -> None:
    """Move one finger from a pixel, so far to the right and down [px]."""
    (x, y), shares = start, [k / STEPS for k in range(STEPS + 1)]
    await touch(page, *([(x + k * across, y + k * down)] for k in shares))
