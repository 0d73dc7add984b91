"""Words on the live map in Chromium: however close things stand, none lie on one another."""

from __future__ import annotations

import asyncio
import os
import time
from collections.abc import AsyncIterator
from itertools import combinations
from pathlib import Path
from typing import Any

import pytest
import pytest_asyncio
from playwright.async_api import Browser, FloatRect, Page, expect

from housefly.config.hub import HubConfig
from housefly.config.site import Site
from housefly.hub.api.answers import ObstacleAnswer
from housefly.hub.hub import Hub
from housefly.hub.things.thing import Thing, ThingKind
from housefly.messages import Observation

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

CROWD = {
    "person-1": ("the resident", (3.0, 1.5, 0.0)),
    "person-2": ("the guest", (3.3, 1.6, 0.0)),
    "person-3": ("the nurse", (3.1, 1.2, 0.0)),
    "robot-1": ("the trolley", (2.8, 1.3, 0.0)),
}
SIZES = [(1280, 800), (390, 844)]
_SHRUNK = 2.5
"""Boxes of lines have some air at their edges [px]."""
WORDS = """() => [...document.querySelectorAll(
    ".things text, .obstacles text, .names text")].map((one) => {
    const { x, y, width, height } = one.getBoundingClientRect();
    const mark = one.closest(".thing-mark, .obstacle");
    return { text: one.textContent.trim(), of: mark?.dataset.thing ?? one.textContent,
        box: { x, y, width, height } };
})"""


def near(number: int, confidence: float) -> ObstacleAnswer:
    x, y = 3.15 + 0.12 * number, 1.45 + 0.05 * number
    return ObstacleAnswer(f"o-{number}", x, y, 0.25, 0.0, 0.0, confidence, 0.0, "laser-1")


@pytest_asyncio.fixture(loop_scope="session")
async def crowded(
    serving: Any, loopback: str, chromium: Browser, tmp_path: Path
) -> AsyncIterator[tuple[Page, Hub]]:
    """Yield the live map of a room where all stand in one corner, and its hub."""
    async with serving(loopback) as console:
        site = Site(hub=HubConfig(store=str(tmp_path / "room.db")))
        hub = Hub(site, tmp_path, console.bus.join())
        now = time.time()
        for thing, (name, position) in CROWD.items():
            kind = ThingKind.PERSON if thing.startswith("person") else ThingKind.OBJECT
            hub.memory.world.add_thing(Thing(thing, name, kind))
            hub.memory.add(Observation(thing, "floor-1", now, now, position))
        telling = asyncio.create_task(hub.run())
        page = await chromium.new_page()
        await page.goto(console.link)
        for thing in CROWD:
            await expect(page.locator(f"[data-thing='{thing}']")).to_be_visible()
        yield page, hub
        await page.context.close()
        telling.cancel()
        await asyncio.gather(telling, return_exceptions=True)
        await asyncio.to_thread(hub.close)


def lie_on_each_other(a: FloatRect, b: FloatRect) -> bool:
    across = min(a["x"] + a["width"], b["x"] + b["width"]) - max(a["x"], b["x"])
    down = min(a["y"] + a["height"], b["y"] + b["height"]) - max(a["y"], b["y"])
    return across > _SHRUNK and down > 2 * _SHRUNK


async def test_no_words_of_the_map_lie_on_others_and_all_names_of_people_are_there(
    crowded: tuple[Page, Hub],
) -> None:
    page, hub = crowded
    hub.status.set_obstacles([near(0, 1.0), near(1, 0.9), near(2, 0.4)])
    await expect(page.locator(".obstacle")).to_have_count(3)
    for width, height in SIZES:
        await page.set_viewport_size({"width": width, "height": height})
        await page.wait_for_timeout(500)  # marks glide to where they belong
        if folder := os.environ.get("HOUSEFLY_LABEL_SHOTS"):
            await page.screenshot(path=Path(folder) / f"labels-{width}x{height}.png")
        words = await page.evaluate(WORDS)
        pairs = [(a, b) for a, b in combinations(words, 2) if a["of"] != b["of"]]
        covered = [
            f"{a['text']} / {b['text']}" for a, b in pairs if lie_on_each_other(a["box"], b["box"])
        ]
        assert covered == [], f"{width}x{height}"
        shown = {one["text"] for one in words}
        assert {name for name, _ in CROWD.values()} <= shown, f"{width}x{height}"


async def test_of_two_obstacles_in_one_spot_the_surer_one_has_the_words(
    crowded: tuple[Page, Hub],
) -> None:
    page, hub = crowded
    beside = [(6.5, 0.8), (6.5, 0.85), (6.5, 0.9), (6.5, 0.95), (6.5, 1.0), (6.5, 1.05)] * 3
    many = [
        ObstacleAnswer(f"o-{n}", x, y, 0.2, 0.0, 0.0, 0.5 + 0.02 * n, 0.0, "laser-1")
        for n, (x, y) in enumerate(beside)
    ]
    hub.status.set_obstacles(many)
    await expect(page.locator(".obstacle")).to_have_count(len(many))
    words = await page.locator(".obstacle text").all_text_contents()
    assert "84 % sure" in words and "50 % sure" not in words and len(words) < len(many)
