"""Three claims that hold in one place and not in another: judged where they could matter."""

from __future__ import annotations

import numpy as np

from housefly.lab.experiments.intervals import NOTHING, IntervalEstimate, mean, share
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.exhibit import OpposingCases, Verdict
from housefly.lab.reproduction.ruling import Ruling, centimetres, percents, rad_per_s, where_found
from housefly.lab.reproduction.trial_list import (
    FREE,
    HEIGHT_GAINS,
    POORLY_DAMPED,
    SATURATED,
    STEP_GAINS,
    STEPS,
    SWINGING,
    WELL_DAMPED,
    StepGains,
    TrialKind,
    height_key,
    step_key,
)
from housefly.numeric import FloatArray
from housefly.pilot.behavior.acceptor import PAPER_TOLERANCES
from housefly.pilot.estimation.estimator_state import EstimatorKind

_ALL_FLIGHTS = 0.95
"""Share of flights that counts as all of them."""
_FELT_FACTOR = 1.1
"""A number multiplied by this has changed."""
_NO_OVERSHOOT = 0.01
"""Overshoot that nobody would call one [m]."""
_STIFF = 8.3
"""A stiff loop: nearly three times what a filter that ignores the lag and the latency allows
[rad/s].
"""


def judge_lag_knowledge(evidence: Evidence) -> Ruling:
    """Rule on "(c, lambda) are of particular value for the state estimation".

    Where it could matter: on how stiff a loop settles. Against: on a cruise, and in the paper's own
    filter, which has no angle among its states.
    """
    flown, ours, theirs = (
        evidence.known_lag,
        EstimatorKind.DELAY_COMPENSATED,
        EstimatorKind.ON_ARRIVAL,
    )
    known, unknown = (flown.limit(ours, told).frequency for told in (True, False))
    with_it, without = (flown.share_at(_STIFF, ours, told) for told in (True, False))
    paper_known, paper_unknown = (flown.limit(theirs, told).frequency for told in (True, False))
    cruise_known, cruise_unknown = (
        1000.0 * mean(evidence.trials[key]["estimate_rms"]).value
        for key in ("lag known", "lag unknown")
    )
    cases = OpposingCases(
        f"A filter with the angle among its states settles a step of one cell up to"
        f" {rad_per_s(known)} when it knows lambda, up to {rad_per_s(unknown)} when it takes the"
        f" angles for reached at once; at {_STIFF} rad/s {percents(with_it)} of the drones settle"
        f" with it, {percents(without)} without.",
        f"On a way at constant speed the estimate is off by {cruise_known:.1f} mm (root mean"
        f" square) with lambda and by {cruise_unknown:.1f} mm without. The paper's own filter has"
        f" no angle among its states (x, x', y, y'): told lambda it settles up to"
        f" {rad_per_s(paper_known)}, told nothing up to {rad_per_s(paper_unknown)}.",
    )
    stiff, cruise = known.low > unknown.high, cruise_unknown > _FELT_FACTOR * cruise_known
    paper = paper_known.low > paper_unknown.high
    found = {
        "for stiff gains with a filter that has the angle among its states": stiff,
        "on a way at constant speed": cruise,
        "with a filter of the paper's four states": paper,
    }
    if all(found.values()):
        return Ruling(Verdict.HOLDS, cases.speaks_for, cases)
    text = f"{where_found(found)} {cases.speaks_for}"
    return Ruling(Verdict.CONDITION if any(found.values()) else Verdict.FAILS, text, cases)


def judge_saturation(evidence: Evidence) -> Ruling:
    """Rule on "saturation eliminates unexpected overshoots".

    Where it could matter: long steps and gains that overshoot. Against: steps of one cell, and
    gains that do not.
    """
    cases = OpposingCases(
        f"On a step of six cells, saturated at {SATURATED} rad and at {FREE},"
        f" {_overshoots(evidence, TrialKind.LONG, POORLY_DAMPED)},"
        f" {_overshoots(evidence, TrialKind.LONG, SWINGING)}; with the latter"
        f" {_stable_shares(evidence, TrialKind.LONG, SWINGING)} of the flights stay stable.",
        f"{_overshoots(evidence, TrialKind.LONG, WELL_DAMPED, capital=True)}: nothing to eliminate."
        " On a step of one cell, the paper's own, the command is hardly ever beyond the limit:"
        f" {_overshoots(evidence, TrialKind.CELL, POORLY_DAMPED)},"
        f" {_overshoots(evidence, TrialKind.CELL, SWINGING)}.",
    )
    pairs = [_overshoot_pair(evidence, kind, gains) for kind in STEPS for gains in STEP_GAINS]
    shooting = [limited for limited, free in pairs if free.value >= _NO_OVERSHOOT]
    gone = sum(limited.value < _NO_OVERSHOOT for limited in shooting)
    if shooting and gone == len(shooting):
        return Ruling(Verdict.HOLDS, cases.speaks_for, cases)
    cut = {
        f"with {gains.like} gains on a {kind.value}": _overshoot_cut(evidence, kind, gains).low
        > 0.0
        for kind in STEPS
        for gains in STEP_GAINS
    }
    if shooting and any(cut.values()):
        return Ruling(
            Verdict.CONDITION,
            f"It cuts overshoots; of {len(shooting)} it eliminates {gone}. {where_found(cut)}"
            f" {cases.speaks_for}",
            cases,
        )
    return Ruling(
        Verdict.FAILS, "It bounds the tilt, not the overshoot. " + cases.speaks_against, cases
    )


