"""Claims about rate, latency and filter of the tracking, judged by how stiff a loop they allow."""

from __future__ import annotations

from housefly.lab.experiments.intervals import mean, share
from housefly.lab.reproduction.edges import FREQUENCIES
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.exhibit import OpposingCases, Verdict
from housefly.lab.reproduction.ruling import (
    Ruling,
    centimetres,
    percent,
    percents,
    rad_per_s,
    where_found,
)
from housefly.lab.reproduction.stability_limit import stability_limit
from housefly.lab.reproduction.streams import (
    LATENCIES,
    OWN_FREQUENCY,
    RATES,
    TYPICAL_LATENCY,
    TYPICAL_LOSS,
)
from housefly.pilot.estimation.estimator_state import EstimatorKind

_SLOW, _FAST = RATES[0], RATES[-1]
_PROMPT, _LATE = LATENCIES[0], LATENCIES[-1]
_UNHARMED_SHARE = 0.8
"""An estimator that keeps this share of its edge is not limited by what was changed.

It is half of what separates the paper's range of rates, and far outside the intervals of the edges.
"""
_FELT_FACTOR = 1.1
"""A number multiplied by this has changed."""
_NEVER = 0.002
"""A share of the time no longer than the first instant of a step."""
_NAMES = {
    EstimatorKind.FINITE_DIFFERENCE: "the held sample differentiated",
    EstimatorKind.HELD_SAMPLE: "a Kalman filter fed the held sample at every tick",
    EstimatorKind.ON_ARRIVAL: "a Kalman filter fed each frame once",
    EstimatorKind.DELAY_COMPENSATED: "the delay-compensated filter",
}
_CAREFUL = (EstimatorKind.ON_ARRIVAL, EstimatorKind.DELAY_COMPENSATED)
"""Estimators that use each frame once."""


def judge_low_rate(evidence: Evidence) -> Ruling:
    """Rule on "the low frame rate causes unstable behaviors" by edges at 100 and 10 Hz."""
    delay = _edge(evidence, EstimatorKind.ON_ARRIVAL, _FAST, _LATE) / max(
        _edge(evidence, EstimatorKind.ON_ARRIVAL, _FAST, _PROMPT), float(FREQUENCIES[0])
    )
    stable = share(
        evidence.streams.where(
            mode="paper",
            mocap_rate_hz=_SLOW,
            mocap_latency=TYPICAL_LATENCY,
            mocap_dropout=TYPICAL_LOSS,
        )["stable"]
        == 1.0
    )
    change = f"From {_FAST:.0f} to {_SLOW:.0f} frames/s the largest stable natural frequency keeps"
    careless = [kind for kind in _NAMES if kind not in _CAREFUL]
    cases = OpposingCases(
        f"{change} {', '.join(_words(evidence, kind) for kind in careless)}.",
        f"{change} {', '.join(_words(evidence, kind) for kind in _CAREFUL)}."
        f" {1000 * _LATE:.0f} ms of latency leave the paper's filter {percent(delay)} at"
        f" {_FAST:.0f} frames/s. With our gains {percents(stable)} of the paper's flights stay"
        f" stable at {_SLOW:.0f} frames/s.",
    )
    text = f"{cases.speaks_for} {cases.speaks_against}"
    if _kept(evidence, EstimatorKind.ON_ARRIVAL, TYPICAL_LATENCY) < _UNHARMED_SHARE:
        return Ruling(Verdict.HOLDS, text, cases)
    if _kept(evidence, EstimatorKind.FINITE_DIFFERENCE, TYPICAL_LATENCY) < _UNHARMED_SHARE:
        fed = _kept(evidence, EstimatorKind.HELD_SAMPLE, TYPICAL_LATENCY) < _UNHARMED_SHARE
        return Ruling(
            Verdict.CONDITION,
            f"Holds where frames are held and differentiated{', or fed again and again' * fed}, not"
            f" where each is used once. {text}",
            cases,
        )
    return Ruling(Verdict.FAILS, text, cases)


def judge_immediate(evidence: Evidence) -> Ruling:
    """Rule on "the database answers immediately" by what late answers cost the paper's filter."""
    prompt, middle, late = (
        _edge(evidence, EstimatorKind.ON_ARRIVAL, _FAST, latency) for latency in LATENCIES
    )
    text = (
        f"The largest stable natural frequency of the paper's filter is {prompt:.1f}, {middle:.1f}"
        f" and {late:.1f} rad/s when its frames are"
        f" {', '.join(f'{1000 * latency:.0f}' for latency in LATENCIES)} ms old."
    )
    if late >= _UNHARMED_SHARE * prompt:
        return Ruling(Verdict.HOLDS, text)
    return Ruling(
        Verdict.CONDITION,
        "Immediately must mean well below 50 ms for whoever flies by the answer. " + text,
    )


