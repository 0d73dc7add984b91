"""The console as an app of a phone: its shell without a network, sound, notifications, the screen.

What a headless browser has not (a screen, somebody who allows notifications) is recorded.
"""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from typing import Any

import pytest
import pytest_asyncio
from playwright.async_api import Browser, BrowserContext, Page, expect

from housefly.messages import DroneStatus, Phase
from housefly.web.control.lease import LEASE_TIMEOUT

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

Until = Callable[..., Any]

RECORDED = """
window.heard = { asked: 0, told: [], tones: 0, locks: [] };
window.Notification = class {
  static permission = "default";
  static async requestPermission() {
    heard.asked += 1;
    return (Notification.permission = "granted");
  }
  constructor(title, look) { heard.told.push([title, look.body]); }
};
const start = OscillatorNode.prototype.start;
OscillatorNode.prototype.start = function (...given) {
  heard.tones += 1;
  return start.apply(this, given);
};
Document.prototype.hasFocus = () => false;
class Lock extends EventTarget {
  async release() { this.released = true; this.dispatchEvent(new Event("release")); }
}
Object.defineProperty(navigator, "wakeLock", {
  value: { request: async () => { heard.locks.push(new Lock()); return heard.locks.at(-1); } },
});
"""


@pytest_asyncio.fixture(loop_scope="session")
async def context(chromium: Browser) -> AsyncIterator[BrowserContext]:
    made = await chromium.new_context(viewport={"width": 390, "height": 844})
    await made.add_init_script(RECORDED)
    yield made
    await made.close()


async def opened(context: BrowserContext, address: str) -> Page:
    page = await context.new_page()
    await page.goto(address)
    await expect(page.locator(".headline")).to_contain_text("Your drone is home")
    return page


async def becomes_true(page: Page, condition: str) -> None:
    """Wait for what a page knows; the page itself may not evaluate texts."""
    async with asyncio.timeout(20):
        while not await page.evaluate(condition):
            await asyncio.sleep(0.05)


async def ring(page: Page) -> Any:
    await page.get_by_role("button", name="You have control").click()
    return page.get_by_role("checkbox", name="Ring for the doorbell and for faults")


async def test_the_shell_opens_without_a_network_and_says_that_nothing_is_known(
    serving: Any, loopback: str, context: BrowserContext
) -> None:
    async with serving(loopback) as served:
        page = await opened(context, served.link)
        await page.evaluate("navigator.serviceWorker.register('/service-worker.js')")
        await page.evaluate("navigator.serviceWorker.ready")
        await becomes_true(page, "navigator.serviceWorker.controller !== null")
        await page.reload()  # now all that the page asks for goes through the service worker
        await expect(page.locator(".drone")).to_have_count(1)
    await page.goto(served.origin)
    await expect(page.locator(".banner")).to_contain_text("nothing is known of the drone")
    await expect(page.locator(".headline")).to_contain_text("No contact with the server")
    await expect(page.locator(".drone")).to_have_count(0)
    kept = await page.evaluate(
        "caches.keys().then(async (names) => (await Promise.all(names.map(async (name) =>"
        " (await (await caches.open(name)).keys()).map((one) => one.url)))).flat())"
    )
    paths = {address.removeprefix(served.origin) for address in kept}
    assert "/" in paths and "/static/app.js" in paths
    assert all(path == "/" or path.startswith("/static/") for path in paths)
    assert not any("?" in path or "#" in path for path in paths)
    # What is not of the shell never comes from the cache.
    for path in ("/api/v1/things", "/coverage", "/?token=x", "/static/new.js"):
        assert (
            await page.evaluate(f"fetch('{path}').then(() => 'came', () => 'failed')") == "failed"
        )


async def test_a_console_that_answers_goes_before_the_kept_shell(
    serving: Any, loopback: str, context: BrowserContext
) -> None:
    async with serving(loopback) as served:
        page = await opened(context, served.link)
        await page.evaluate("navigator.serviceWorker.register('/service-worker.js')")
        await becomes_true(page, "navigator.serviceWorker.controller !== null")
        await context.clear_cookies()
        await page.goto(served.origin)
        await expect(page.locator("main")).to_contain_text("Who is there?")


async def test_the_app_can_be_installed(serving: Any, loopback: str, context: Any) -> None:
    async with serving(loopback) as served:
        page = await opened(context, served.link)
        devtools = await context.new_cdp_session(page)
        found = await devtools.send("Page.getAppManifest")
        assert found["errors"] == [] and found["url"].endswith("/static/manifest.json")
        problems = (await devtools.send("Page.getInstallabilityErrors"))["installabilityErrors"]
        # Chromium installs nothing in a window that leaves no trace.
        assert {one["errorId"] for one in problems} <= {"in-incognito"}


async def test_sound_and_notifications_are_asked_for_by_a_press_and_tell_of_faults(
    serving: Any, loopback: str, context: BrowserContext, until: Until
) -> None:
    async with serving(loopback) as served:
        page = await opened(context, served.link)
        await page.mouse.click(200, 300)
        assert await page.evaluate("[heard.asked, heard.tones]") == [0, 0]
        wanted = await ring(page)
        await wanted.check()
        await becomes_true(page, "heard.asked === 1 && heard.tones > 0")
        assert await page.evaluate("heard.told") == []
        tones = await page.evaluate("heard.tones")
        served.pilot.status, served.pilot.phase = DroneStatus.FLYING, Phase.HOLDING
        await expect(page.locator(".headline")).to_contain_text("Hover")
        served.pilot.publishing = False
        await becomes_true(page, "heard.told.length === 1")
        title, words = (await page.evaluate("heard.told"))[0]
        assert title == "Housefly: look at the drone" and words.startswith("No word")
        assert await page.evaluate("heard.tones") > tones
        await page.reload()
        await expect(await ring_again(page)).to_be_checked()
        assert await page.evaluate("heard.asked") == 0, (
            "a browser that was asked is not asked again"
        )


async def ring_again(page: Page) -> Any:
    await page.locator(".who .control").click()
    return page.get_by_role("checkbox", name="Ring for the doorbell and for faults")


async def test_the_screen_stays_on_while_the_drone_flies_and_no_longer(
    serving: Any, loopback: str, context: BrowserContext
) -> None:
    async with serving(loopback) as served:
        page = await opened(context, served.link)
        assert await page.evaluate("heard.locks.length") == 0
        served.pilot.status, served.pilot.phase = DroneStatus.FLYING, Phase.HOLDING
        await becomes_true(page, "heard.locks.length === 1")
        served.pilot.status, served.pilot.phase = DroneStatus.LANDED, Phase.IDLE
        await becomes_true(page, "heard.locks[0].released === true")
        await asyncio.sleep(0.3)
        assert await page.evaluate("heard.locks.length") == 1


async def test_a_page_that_was_thrown_away_says_that_control_is_lost(
    serving: Any, loopback: str, context: BrowserContext
) -> None:
    async with serving(loopback) as served:
        page = await opened(context, served.link)
        await expect(page.locator(".who")).to_contain_text("You have control")
        await page.goto("about:blank")
        await asyncio.sleep(LEASE_TIMEOUT + 1.0)
        await page.goto(served.origin)
        await expect(page.locator(".said")).to_contain_text("silent and lost control")
        await expect(page.locator(".who")).to_contain_text("Nobody has control")
