"""What the page draws anew in flight, in real Chromium: what moves, and nothing else."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from typing import Any

import pytest
import pytest_asyncio
from playwright.async_api import Browser, Page, expect

from housefly.bus.topics import DroneTopics
from housefly.clock import RealClock
from housefly.messages import DroneStatus, Order, OrderKind, Phase

TOPICS = DroneTopics()

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

MOVES = ("drone", "trail", "way", "height", "battery", "pill", "detail", "time-bar", "video")
"""What moves, is counted or is measured."""
WATCHED = """([moves, seconds]) => new Promise((done) => {
  const others = new Set(), moved = new Set(), lines = new Set();
  new MutationObserver((changes) => {
    for (const { target } of changes) {
      const one = target instanceof Element ? target : target.parentElement;
      const part = moves.find((name) => one.closest(`.${name}`));
      if (part) moved.add(part);
      else others.add(one.outerHTML.slice(0, 80));
      if (one.closest(".trail path")) lines.add(one);
    }
  }).observe(document.body, {
    subtree: true, attributes: true, childList: true, characterData: true });
  setTimeout(() => done([[...moved], [...others], lines.size]), 1000 * seconds);
})"""


@pytest_asyncio.fixture(loop_scope="session")
async def page(console: Any, chromium: Browser) -> AsyncIterator[Page]:
    """Yield a console whose drone has flown a way and flies on."""
    page = await chromium.new_page(viewport={"width": 1280, "height": 800})
    await page.goto(console.link)
    pilot = console.pilot
    pilot.status, pilot.phase, pilot.height = DroneStatus.FLYING, Phase.HOLDING, 1.1
    await expect(page.locator(".app")).to_have_attribute("data-flying", "true")
    order = Order(OrderKind.GO, "entrance", issued_at=RealClock().now(), sender="test")
    console.bus.publish(TOPICS.order, order)
    await expect(page.locator(".trail path").nth(1)).to_be_attached(timeout=15_000)
    await asyncio.sleep(1.0)
    yield page
    await page.close()


async def test_in_flight_only_what_moves_is_drawn_anew(page: Page) -> None:
    moved, others, lines = await page.evaluate(WATCHED, [MOVES, 2.0])
    assert {"drone", "trail", "way"} <= set(moved)
    assert others == []
    # Of the trail the newest stretch, and one or two that begin meanwhile.
    assert 1 <= lines <= 3