def judge_estimation(evidence: Evidence) -> Ruling:
    """Rule on "state estimation is required", against frames that are held and differentiated.

    Where it could matter: noise, and frames that come rarely. Against: fresh frames that come
    often.
    """
    raw, filtered = (evidence.trials[key] for key in ("unfiltered", "filtered"))
    shaken, calm = mean(raw["saturated"]), mean(filtered["saturated"])
    wide, narrow = mean(raw["rms_error"]), mean(filtered["rms_error"])
    (raw_rare, rare), (raw_often, often) = (
        tuple(
            stability_limit(evidence.edges, kind, rate, _PROMPT).frequency
            for kind in (EstimatorKind.FINITE_DIFFERENCE, EstimatorKind.ON_ARRIVAL)
        )
        for rate in (_SLOW, _FAST)
    )
    cases = OpposingCases(
        f"With 5 mm of noise the wanted tilt is beyond its limit {100 * shaken.value:.1f} % of the"
        f" time when frames are differentiated, {100 * calm.value:.1f} % with the filter. At"
        f" {_SLOW:.0f} frames/s the loop is stable up to {rad_per_s(raw_rare)} when they are"
        f" differentiated, up to {rad_per_s(rare)} with the filter.",
        f"At {_FAST:.0f} fresh frames/s it is stable up to {rad_per_s(raw_often)} when they are"
        f" differentiated, up to {rad_per_s(often)} with the filter. With 5 mm of noise the path is"
        f" kept to {centimetres(wide)} without and {centimetres(narrow)} with it.",
    )
    found = {
        "against noise": shaken.value > _FELT_FACTOR * max(calm.value, _NEVER),
        f"at {_SLOW:.0f} frames/s": rare.low > raw_rare.high,
        f"at {_FAST:.0f} fresh frames/s": often.low > raw_often.high,
    }
    text = f"{where_found(found)} {cases.speaks_for} {cases.speaks_against}"
    if all(found.values()):
        return Ruling(Verdict.HOLDS, text, cases)
    return Ruling(Verdict.CONDITION if any(found.values()) else Verdict.FAILS, text, cases)


def judge_kalman(evidence: Evidence) -> Ruling:
    """Rule on "a Kalman filter is a good estimator", against one that models lag and delays."""
    (theirs_prompt, ours_prompt), (theirs, ours) = (
        tuple(stability_limit(evidence.edges, kind, _FAST, latency).frequency for kind in _CAREFUL)
        for latency in (_PROMPT, _LATE)
    )
    cases = OpposingCases(
        f"The loop is stable up to {rad_per_s(theirs_prompt)} with the paper's filter when its"
        f" frames are fresh, up to {rad_per_s(theirs)} when they are {1000 * _LATE:.0f} ms old; our"
        f" gains need {OWN_FREQUENCY:.1f} rad/s.",
        f"With a filter that knows lag and delays it is stable up to {rad_per_s(ours_prompt)} and"
        f" {rad_per_s(ours)}.",
    )
    text = f"{cases.speaks_for} {cases.speaks_against}"
    if ours.low <= theirs.high:
        return Ruling(Verdict.HOLDS, text, cases)
    if theirs_prompt.low > OWN_FREQUENCY:
        return Ruling(
            Verdict.CONDITION,
            "Holds for gains as cautious as ours, not for stiff ones. " + text,
            cases,
        )
    return Ruling(Verdict.FAILS, text, cases)


def _words(evidence: Evidence, kind: EstimatorKind) -> str:
    late, prompt = (_kept(evidence, kind, latency) for latency in (TYPICAL_LATENCY, _PROMPT))
    return f"{percent(late)} ({percent(prompt)} without latency) with {_NAMES[kind]}"


def _kept(evidence: Evidence, kind: EstimatorKind, latency: float) -> float:
    """Return which share of its edge an estimator keeps when the frames become rare."""
    slow, fast = (_edge(evidence, kind, rate, latency) for rate in (_SLOW, _FAST))
    return slow / max(fast, float(FREQUENCIES[0]))


def _edge(evidence: Evidence, kind: EstimatorKind, rate: float, latency: float) -> float:
    return stability_limit(evidence.edges, kind, rate, latency).frequency.value
