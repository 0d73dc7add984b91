"""What the paper claims in sections V-C and V-D: control law, inner loop, Kalman filter."""

from __future__ import annotations

from housefly.lab.experiments.intervals import IntervalEstimate, mean, share
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.exhibit import Verdict
from housefly.lab.reproduction.opposing_judges import judge_lag_knowledge, judge_saturation
from housefly.lab.reproduction.ruling import (
    Claim,
    Ruling,
    percent,
    percents,
    untestable,
)
from housefly.lab.reproduction.tracking_judges import judge_estimation, judge_kalman

_CLOSE = 0.01
"""A response within this distance of the promised one counts as equal [m]."""
_ALL_FLIGHTS = 0.95
"""A share of flights that counts as all."""
_NEVER = 0.002
"""A share of the time no longer than the first instant of a step."""
_FELT_FACTOR = 1.1
"""A number multiplied by this has changed."""
_MAX_MISFIT = 0.1
"""A curve that leaves less than this share of the step describes its shape."""
_MAX_ERROR = 0.1
"""A constant off by more than this share is not identified."""
_AT_REST = 0.01
"""A drone that oscillates by less is at rest [m]."""


def _linearization(evidence: Evidence) -> Ruling:
    """Rule on "the law turns the dynamics into a second-order system"."""
    deviation = evidence.equations.step_deviation
    text = (
        f"A step of one cell strays from the second-order system by up to {100 * deviation:.1f} cm,"
        f" from the attitude lag alone (lambda = {evidence.site.drone.attitude_lag:g} 1/s)."
    )
    if deviation <= _CLOSE:
        return Ruling(Verdict.HOLDS, text)
    return Ruling(Verdict.CONDITION, "For angles that are reached at once. " + text)


def _eigenvalues(evidence: Evidence) -> Ruling:
    """Rule on "stable only if the eigenvalues of A have negative real parts"."""
    literal, ours = (_stable(evidence, key) for key in ("literal gain signs", "positive gains"))
    text = (
        f"With alpha and beta negative, as A asks for, {percents(literal)} of the flights stay"
        f" stable, with both positive {percents(ours)}: x is the error, reference less estimate,"
        " and turns the sign."
    )
    return Ruling(Verdict.HOLDS if literal.value >= _ALL_FLIGHTS else Verdict.FAILS, text)


def _chosen_gains(evidence: Evidence) -> Ruling:
    """Rule on "the choice of the coefficients keeps the commands within [-1, 1]"."""
    below, above = (
        mean(evidence.trials[key]["saturated"])
        for key in ("beta below saturation", "beta above saturation")
    )
    text = (
        f"On a step of one cell the commands are saturated {percent(below.value)} of the time with"
        f" beta = 3.24 1/s^2, {100 * above.value:.1f} % with 5.29: the bound is g tan(theta_max) /"
        " 0.5 m = 4.18."
    )
    if max(below.value, above.value) <= _NEVER:
        return Ruling(Verdict.HOLDS, text)
    return Ruling(
        Verdict.CONDITION if below.value <= _NEVER else Verdict.FAILS,
        "Below a bound that depends on the step. " + text,
    )


def _first_order(evidence: Evidence) -> Ruling:
    """Rule on "the shape of the curve validates a first-order system" (Fig. 11)."""
    step = evidence.pitch
    if step is None:
        return Ruling(Verdict.NOT_TESTABLE, "No step was flown on the twin in this run.")
    text = (
        f"Eq. (22) leaves {percent(step.misfit_without_delay)} of the step (root mean square), with"
        f" a pure delay of {1000 * step.delay:.0f} ms before it {percent(step.misfit)}."
    )
    if step.misfit > _MAX_MISFIT:
        return Ruling(Verdict.FAILS, text)
    if step.misfit_without_delay > _FELT_FACTOR * step.misfit:
        return Ruling(Verdict.CONDITION, "After a pure delay. " + text)
    return Ruling(Verdict.HOLDS, text)


def _identified(evidence: Evidence) -> Ruling:
    """Rule on "these data give an estimate of (c, lambda)"."""
    step = evidence.pitch
    if step is None:
        return Ruling(Verdict.NOT_TESTABLE, "No step was flown on the twin in this run.")
    true = evidence.site.drone.attitude_lag
    text = (
        f"lambda is {step.lag_without_delay:.1f} 1/s by eq. (22), {step.lag:.1f} with a delay; the"
        f" twin has {true:g}."
    )
    if abs(step.lag_without_delay / true - 1.0) <= _MAX_ERROR:
        return Ruling(Verdict.HOLDS, text)
    if abs(step.lag / true - 1.0) <= _MAX_ERROR:
        return Ruling(Verdict.CONDITION, "With the delay in the model. " + text)
    return Ruling(Verdict.FAILS, text)


def _independent_loops(evidence: Evidence) -> Ruling:
    """Rule on "two independent loops are running"."""
    below, above = (
        mean(evidence.trials[key]["residual"])
        for key in ("beta below lambda alpha", "beta above lambda alpha")
    )
    text = (
        f"Without any delay the outer loop swings by {100 * below.value:.1f} cm in the end with"
        f" beta at half of lambda alpha, by {100 * above.value:.0f} cm with beta at twice that."
    )
    if above.value <= _AT_REST:
        return Ruling(Verdict.HOLDS, text)
    if below.value <= _AT_REST:
        return Ruling(Verdict.CONDITION, "As long as beta < lambda alpha. " + text)
    return Ruling(Verdict.FAILS, text)


def _stable(evidence: Evidence, key: str) -> IntervalEstimate:
    return share(evidence.trials[key]["stable"] == 1.0)


CONTROL_CLAIMS: tuple[Claim, ...] = (
    Claim(
        "feedback linearization",
        "V-C",
        "(20)-(21) turn the dynamics into a second-order system",
        _linearization,
        ("12",),
    ),
    Claim(
        "eigenvalues",
        "V-C",
        "the loop is stable only if the eigenvalues of A have negative real parts",
        _eigenvalues,
    ),
    Claim(
        "choice of gains", "V-C", "acceptable gains keep the commands within [-1, 1]", _chosen_gains
    ),
    Claim(
        "saturation",
        "V-C",
        "saturation functions eliminate unexpected overshoots",
        judge_saturation,
    ),
    Claim(
        "first order",
        "V-C",
        "the shape of the angular response validates a first-order system",
        _first_order,
        ("11",),
    ),
    Claim(
        "identification",
        "V-C",
        "step responses give an estimate of (c, lambda)",
        _identified,
        ("11",),
    ),
    Claim(
        "symmetry",
        "V-C",
        "roll and pitch follow the same response because the drone is symmetric",
        untestable(
            "Our twin is symmetric by construction, so it proves nothing; on a drone `housefly"
            " identify` fits both."
        ),
        ("11",),
    ),
    Claim(
        "independent loops",
        "V-C",
        "outer and inner loop run independently",
        _independent_loops,
        ("12",),
    ),
    Claim(
        "use of (c, lambda)",
        "V-C",
        "(c, lambda) are of particular value for state estimation",
        judge_lag_knowledge,
        ("13",),
    ),
    Claim(
        "estimation is required",
        "V-D",
        "noisy positions without speeds ask for state estimation",
        judge_estimation,
        ("13",),
    ),
    Claim(
        "Kalman filter",
        "V-D",
        "a Kalman filter is a good estimator for this case",
        judge_kalman,
        ("13",),
    ),
)
