"""The colours of pages, reports and plots, in one place; the console's ``theme.css`` has the same.

Lines are told apart by the palette of Okabe and Ito, whose blue is the accent here, and each line
of a plot has a word or a marker as well.
"""

from __future__ import annotations

from typing import NamedTuple


class Theme(NamedTuple):
    """Colours by what they are for, as ``#rrggbb``.

    Attributes:
        paper: background of a page or plot.
        card: background of what stands on it.
        line: rules, grids, borders.
        ink: text.
        quiet: text that explains, axes, ticks.
        accent: the drone, its way, what can be pressed.
        second: what it is compared with.
        warn: needs attention.
        danger: went wrong.
        good: went well.
        outside: outside of the room.
        wall: blocked by walls and things.
        margin: too close for the hull.
        virtual: blocked by a rule.
        thing_edge: outlines of things.
    """

    paper: str
    card: str
    line: str
    ink: str
    quiet: str
    accent: str
    second: str
    warn: str
    danger: str
    good: str
    outside: str
    wall: str
    margin: str
    virtual: str
    thing_edge: str


LIGHT = Theme(
    paper="#ffffff",
    card="#f3f5f8",
    line="#dde2e8",
    ink="#161b21",
    quiet="#55606c",
    accent="#1554c7",
    second="#a8540a",
    warn="#8a5200",
    danger="#b3151d",
    good="#17793a",
    outside="#e9edf1",
    wall="#3d4650",
    margin="#dfe3e8",
    virtual="#f3d9b1",
    thing_edge="#97a1ac",
)
DARK = Theme(
    paper="#0e1216",
    card="#171c22",
    line="#2c343d",
    ink="#eef2f5",
    quiet="#a3aeb9",
    accent="#83b1ff",
    second="#e59a4a",
    warn="#ffc65c",
    danger="#ff8f88",
    good="#4cc27a",
    outside="#13181d",
    wall="#b4bec9",
    margin="#343d47",
    virtual="#4a4128",
    thing_edge="#66727e",
)

ORANGE, GREEN, PINK, AMBER, SKY = "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"
"""Further lines of a plot, in this order after the accent."""
