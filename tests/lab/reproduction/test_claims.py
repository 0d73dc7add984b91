"""Every verdict that was measured would have been another one, had one thing been another."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import nan
from typing import Any

import numpy as np
import pytest

from housefly.config.site import Site
from housefly.lab.reproduction.claims import CLAIMS, findings
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.exhibit import Verdict
from housefly.lab.reproduction.ruling import finding_of
from housefly.lab.reproduction.streams import LATENCIES, RATES
from housefly.lab.reproduction.trials import TRIALS, Trial, fly_trials
from housefly.pilot.estimation.estimator import EstimatorKind

Change = Callable[[Evidence], Evidence]
BY_KEY = {claim.key: claim for claim in CLAIMS}


def flown_otherwise(trial: str, **columns: Any) -> Change:
    """Fly one trial with other columns."""

    def change(evidence: Evidence) -> Evidence:
        drones = len(evidence.trials[trial])
        changed = fly_trials(evidence.site, drones, changes={trial: columns}, only=(trial,))
        return replace(evidence, trials={**evidence.trials, **changed})

    return change


def maps(**facts: Any) -> Change:
    return lambda evidence: replace(evidence, maps=replace(evidence.maps, **facts))


def equations(**facts: Any) -> Change:
    return lambda evidence: replace(evidence, equations=replace(evidence.equations, **facts))


def overlap(**facts: int) -> Change:
    return lambda evidence: replace(
        evidence,
        equations=replace(evidence.equations, overlap=replace(evidence.equations.overlap, **facts)),
    )


def pitch(**facts: float) -> Change:
    def change(evidence: Evidence) -> Evidence:
        assert evidence.pitch is not None
        return replace(evidence, pitch=replace(evidence.pitch, **facts))

    return change


def edges(**shares: float) -> Change:
    """Give estimators this share of the best edge at the slowest rate or the latest frames."""

    def change(evidence: Evidence) -> Evidence:
        values = evidence.edges.values.copy()
        names = {
            "difference": EstimatorKind.FINITE_DIFFERENCE,
            "arrival": EstimatorKind.ON_ARRIVAL,
            "ours": EstimatorKind.DELAY_COMPENSATED,
        }
        order = [3, 2, 1, 0]  # edges.ESTIMATORS, from the plainest to ours
        for name, share in shares.items():
            estimator, what = name.split("_")
            row = order.index(names[estimator])
            if what == "slow":
                values[row, RATES.index(10.0)] = share * values[row, RATES.index(100.0)]
            else:
                values[row, :, LATENCIES.index(0.1)] = share * values[row, :, LATENCIES.index(0.0)]
        return replace(evidence, edges=replace(evidence.edges, values=values))

    return change


def nobody_arrives(evidence: Evidence) -> Evidence:
    outcomes = evidence.streams.outcomes.copy()
    outcomes["arrival_time"] = nan
    return replace(evidence, streams=replace(evidence.streams, outcomes=outcomes))


def measured_otherwise(trial: str, **measures: float) -> Change:
    """Let the drones of one trial have measured something else."""

    def change(evidence: Evidence) -> Evidence:
        outcomes = evidence.trials[trial].copy()
        for name, value in measures.items():
            outcomes[name] = value
        return replace(evidence, trials={**evidence.trials, trial: outcomes})

    return change


def nobody_strays(evidence: Evidence) -> Evidence:
    return maps(clearance=0.1)(measured_otherwise("as printed", max_error=0.0)(evidence))


FLIPS: dict[str, tuple[Change, Verdict]] = {
    "immediate answer": (edges(arrival_late=0.95), Verdict.HOLDS),
    "low frame rate": (edges(arrival_slow=0.5), Verdict.HOLDS),
    "speed commands": (equations(speed_rise=0.15), Verdict.HOLDS),
    "plane": (
        lambda evidence: maps(free_at_every_height=evidence.maps.free)(evidence),
        Verdict.HOLDS,
    ),
    "resolution": (maps(resolution=0.7), Verdict.HOLDS),
    "virtual obstacles": (nobody_strays, Verdict.HOLDS),
    "labels": (maps(cells=(51, 5)), Verdict.HOLDS),
    "shortest path": (maps(wrong=1), Verdict.FAILS),
    "four movements": (maps(detour=1.0), Verdict.HOLDS),
    "equations of motion": (equations(newton_printed=0.0), Verdict.HOLDS),
    "planar dynamics": (equations(planar_elsewhere=0.0), Verdict.HOLDS),
    "two directions": (maps(legs_along_y=0), Verdict.HOLDS),
    "yaw law": (flown_otherwise("no wrap", wrap_yaw=1.0), Verdict.HOLDS),
    "height law": (flown_otherwise("literal height sign", height_gain=1.2), Verdict.HOLDS),
    "fewer degrees of freedom": (
        flown_otherwise("as printed", epsilon_height=2.0, epsilon_yaw=3.2),
        Verdict.HOLDS,
    ),
    "q2 after q1": (overlap(q2_with_q1=1), Verdict.FAILS),
    "execution order": (overlap(several=0, none=0), Verdict.HOLDS),
    "eps2": (flown_otherwise("as printed", epsilon_yaw=0.2), Verdict.HOLDS),
    "eps3 below a cell": (flown_otherwise("eps3 0.4 m", epsilon_position=1.0), Verdict.CONDITION),
    "eps3 of a metre": (flown_otherwise("eps3 1 m", epsilon_position=0.15), Verdict.FAILS),
    "hover": (flown_otherwise("hover", gust=0.0, wind_x=0.0, wind_y=0.0), Verdict.HOLDS),
    "feedback linearization": (equations(step_deviation=0.001), Verdict.HOLDS),
    "eigenvalues": (flown_otherwise("literal gain signs", alpha=3.6, beta=3.24), Verdict.HOLDS),
    "choice of gains": (
        flown_otherwise("beta above saturation", alpha=3.6, beta=3.24),
        Verdict.HOLDS,
    ),
    "saturation": (measured_otherwise("long step, free", overshoot=0.5), Verdict.HOLDS),
    "first order": (pitch(misfit_without_delay=0.01), Verdict.HOLDS),
    "identification": (pitch(lag_without_delay=7.1), Verdict.HOLDS),
    "independent loops": (flown_otherwise("beta above lambda alpha", beta=1.4), Verdict.HOLDS),
    "use of (c, lambda)": (flown_otherwise("lag unknown", model_lag=0.5), Verdict.HOLDS),
    "estimation is required": (
        flown_otherwise("unfiltered", estimator=EstimatorKind.ON_ARRIVAL),
        Verdict.FAILS,
    ),
    "Kalman filter": (edges(ours_late=0.1), Verdict.HOLDS),
    "service": (nobody_arrives, Verdict.FAILS),
    "static map": (maps(hit_static=0), Verdict.FAILS),
    "dynamic map": (maps(hit_updated=3), Verdict.FAILS),
}


@pytest.mark.parametrize("key", FLIPS)
def test_one_thing_changed_and_the_verdict_is_another(key: str, evidence: Evidence) -> None:
    change, expected = FLIPS[key]
    before, after = (finding_of(BY_KEY[key], seen) for seen in (evidence, change(evidence)))
    assert before.verdict not in (expected, Verdict.NOT_TESTABLE), before.evidence
    assert after.verdict is expected, after.evidence


def test_every_claim_that_was_measured_can_flip(evidence: Evidence) -> None:
    measured = {
        finding.key for finding in findings(evidence) if finding.verdict is not Verdict.NOT_TESTABLE
    }
    assert measured == set(FLIPS)


def test_the_battery_is_judged_by_the_services(evidence: Evidence) -> None:
    class Flown:
        mode, outcome = "paper", "completed"

        def __init__(self, used: float) -> None:
            self.battery_used = used

    claim = BY_KEY["battery"]
    verdicts = [
        finding_of(claim, replace(evidence, services=(Flown(used),))).verdict
        for used in (0.08, 0.001)
    ]  # type: ignore[arg-type]
    assert verdicts == [Verdict.HOLDS, Verdict.FAILS]
    assert finding_of(claim, evidence).verdict is Verdict.NOT_TESTABLE


def test_low_frame_rate_harms_who_differentiates_and_not_a_correct_filter(
    evidence: Evidence,
) -> None:
    """The claim that readers care about most; the numbers behind it."""

    def kept(estimator: int, latency: float) -> float:
        slow, fast = (
            float(np.nanmean(evidence.edges.of(estimator, rate, latency))) for rate in (10.0, 100.0)
        )
        return slow / fast

    assert kept(EstimatorKind.FINITE_DIFFERENCE, 0.0) < 0.75
    assert kept(EstimatorKind.DELAY_COMPENSATED, 0.05) > 0.8
    assert kept(EstimatorKind.ON_ARRIVAL, 0.05) > kept(EstimatorKind.FINITE_DIFFERENCE, 0.05)


def test_every_finding_has_its_numbers_and_its_place(evidence: Evidence) -> None:
    for finding in findings(evidence):
        assert finding.section
        assert finding.verdict is Verdict.NOT_TESTABLE or any(
            letter.isdigit() for letter in finding.evidence
        ), finding.key
    assert len({claim.key for claim in CLAIMS}) == len(CLAIMS) > 40


def test_trials_are_the_same_for_the_same_seed_whatever_else_flies(site: Site) -> None:
    whole, alone = fly_trials(site, 2), fly_trials(site, 2, only=("eps2 0.2 rad",))
    assert set(whole) == {trial.key for trial in TRIALS}
    assert alone["eps2 0.2 rad"].tobytes() == whole["eps2 0.2 rad"].tobytes()
    assert isinstance(TRIALS[0], Trial)
