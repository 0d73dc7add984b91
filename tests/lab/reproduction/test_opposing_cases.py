"""The section "What would change our mind" shows both sides, and where the verdict turns."""

from __future__ import annotations

from housefly.lab.reproduction.exhibit import (
    ClaimFinding,
    CounterFinding,
    OpposingCases,
    Verdict,
)
from housefly.lab.reproduction.page import opposing_section

PLAIN = ClaimFinding("a", "V", "nothing speaks <against> it", Verdict.HOLDS, "1 of 1")
OPPOSED = ClaimFinding(
    "b",
    "V",
    "it <cuts>",
    Verdict.CONDITION,
    "3 of 4",
    cases=OpposingCases("cuts 3 & more", "leaves 1"),
    elsewhere=CounterFinding("thick <air>", Verdict.FAILS, "0 of 4"),
)


def test_both_sides_and_the_counter_world_stand_on_the_page() -> None:
    section = opposing_section((PLAIN, OPPOSED), lambda verdict: f"[{verdict.value}]")
    for words in (
        "What would change our mind",
        "it &lt;cuts&gt;",
        "cuts 3 &amp; more",
        "leaves 1",
        "With thick &lt;air&gt;:",
        "[does not hold]",
        "0 of 4",
    ):
        assert words in section
    assert "nothing speaks" not in section
    assert section.index("cuts 3") < section.index("leaves 1") < section.index("thick")


def test_without_cases_there_is_no_section() -> None:
    assert opposing_section((PLAIN,), lambda verdict: verdict.value) == ""
