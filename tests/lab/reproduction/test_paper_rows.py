"""Every equation, condition, number, figure and sentence of the paper has its row in paper.md."""

from __future__ import annotations

import re
from collections import Counter
from functools import cache
from pathlib import Path

import pytest

from housefly.config.site import Site
from housefly.lab.reproduction.claims import CLAIMS
from housefly.lab.tuning.loop import Loop
from housefly.lab.tuning.margins import gain_margin

PAGE = Path(__file__).resolve().parents[3] / "docs" / "paper.md"
EQUATIONS = range(1, 26)
FIGURES = range(1, 18)
CONDITIONS = ("q1", "q2", "q3", "q4")
SENTENCES = {
    "Abstract": 7, "I": 18, "II-A": 29, "II-B": 6, "III": 10, "IV": 3, "IV-A": 13, "IV-B": 11,
    "V-A": 16, "V-B": 42, "V-C": 34, "V-D": 10, "VI": 13, "VII": 9, "VIII": 6,
}  # fmt: skip
"""Sentences of each section, counted as docs/paper.md says."""
NUMBERS = (
    "100 to 375 Hz", "10 to 100 Hz", "more than 90", "3-axis", "[-1, 1]", "2-D, 3-D",
    "517 x 451 mm", "12.5 x 4.5 m", "0.5 m", "25 x 9", "1 to 255", "w: 1, ∞, ≥ 0",
    "six degrees of freedom, four motors, three torques", "[0, 2π]", "0, π", "z̈ = 0",
    "ε1 = 0.2 m", "ε2 = 0.2 deg", "ε3 = 0.4 m", "ε3 < 0.5", "ε3 = 1", "ẋ_ref = ẏ_ref = 0",
    "0.4 of θ_max", "θ_max = 0.21 rad", "5 blocks",
)  # fmt: skip
"""Every number that the paper prints, but those of pages, sections and references."""
VERDICTS = (
    "as printed", "as described", "mended", "differs", "definition", "background", "made again",
    "judged",
)  # fmt: skip
"""What a verdict begins with."""
UNPROVEN = ("background", "definition", "judged", "made again")
"""Verdicts that need no further proof in their row: a judged claim has its own."""


@cache
def tables(page: str) -> tuple[tuple[tuple[str, ...], ...], ...]:
    """Return the tables of a page: rows of cells, the headings first."""
    found = []
    for block in re.findall(r"(?:^\|.*\n)+", page, flags=re.MULTILINE):
        lines = [line for line in block.splitlines() if not re.fullmatch(r"[|\- ]+", line)]
        found.append(
            tuple(tuple(c.strip() for c in re.split(r"(?<!\\)\|", line)[1:-1]) for line in lines)
        )
    return tuple(found)


def rows(page: str, *headings: str) -> list[dict[str, str]]:
    """Return the rows of the tables that have all these headings, by heading."""
    return [
        dict(zip(table[0], row, strict=True))
        for table in tables(page)
        if set(headings) <= set(table[0])
        for row in table[1:]
    ]


def ranged(text: str) -> list[int]:
    """Return the numbers that "1, 4-6" names."""
    return [
        number
        for first, last in re.findall(r"(\d+)(?:\s*-\s*(\d+))?", text)
        for number in range(int(first), int(last or first) + 1)
    ]


def missing(page: str) -> list[str]:
    """Return, in words, what of the paper has no row on a page, or more than one."""
    faults = []
    equations = [
        number
        for row in rows(page, "eq.", "code", "verdict", "proved by")
        for number in ranged(row["eq."].replace(")-(", "-"))
    ]
    faults += [f"equation {n}" for n in EQUATIONS if equations.count(n) != 1]
    conditions = [row["condition"] for row in rows(page, "condition", "as printed")]
    faults += [name for name in CONDITIONS if conditions.count(name) != 1]
    figures = [
        number
        for row in rows(page, "figure", "ours")
        for number in ranged(row["figure"].split(":")[0])
    ]
    faults += [f"figure {n}" for n in FIGURES if figures.count(n) != 1]
    numbers = Counter(row["number"] for row in rows(page, "number", "verdict"))
    faults += [f"number {n}" for n in NUMBERS if numbers[n] != 1]
    for section, count in SENTENCES.items():
        told = sorted(
            n
            for row in rows(page, "section", "sentences")
            if row["section"] == section
            for n in ranged(row["sentences"])
        )
        faults += [f"{section} {n}" for n in range(1, count + 1) if told.count(n) != 1]
        faults += [f"{section} {n} is no sentence" for n in told if n > count]
    return faults


def test_nothing_of_the_paper_lacks_its_row() -> None:
    assert missing(PAGE.read_text(encoding="utf-8")) == []


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        (r"^\| \(10\) .*\n", "equation 10"),
        (r"^\| q3 .*\n", "q3"),
        (r"^\| 14: .*\n", "figure 14"),
        (r"^\| V-B \| 36 .*\n", "V-B 36"),
        (r"^\| 0\.4 of .*\n", "number 0.4 of θ_max"),
    ],
)
def test_a_row_that_is_taken_away_is_missed(text: str, fault: str) -> None:
    page = PAGE.read_text(encoding="utf-8")
    without, count = re.subn(text, "", page, flags=re.MULTILINE)
    assert count == 1
    assert missing(without) == [fault]


def verdict_rows() -> list[dict[str, str]]:
    page = PAGE.read_text(encoding="utf-8")
    return rows(page, "number", "verdict") + rows(page, "sentences", "verdict")


def test_every_row_has_a_verdict_and_what_it_rests_on() -> None:
    for row in verdict_rows():
        assert row["verdict"].startswith(VERDICTS), row
        proved = row["verdict"].startswith(UNPROVEN) or row["ours"]
        assert proved, row


def test_every_judged_claim_is_one_and_every_claim_is_named() -> None:
    named = {
        key
        for row in verdict_rows()
        if (match := re.match(r"judged `([^`]+)`", row["verdict"]))
        for key in match.groups()
    }
    assert named == {claim.key for claim in CLAIMS}


def test_the_margins_by_tracking_rate_are_the_codes() -> None:
    site = Site()
    control, drone = site.control, site.drone
    told = rows(PAGE.read_text(encoding="utf-8"), "tracking: rate, latency")
    assert len(told) == 4
    for row in told:
        rate, latency = (float(n) for n in re.findall(r"\d+", row["tracking: rate, latency"]))
        for mode in ("default", "paper"):
            loop = Loop(
                control.alpha,
                control.beta,
                drone.attitude_lag,
                drone.command_delay,
                drag=drone.drag,
                tracking_hz=rate,
                latency=0.001 * latency,
                paper=mode == "paper",
            )
            stated = float(row[f"gain margin, mode {mode}"])
            assert stated == pytest.approx(gain_margin(loop), abs=0.006), (row, mode)
