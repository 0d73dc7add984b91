"""What axe-core finds wrong with a page for those who use it in another way."""

from __future__ import annotations

from typing import Any, Literal

import pytest
from playwright.async_api import Page

from housefly.web.access.page_routes import STATIC_FOLDER

AXE = STATIC_FOLDER.parent / "client" / "node_modules" / "axe-core" / "axe.min.js"
SIZES = ((390, 844), (844, 390), (1440, 900))
"""Sizes whose layouts differ most [px]."""
_SCHEMES: dict[Literal["light", "dark"], dict[str, Any]] = {
    "light": {"rules": {"label-content-name-mismatch": {"enabled": True}}},
    "dark": {"runOnly": ["color-contrast"]},
}
"""What is asked in each scheme: in the dark one only colours are others.

Who speaks to the machine says what is written on a mark: axe looks for that only when asked.
"""
_RUN = """(options) => axe.run({ resultTypes: ["violations"], ...options }).then((all) =>
    all.violations.flatMap((one) => one.nodes.map((node) =>
        `${one.id}: ${node.target.join(" ")} ${node.html.slice(0, 120)}; ${node.failureSummary}`)))
"""


async def axe_findings(page: Page, sizes: tuple[tuple[int, int], ...] = SIZES) -> list[str]:
    """Return what is wrong at each size, light and dark; the size stays the last one.

    Skips the test where the client's tools are not installed.
    """
    if not AXE.is_file():
        pytest.skip("the client's tools are not installed: npm ci in src/housefly/web/client")
    if await page.evaluate("typeof axe === 'undefined'"):
        await page.evaluate(AXE.read_text(encoding="utf-8"))
    found: dict[str, str] = {}
    for scheme, options in _SCHEMES.items():
        await page.emulate_media(color_scheme=scheme, reduced_motion="reduce")
        for width, height in sizes:
            await page.set_viewport_size({"width": width, "height": height})
            for one in await page.evaluate(_RUN, options):
                found.setdefault(one, f"{scheme} {width}x{height}: {one}")
    return list(found.values())
