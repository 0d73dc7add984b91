"""Every verdict that was measured rests on numbers, and a battery is judged by what it loses."""

from __future__ import annotations

from dataclasses import replace

import pytest

from housefly.config.site import Site
from housefly.lab.reproduction.changed_evidence import service
from housefly.lab.reproduction.claims import CLAIMS, findings
from housefly.lab.reproduction.edges import ESTIMATORS
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.exhibit import Verdict
from housefly.lab.reproduction.ruling import finding_of
from housefly.lab.reproduction.stability_limit import stability_limit
from housefly.lab.reproduction.streams import LATENCIES
from housefly.lab.reproduction.trial_list import TRIALS
from housefly.lab.reproduction.trials import fly_trials
from housefly.pilot.estimation.estimator_state import EstimatorKind
from housefly.twin.quadrotor.battery import Battery

BY_KEY = {claim.key: claim for claim in CLAIMS}


class ShortService:
    """A service that hovers for some seconds, with the battery that it took from the twin."""

    mode, outcome = "paper", "completed"

    def __init__(self, seconds: float) -> None:
        battery = Battery(1.0)
        battery.drain(seconds, 1.0)
        self.battery_used = 1.0 - battery.charge


@pytest.mark.parametrize(("seconds", "verdict"), [(58.0, Verdict.HOLDS), (3.0, Verdict.FAILS)])
def test_the_battery_matters_unless_services_are_over_in_a_moment(
    evidence: Evidence, seconds: float, verdict: Verdict
) -> None:
    claim = BY_KEY["battery"]
    flown = replace(evidence, services=(ShortService(seconds),))  # type: ignore[arg-type]
    assert finding_of(claim, flown).verdict is verdict
    assert finding_of(claim, evidence).verdict is Verdict.NOT_TESTABLE


def test_a_service_that_nobody_flew_proves_nothing(evidence: Evidence) -> None:
    elsewhere = service(mocap_rate_hz=11.0)(evidence)
    assert finding_of(BY_KEY["service"], elsewhere).verdict is Verdict.NOT_TESTABLE


def test_no_service_of_this_world_is_told_of_in_another(evidence: Evidence) -> None:
    flown = replace(evidence, services=(ShortService(58.0),))  # type: ignore[arg-type]
    assert "On the twin" in finding_of(BY_KEY["service"], flown).evidence
    there = service(wind_y=0.6)(flown)
    assert "On the twin" not in finding_of(BY_KEY["service"], there).evidence


def test_low_frame_rate_harms_who_differentiates_and_not_a_correct_filter(
    evidence: Evidence,
) -> None:
    """The claim that readers care about most; the numbers behind it."""

    def kept(estimator: int, latency: float) -> float:
        slow, fast = (
            stability_limit(evidence.edges, estimator, rate, latency).frequency.value
            for rate in (10.0, 100.0)
        )
        return slow / fast

    assert kept(EstimatorKind.FINITE_DIFFERENCE, 0.0) < 0.75
    assert kept(EstimatorKind.DELAY_COMPENSATED, 0.05) > 0.8
    assert kept(EstimatorKind.ON_ARRIVAL, 0.05) > kept(EstimatorKind.FINITE_DIFFERENCE, 0.05)


@pytest.mark.parametrize("kept", [0.7, 0.9])
def test_a_filter_fed_again_and_again_is_named_only_where_it_suffers(
    evidence: Evidence, kept: float
) -> None:
    values = evidence.edges.values.copy()
    held, late = list(ESTIMATORS).index(EstimatorKind.HELD_SAMPLE), LATENCIES.index(0.05)
    values[held, 0, late] = kept * values[held, -1, late]
    there = replace(evidence, edges=replace(evidence.edges, values=values))
    found = finding_of(BY_KEY["low frame rate"], there)
    assert found.verdict is Verdict.CONDITION
    assert ("or fed again and again" in found.evidence) is (kept < 0.8)


def test_every_drone_that_flew_is_counted(evidence: Evidence, flown: list[int]) -> None:
    assert evidence.flights == sum(flown)


@pytest.mark.parametrize(
    ("calm", "quarter", "printed", "words"),
    [
        (0.1, 0.1, 0.1, "All do here, but the flights are too few"),
        (0.1, 0.1, 0.3, "As long as the acceptor does not chatter"),
        (0.3, 0.1, 0.3, "Below half a cell for all"),
        (0.3, 0.3, 0.3, "For most, not for all"),
    ],
)
def test_the_condition_on_eps3_says_no_more_than_its_shares(
    evidence: Evidence, calm: float, quarter: float, printed: float, words: str
) -> None:
    """Six of six flights prove no more than 61 %."""
    trials = dict(evidence.trials)
    for key, error in (("eps3 0.4 m", calm), ("eps3 0.25 m", quarter), ("as printed", printed)):
        trials[key] = trials[key].copy()
        trials[key]["arrival_error"] = 0.1
        trials[key]["arrival_error"][0] = error
    found = finding_of(BY_KEY["eps3 below a cell"], replace(evidence, trials=trials))
    assert found.verdict is Verdict.CONDITION and found.evidence.startswith(words)


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
