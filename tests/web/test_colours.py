"""The console's colours keep the contrast that WCAG 2.2 AA asks for, in light and in dark."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import housefly.web

THEME = Path(housefly.web.__file__).parent / "client" / "src" / "theme.css"
TEXT, SHAPE = 4.5, 3.0

PAIRS = [
    ("ink", "card", TEXT),
    ("ink", "page", TEXT),
    ("ink", "floor", TEXT),
    ("quiet", "card", TEXT),
    ("quiet", "sunk", TEXT),
    ("quiet", "floor", TEXT),
    ("quiet", "outside", TEXT),
    ("accent", "card", TEXT),
    ("accent", "accent-soft", TEXT),
    ("on-accent", "accent", TEXT),
    ("warn", "card", TEXT),
    ("danger", "card", TEXT),
    ("danger", "danger-soft", TEXT),
    ("ink", "danger-soft", TEXT),
    ("on-stop", "stop", TEXT),
    ("accent", "floor", SHAPE),
    ("edge", "floor", SHAPE),
    ("edge", "sunk", SHAPE),
    ("danger", "floor", SHAPE),
    ("wall", "floor", SHAPE),
]


def palettes() -> dict[str, dict[str, str]]:
    blocks = re.findall(r":root \{(.*?)\}", THEME.read_text(encoding="utf-8"), re.DOTALL)
    light, dark = (dict(re.findall(r"--([\w-]+): (#[0-9a-f]{6});", block)) for block in blocks[:2])
    return {"light": light, "dark": {**light, **dark}}


def luminance(colour: str) -> float:
    parts = [int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    red, green, blue = (
        part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts
    )
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(one: str, other: str) -> float:
    dark, light = sorted((luminance(one), luminance(other)))
    return (light + 0.05) / (dark + 0.05)


def test_the_measure_of_contrast_is_right() -> None:
    assert contrast("#000000", "#ffffff") == pytest.approx(21.0)
    assert contrast("#777777", "#ffffff") == pytest.approx(4.48, abs=0.01)


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize(("front", "back", "least"), PAIRS)
def test_colours_keep_their_contrast(scheme: str, front: str, back: str, least: float) -> None:
    palette = palettes()[scheme]
    assert contrast(palette[front], palette[back]) >= least
