"""What people do on the console's home screen, for tests in Chromium."""

from __future__ import annotations

from playwright.async_api import Page


async def open_orders(page: Page) -> None:
    """Show the orders of a drone that rests, with the list of places."""
    await page.get_by_role("button", name="Fly to …").first.click()


async def choose_place(page: Page, title: str) -> None:
    """Choose a place from the list as the goal."""
    await open_orders(page)
    await page.get_by_role("button", name=title, exact=True).click()


async def open_details(page: Page) -> None:
    """Show battery, figures, sensors and the raw log beside the room."""
    await page.get_by_role("button", name="Details", exact=True).click()


async def open_earlier(page: Page) -> None:
    """Show the bar of time at the foot of the stage."""
    button = page.get_by_role("button", name="Earlier", exact=True).first
    if not await button.is_visible():  # on a phone it is among the layers
        await page.locator(".layers summary").click()
    await button.click()
    await page.locator(".layers").evaluate("one => { one.open = false }")
