"""Page, report and plots have the same colours, and every pair of text and ground can be read."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from housefly.theme import DARK, LIGHT, Theme

STYLES = Path(__file__).parents[1] / "src/housefly/web/client/src/theme.css"
NAMES_IN_PAGE = {"margin": "thing", "thing_edge": "thing-edge", "second": "hatch"}
"""Colours whose name in the style sheet is another."""
OWN = {"paper", "card", "good", "virtual"}
"""Colours that the page does not have, or in another use."""


def shown_by_the_page(is_dark: bool) -> dict[str, str]:
    """Return the variables of the console's style sheet."""
    light, _, dark = STYLES.read_text("utf-8").partition("@media (prefers-color-scheme: dark)")
    return dict(re.findall(r"--([a-z-]+): (#[0-9a-f]{6});", dark if is_dark else light))


@pytest.mark.parametrize(("theme", "is_dark"), [(LIGHT, False), (DARK, True)])
def test_the_console_has_the_same_colours(theme: Theme, is_dark: bool) -> None:
    page = shown_by_the_page(is_dark)
    shared = {name: value for name, value in theme._asdict().items() if name not in OWN}
    assert shared == {name: page[NAMES_IN_PAGE.get(name, name)] for name in shared}


def luminance(colour: str) -> float:
    """Return the relative luminance of ``#rrggbb`` (WCAG 2.2)."""
    parts = [int(colour[at : at + 2], 16) / 255 for at in (1, 3, 5)]
    red, green, blue = (
        part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts
    )
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


@pytest.mark.parametrize("theme", [LIGHT, DARK])
@pytest.mark.parametrize("ground", ["paper", "card"])
def test_words_can_be_read_on_their_ground(theme: Theme, ground: str) -> None:
    for words in ("ink", "quiet", "accent", "second", "warn", "danger", "good"):
        pair = luminance(getattr(theme, words)), luminance(getattr(theme, ground))
        assert (max(pair) + 0.05) / (min(pair) + 0.05) >= 4.5, words