def judge_height_law(evidence: Evidence) -> Ruling:
    """Rule on u_z = K2 (z - z_ref), whose K2 the paper prints neither in size nor in sign."""
    errors = {gain: evidence.trials[height_key(gain)]["height_error"] for gain in HEIGHT_GAINS}
    holding = [
        gain
        for gain, error in errors.items()
        if share(error < PAPER_TOLERANCES.height).value >= _ALL_FLIGHTS
    ]
    below, above = ([gain for gain in holding if sign * gain > 0.0] for sign in (-1.0, 1.0))
    cases = OpposingCases(
        _held(errors, [gain for gain in HEIGHT_GAINS if gain < 0.0]),
        _held(errors, [gain for gain in HEIGHT_GAINS if gain > 0.0])
        + ("" if above else " A reader who takes K2 for positive, as gains mostly are, loses it."),
    )
    if below and above:
        return Ruling(Verdict.HOLDS, f"{cases.speaks_for} {cases.speaks_against}", cases)
    if below or above:
        return Ruling(
            Verdict.CONDITION,
            f"Holds for K2 {'below' if below else 'above'} 0 with u_z upwards, as this drone has"
            " it, not for the other sign; the paper prints neither sign nor size."
            f" {cases.speaks_for}",
            cases,
        )
    return Ruling(
        Verdict.FAILS, f"No K2 that was tried holds the height. {cases.speaks_for}", cases
    )


def _held(errors: dict[float, FloatArray], gains: list[float]) -> str:
    worst = [float(np.median(errors[gain])) for gain in gains]
    kept = sum(
        bool(share(errors[g] < PAPER_TOLERANCES.height).value >= _ALL_FLIGHTS) for g in gains
    )
    return (
        f"Of the K2 tried from {min(gains):g} to {max(gains):g} 1/s {kept} of {len(gains)} keep the"
        f" height within eps1 for 30 s; the drone is off by {_length(min(worst))} to"
        f" {_length(max(worst))} (medians)."
    )


def _length(metres: float) -> str:
    return f"{metres:.1f} m" if metres >= 1.0 else f"{1000 * metres:.1f} mm"


def _overshoot_pair(
    evidence: Evidence, kind: TrialKind, gains: StepGains
) -> tuple[IntervalEstimate, IntervalEstimate]:
    limited, free = (
        mean(evidence.trials[step_key(kind, gains, tilt)]["overshoot"])
        for tilt in (SATURATED, FREE)
    )
    return limited, free


def _overshoot_cut(evidence: Evidence, kind: TrialKind, gains: StepGains) -> IntervalEstimate:
    """Return by how much saturation shortens the overshoot, drone by drone [m]."""
    limited, free = (
        evidence.trials[step_key(kind, gains, tilt)]["overshoot"] for tilt in (SATURATED, FREE)
    )
    cut = mean(free - limited)
    return cut if cut.value >= _NO_OVERSHOOT else NOTHING


def _overshoots(
    evidence: Evidence, kind: TrialKind, gains: StepGains, capital: bool = False
) -> str:
    limited, free = _overshoot_pair(evidence, kind, gains)
    return (
        f"{gains.like.capitalize() if capital else gains.like} gains (alpha {gains.alpha:g}, beta"
        f" {gains.beta:g}) overshoot by {centimetres(limited)} saturated and {centimetres(free)}"
        " free"
    )


def _stable_shares(evidence: Evidence, kind: TrialKind, gains: StepGains) -> str:
    limited, free = (
        share(evidence.trials[step_key(kind, gains, tilt)]["stable"] == 1.0)
        for tilt in (SATURATED, FREE)
    )
    return f"{percents(limited)} saturated and {percents(free)} free"
