"""The page of the bus is what the code says."""

from __future__ import annotations

from pathlib import Path

from bus_page import bus_page


def test_the_page_is_what_the_code_says() -> None:
    page = Path(__file__).parents[2] / "docs" / "bus.md"
    assert page.read_text(encoding="utf-8") == bus_page(), (
        "run: python scripts/bus_page.py > docs/bus.md"
    )
