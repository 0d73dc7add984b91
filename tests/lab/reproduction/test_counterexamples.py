"""Every verdict that was measured is another one in a world that differs in one thing."""

from __future__ import annotations

import ast
import inspect

import pytest

from housefly.lab.reproduction import changed_evidence, counterexamples
from housefly.lab.reproduction.claims import CLAIMS, findings
from housefly.lab.reproduction.counterexamples import (
    COUNTEREXAMPLES,
    counter_finding,
    judged_elsewhere,
)
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.exhibit import Verdict
from housefly.lab.reproduction.ruling import finding_of

BY_KEY = {claim.key: claim for claim in CLAIMS}
OVERTURNED = {
    "shortest path": Verdict.FAILS,
    "q2 after q1": Verdict.FAILS,
    "eps3 below a cell": Verdict.FAILS,
    "eps3 of a metre": Verdict.FAILS,
    "saturation": Verdict.FAILS,
    "use of (c, lambda)": Verdict.FAILS,
    "service": Verdict.FAILS,
    "static map": Verdict.FAILS,
    "dynamic map": Verdict.FAILS,
}
"""The verdict elsewhere where it is not that the claim holds."""
MEASURING = {
    "fly_trials",
    "find_edges",
    "fly_known_lag",
    "fly_many",
    "evaluate_equations",
    "survey",
    "map_facts",
    "mapped_site",
    "put_unexpected",
    "compared_with_scipy",
    "simulated_step",
}


@pytest.mark.interop
@pytest.mark.parametrize("key", COUNTEREXAMPLES)
def test_in_its_counter_world_the_verdict_is_another_one(key: str, evidence: Evidence) -> None:
    here = finding_of(BY_KEY[key], evidence)
    there = counter_finding(BY_KEY[key], COUNTEREXAMPLES[key], evidence)
    assert there.verdict is OVERTURNED.get(key, Verdict.HOLDS), there.evidence
    assert here.verdict not in (there.verdict, Verdict.NOT_TESTABLE), here.evidence
    assert any(letter.isdigit() for letter in there.evidence)


def test_every_claim_that_was_measured_has_its_counter_world(evidence: Evidence) -> None:
    measured = {
        finding.key for finding in findings(evidence) if finding.verdict is not Verdict.NOT_TESTABLE
    }
    assert measured == set(COUNTEREXAMPLES)


def unmeasured(source: str) -> list[str]:
    """Functions that replace evidence but measure nothing, or replace anything by a number."""
    found = []
    for function in (node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef)):
        calls = [node for node in ast.walk(function) if isinstance(node, ast.Call)]
        called = {call.func.id for call in calls if isinstance(call.func, ast.Name)}
        replacing = [call for call in calls if ast.unparse(call.func) == "replace"]
        injects = any(
            isinstance(part, ast.Constant) and isinstance(part.value, int | float)
            for call in replacing
            for keyword in call.keywords
            for part in ast.walk(keyword.value)
        )
        replaces = any(ast.unparse(call.args[0]) == "evidence" for call in replacing)
        if injects or (replaces and not called & MEASURING):
            found.append(function.name)
    return found


def test_no_change_puts_a_number_in_the_place_of_a_measurement() -> None:
    injecting = """
def f(evidence):
    return replace(evidence, maps=replace(evidence.maps, wrong=other))

def g(evidence):
    here = mapped_site(evidence.site, "default")
    return replace(evidence, maps=replace(evidence.maps, unexpected=replace(found, hit=0)))
"""
    assert unmeasured(injecting) == ["f", "g"]
    assert unmeasured(inspect.getsource(changed_evidence)) == []
    assert "replace(" not in inspect.getsource(counterexamples).replace("replace(finding", "")


def test_only_claims_with_a_counter_world_are_judged_elsewhere(evidence: Evidence) -> None:
    chosen = tuple(f for f in findings(evidence) if f.key in ("accurate tracking", "labels"))
    judged: list[None] = []
    tracking, labels = judged_elsewhere(chosen, evidence, lambda: judged.append(None))
    assert tracking.elsewhere is None
    assert labels.elsewhere is not None and labels.elsewhere.verdict is Verdict.HOLDS
    assert labels.verdict is Verdict.FAILS and len(judged) == 1
