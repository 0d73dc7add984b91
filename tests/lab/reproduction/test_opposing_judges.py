"""Three claims judged where they could matter, with what speaks for them and what against."""

from __future__ import annotations

import numpy as np

from housefly.lab.reproduction.changed_evidence import trials
from housefly.lab.reproduction.claims import CLAIMS
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.exhibit import Verdict
from housefly.lab.reproduction.known_lag import KnownLag
from housefly.lab.reproduction.opposing_judges import (
    judge_height_law,
    judge_lag_knowledge,
    judge_saturation,
)
from housefly.lab.reproduction.ruling import finding_of
from housefly.lab.reproduction.trial_list import (
    FREE,
    HEIGHT_GAINS,
    POORLY_DAMPED,
    SATURATED,
    SWINGING,
    WELL_DAMPED,
    StepGains,
    TrialKind,
    height_key,
    step_key,
)
from housefly.pilot.behavior.acceptor import PAPER_TOLERANCES
from housefly.pilot.estimation.estimator_state import EstimatorKind

OURS, PAPERS = EstimatorKind.DELAY_COMPENSATED, EstimatorKind.ON_ARRIVAL


def test_knowing_lambda_doubles_how_stiff_a_loop_settles_and_does_nothing_for_the_papers_filter(
    evidence: Evidence,
) -> None:
    flown: KnownLag = evidence.known_lag
    with_it, without = (flown.limit(OURS, known).frequency.value for known in (True, False))
    assert with_it > 1.8 * without
    assert (
        flown.share_at(8.3, OURS, True).value > 0.8 > 0.3 > flown.share_at(8.3, OURS, False).value
    )
    assert flown.limit(PAPERS, True).frequency.value == flown.limit(PAPERS, False).frequency.value
    ruling = judge_lag_knowledge(evidence)
    assert ruling.verdict is Verdict.CONDITION
    assert "not on a way at constant speed" in ruling.evidence


def overshoots(evidence: Evidence, kind: TrialKind, gains: StepGains, tilt: float) -> np.ndarray:
    measured: np.ndarray = evidence.trials[step_key(kind, gains, tilt)]["overshoot"]
    return measured


def test_saturation_cuts_the_overshoot_of_long_steps_and_leaves_those_of_one_cell(
    evidence: Evidence,
) -> None:
    for gains in (POORLY_DAMPED, SWINGING):
        limited, free = (overshoots(evidence, TrialKind.LONG, gains, t) for t in (SATURATED, FREE))
        assert limited.mean() < 0.85 * free.mean() and limited.mean() > 0.1
        limited, free = (overshoots(evidence, TrialKind.CELL, gains, t) for t in (SATURATED, FREE))
        assert abs(limited - free).max() < 0.01 < limited.mean()
    assert overshoots(evidence, TrialKind.LONG, WELL_DAMPED, FREE).max() < 0.01
    assert judge_saturation(evidence).verdict is Verdict.CONDITION


def test_saturation_holds_where_every_overshoot_is_gone(evidence: Evidence) -> None:
    """A limit of 0.21 rad on gains that are kept well damped there, and swinging without it."""
    keys = [step_key(k, g, SATURATED) for k in TrialKind if k in _STEPS for g in _SHOOTING]
    calm = trials(*keys, alpha=3.6, beta=3.24)(evidence)
    assert judge_saturation(calm).verdict is Verdict.HOLDS


_STEPS, _SHOOTING = (TrialKind.CELL, TrialKind.LONG), (POORLY_DAMPED, SWINGING)


def test_the_height_is_kept_with_one_sign_of_k2_whatever_its_size(evidence: Evidence) -> None:
    for gain in HEIGHT_GAINS:
        error = evidence.trials[height_key(gain)]["height_error"]
        assert (error < PAPER_TOLERANCES.height).all() == (gain < 0.0), gain
    ruling = judge_height_law(evidence)
    assert ruling.verdict is Verdict.CONDITION and "prints neither sign nor size" in ruling.evidence


def test_a_height_law_that_holds_with_no_sign_is_refused(evidence: Evidence) -> None:
    keys = [height_key(gain) for gain in HEIGHT_GAINS]
    blind = trials(*keys, height_gain=-5.0)(evidence)
    assert judge_height_law(blind).verdict is Verdict.FAILS


def test_opposing_cases_have_numbers_on_both_sides(evidence: Evidence) -> None:
    opposed = [finding_of(claim, evidence) for claim in CLAIMS]
    keys = {finding.key for finding in opposed if finding.cases}
    assert keys >= {"use of (c, lambda)", "saturation", "height law", "static map", "dynamic map"}
    for finding in opposed:
        if finding.cases:
            for side in (finding.cases.speaks_for, finding.cases.speaks_against):
                assert any(letter.isdigit() for letter in side), finding.key
                assert "nan" not in side, finding.key
