"""Inviting another browser, in real Chromium: a QR code where a phone gets in, and what follows."""

from __future__ import annotations

import re
from collections.abc import AsyncIterator
from typing import Any

import pytest
import pytest_asyncio
from playwright.async_api import Browser, Page, Route, expect

from housefly.clock import RealClock
from housefly.web.access import invitations
from housefly.web.access.invitations import Invitations
from housefly.web.access.roles import Role
from housefly.web.http.qr_code import qr_view

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

SIZES = [(390, 844), (844, 390), (768, 1024), (1280, 800), (1920, 1080)]
PHONE_ADDRESS = "https://192.168.178.23:8080"


@pytest_asyncio.fixture(loop_scope="session")
async def console(serving: Any, loopback: str) -> AsyncIterator[Any]:
    """Yield a console that says that phones find it at another address."""
    async with serving(loopback, guest_address=PHONE_ADDRESS) as served:
        yield served


async def invite(page: Page, role: str) -> Any:
    """Open Invite, make a link, and return the sheet."""
    await page.get_by_role("button", name="You have control").click()
    await page.get_by_role("button", name="Invite").click()
    sheet = page.get_by_role("dialog", name="Invite")
    await sheet.get_by_role("button", name=role, exact=True).click()
    return sheet


async def copied(page: Page, sheet: Any) -> str:
    """Return the link that the sheet hands over."""
    await page.evaluate("navigator.clipboard.writeText = async (text) => { window.copied = text; }")
    await sheet.get_by_role("button", name="Copy link").click()
    await expect(sheet.get_by_role("button", name="Copied")).to_be_visible()
    return str(await page.evaluate("window.copied"))


@pytest.mark.parametrize("role", [Role.WATCH, Role.ASK, Role.FLY], ids=lambda role: role.value)
async def test_a_guest_comes_in_by_the_qr_code_with_its_role_and_the_host_is_told(
    page: Page, console: Any, role: Role
) -> None:
    sheet = await invite(page, role.value.title())
    code = sheet.get_by_role("img", name="QR code of the link")
    await expect(code).to_be_visible()
    link = await copied(page, sheet)
    assert link.startswith(f"{PHONE_ADDRESS}/?token=")
    drawn = await code.locator("path").get_attribute("d")
    assert drawn == qr_view(link).path
    status, headers, _ = await console.request("GET", link.removeprefix(PHONE_ADDRESS))
    assert status == 303
    await expect(sheet).to_contain_text("The link was used")
    await expect(code).to_have_count(0)
    async with console.talk(console.opened(headers), f"the-guest-{role.value}") as guest:
        assert (await guest.hear("welcome"))["role"] == role.value
        assert any("a browser came in by the link that Viewer" in event["text"]
                   for event in guest.heard[0]["events"])  # fmt: skip
        await guest.say(type="lease", id=7, action="take", held=True)
        await guest.hear("accepted" if role is Role.FLY else "refused", id=7)
    assert (await console.request("GET", link.removeprefix(PHONE_ADDRESS)))[0] == 403


async def test_the_code_is_whole_and_stop_is_free_at_every_size(page: Page) -> None:
    sheet = await invite(page, "Watch")
    for width, height in SIZES:
        await page.set_viewport_size({"width": width, "height": height})
        code = await sheet.get_by_role("img", name="QR code of the link").bounding_box()
        around, stop = await sheet.bounding_box(), await page.locator(".stop").bounding_box()
        assert code is not None and around is not None and stop is not None
        assert code["width"] >= 200.0, "45 modules of 4 pixels and a margin"
        for start, length in (("x", "width"), ("y", "height")):
            assert around[start] <= code[start], (width, height)
            assert code[start] + code[length] <= around[start] + around[length], (width, height)
        beside = around["x"] + around["width"] <= stop["x"]
        assert beside or around["y"] + around["height"] <= stop["y"], (width, height)


async def test_where_no_phone_gets_in_there_is_no_code_and_the_way_to_it_is_said(
    serving: Any, loopback: str, chromium: Browser
) -> None:
    async with serving(loopback) as alone:
        page = await chromium.new_page()
        await page.goto(alone.link)
        sheet = await invite(page, "Watch")
        await expect(sheet).to_contain_text("restart with: --lan")
        await expect(sheet.locator(".link")).to_have_text(
            re.compile(f"^{alone.origin}/\\?token=.{{44}}$")
        )
        await expect(sheet.get_by_role("img")).to_have_count(0)
        await page.close()


async def test_who_may_not_invite_is_told_whom_to_ask(console: Any, chromium: Browser) -> None:
    link = Invitations("a-secret-for-tests-only", RealClock()).new(Role.FLY)
    page = await chromium.new_page()
    await page.goto(f"{console.origin}/?token={link.token}")
    await page.get_by_role("button", name="You have control").click()
    await page.get_by_role("button", name="Invite").click()
    sheet = page.get_by_role("dialog", name="Invite")
    await expect(sheet).to_contain_text("Your role is “fly”: ask who runs Housefly for a link.")
    await expect(sheet.get_by_role("button", name="Watch")).to_have_count(0)
    await page.close()


@pytest.mark.interop
async def test_a_link_that_is_too_old_is_not_shown_as_a_good_one(
    page: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(invitations, "INVITATION_LIFE", 4.0)
    sheet = await invite(page, "Ask")
    code = sheet.get_by_role("img", name="QR code of the link")
    await expect(code).to_be_visible()
    await expect(sheet).to_contain_text("The link expired: make a new one.", timeout=20_000)
    await expect(code).to_have_count(0)


async def test_a_link_in_a_message_on_a_page_of_another_site_opens_the_console_too(
    console: Any, chromium: Browser
) -> None:
    page = await chromium.new_page()

    async def other_site(route: Route) -> None:
        await route.fulfill(body=f'<a href="{console.link}">come in</a>', content_type="text/html")

    await page.route("http://127.0.0.99/", other_site)
    await page.goto("http://127.0.0.99/")
    await page.get_by_role("link", name="come in").click()
    await page.get_by_role("link", name="Show the console").click()
    await expect(page.locator(".headline")).to_contain_text("Your drone is home")
    assert page.url == f"{console.origin}/"
    await page.close()
