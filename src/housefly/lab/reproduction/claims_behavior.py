"""What the paper claims in sections V-A and V-B: dynamics, behaviors, transitions."""

from __future__ import annotations

from math import degrees

import numpy as np

from housefly.lab.experiments.intervals import IntervalEstimate, mean, share
from housefly.lab.experiments.outcomes import Outcomes
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.exhibit import Verdict
from housefly.lab.reproduction.opposing_judges import judge_height_law
from housefly.lab.reproduction.routes import PAPER_CELL
from housefly.lab.reproduction.ruling import Claim, Ruling, centimetres, percents, untestable
from housefly.lab.reproduction.trial_list import LITERAL_EPS2

_EXACT = 1e-9
"""Two formulas are the same when they differ by less than rounding [m/s^2]."""
_IN_CELL = 0.5 * PAPER_CELL
"""Closer than this to the middle of the goal's square is inside it, in any direction [m]."""
_MOST_FLIGHTS = 0.95
"""Share of flights that counts as all of them."""
_FEW_FLIGHTS = 0.5
"""Below this share of successful flights something does not work."""
_MAX_SWITCH_RATE = 1.0
"""The acceptor chatters above this rate of state changes [1/s]."""
_COSTLY_FACTOR = 1.1
"""A change that multiplies an error by this matters."""
_HOLD_RADIUS = 0.05
"""A drone that stays within this distance holds its place [m]."""
_RUNAWAY_ERROR = 1.0
"""A larger error means a flight out of control [m]."""


def _motion(evidence: Evidence) -> Ruling:
    """Rule on (5)-(7) as consequences of (4)."""
    facts = evidence.equations
    text = (
        f"With f_g as printed the rows differ by up to {facts.newton_printed:.1f} m/s^2, with f_g ="
        f" (0, 0, m g) by {facts.newton_mended:.0e}."
    )
    if facts.newton_mended > _EXACT:
        return Ruling(Verdict.FAILS, text)
    if facts.newton_printed > _EXACT:
        return Ruling(Verdict.CONDITION, "With the weight as a force that points down. " + text)
    return Ruling(Verdict.HOLDS, text)


def _planar(evidence: Evidence) -> Ruling:
    """Rule on (8)-(9) as the dynamics at constant height."""
    facts = evidence.equations
    text = (
        "At the headings 0 and pi they are exact; within 0.21 rad of tilt they are wrong by up to"
        f" {facts.planar_elsewhere:.1f} m/s^2 at other headings."
    )
    if facts.planar_at_two > _EXACT:
        return Ruling(Verdict.FAILS, text)
    verdict = Verdict.HOLDS if facts.planar_elsewhere <= _EXACT else Verdict.CONDITION
    return Ruling(verdict, text)


def _two_directions(evidence: Evidence) -> Ruling:
    """Rule on the two headings as all that a path in this room needs."""
    maps = evidence.maps
    text = (
        f"{maps.legs_along_y} of the {maps.legs} legs of the service's way run along y, for which"
        " no heading is given."
    )
    if maps.legs_along_y == 0:
        return Ruling(Verdict.HOLDS, text)
    return Ruling(Verdict.CONDITION, "Along x; along y the drone must keep the last one. " + text)


def _heading_pi(evidence: Evidence) -> Ruling:
    """Rule on psi_ref = pi with the yaw law as printed, its difference not wrapped."""
    wrapped, literal = (_arrived(evidence, key) for key in ("as printed", "no wrap"))
    text = (
        f"With the difference as printed {percents(literal)} of the flights reach the goal and stay"
        f" there, wrapped {percents(wrapped)}."
    )
    if literal.value >= _MOST_FLIGHTS * wrapped.value:
        return Ruling(Verdict.HOLDS, text)
    return Ruling(Verdict.CONDITION, "Only with the difference of angles wrapped. " + text)


def _one_at_a_time(evidence: Evidence) -> Ruling:
    """Rule on "behaviors keep height and heading so that a 2-D path can be tracked".

    The measure is what swapping behaviors costs in path error.
    """
    swapped, always = (
        mean(evidence.trials[key]["rms_error"]) for key in ("eps2 0.2 rad", "always tracking")
    )
    printed = mean(evidence.trials["as printed"]["rms_error"])
    text = (
        f"From the path it is {centimetres(always)} (root mean square) while path tracking is"
        f" always on, {centimetres(swapped)} with the behaviors swapped at 0.2 rad,"
        f" {centimetres(printed)} at the printed 0.2 deg."
    )
    if printed.value <= _COSTLY_FACTOR * always.value:
        return Ruling(Verdict.HOLDS, text)
    return Ruling(
        Verdict.CONDITION, "While another behavior is active nothing holds the place. " + text
    )


def _q2_after_q1(evidence: Evidence) -> Ruling:
    """Rule on "q2 cannot be true until q1 is not"."""
    overlap = evidence.equations.overlap
    text = f"Of {overlap.inputs} combinations of errors {overlap.q2_with_q1} make both true."
    return Ruling(Verdict.HOLDS if overlap.q2_with_q1 == 0 else Verdict.FAILS, text)


def _execution_order(evidence: Evidence) -> Ruling:
    """Rule on "transitions have a predefined execution order"."""
    overlap = evidence.equations.overlap
    text = (
        f"Of {overlap.inputs} combinations of errors {overlap.several} make several conditions true"
        f" and {overlap.none} none."
    )
    if overlap.several == overlap.none == 0:
        return Ruling(Verdict.HOLDS, text)
    return Ruling(
        Verdict.CONDITION,
        "Not by the conditions alone, only once the order itself decides. " + text,
    )


def _eps2(evidence: Evidence) -> Ruling:
    """Rule on eps2 = 0.2 deg."""
    printed, wider = (evidence.trials[key] for key in ("as printed", "eps2 0.2 rad"))
    rate, calm = mean(printed["switches_per_s"]), mean(wider["switches_per_s"])
    text = (
        f"At {degrees(LITERAL_EPS2):.1f} deg the acceptor changes its state {rate.value:.1f} times"
        f" a second and {_time_taken(printed)}; at 0.2 rad {calm.value:.2f} times and"
        f" {_time_taken(wider)}."
    )
    if rate.value <= _MAX_SWITCH_RATE:
        return Ruling(Verdict.HOLDS, text)
    works = _arrived(evidence, "as printed").value >= _FEW_FLIGHTS
    return Ruling(
        Verdict.CONDITION if works else Verdict.FAILS,
        ("It mostly arrives, but chatters. " if works else "") + text,
    )


def _time_taken(outcomes: Outcomes) -> str:
    """Return how many flights arrive and stay, and their mean time."""
    times = outcomes["arrival_time"]
    arrived = int(np.isfinite(times).sum())
    if not arrived:
        return f"none of {times.size} flights arrives"
    return f"{arrived} of {times.size} flights arrive, in {mean(times).value:.0f} s"


def _eps3_small(evidence: Evidence) -> Ruling:
    """Rule on "eps3 < 0.5 m is convenient", with an acceptor that does not chatter and as printed.

    Where it could matter is the goal's square, half a cell to each side.
    """
    keys = ("eps3 0.4 m", "eps3 0.25 m", "as printed")
    calm, quarter, printed = (_inside(evidence, key) for key in keys)
    text = (
        f"With eps2 of 0.2 rad {percents(calm)} of the flights end within {_IN_CELL:.2f} m of the"
        f" goal with eps3 = 0.4 m, {percents(quarter)} with 0.25 m; with eps3 = 0.4 m and the"
        f" printed eps2 of 0.2 deg {percents(printed)}."
    )
    if calm.value < _FEW_FLIGHTS:
        return Ruling(Verdict.FAILS, text)
    if min(calm.low, printed.low) >= _MOST_FLIGHTS:
        return Ruling(Verdict.HOLDS, text)
    return Ruling(Verdict.CONDITION, _eps3_condition(calm, quarter, printed) + text)


def _eps3_condition(
    calm: IntervalEstimate, quarter: IntervalEstimate, printed: IntervalEstimate
) -> str:
    if calm.value < _MOST_FLIGHTS <= quarter.value:
        return "Below half a cell for all, not below a cell. "
    if calm.value < _MOST_FLIGHTS:
        return "For most, not for all. "
    if printed.value < _MOST_FLIGHTS:
        return "As long as the acceptor does not chatter. "
    return "All do here, but the flights are too few to be sure of it. "


def _eps3_one(evidence: Evidence) -> Ruling:
    """Rule on "eps3 = 1 m does not satisfy"."""
    wide = _inside(evidence, "eps3 1 m")
    error = mean(evidence.trials["eps3 1 m"]["arrival_error"])
    text = (
        f"With eps2 of 0.2 rad {percents(wide)} of the flights end in the goal's square; they end"
        f" {centimetres(error)} from its middle."
    )
    return Ruling(Verdict.HOLDS if wide.value < _FEW_FLIGHTS else Verdict.FAILS, text)


def _hover(evidence: Evidence) -> Ruling:
    """Rule on "hover maintains a fixed position"."""
    strayed = mean(evidence.trials["hover"]["max_error"])
    text = f"In 30 s of hover the drone strays by up to {centimetres(strayed)}."
    if strayed.value <= _HOLD_RADIUS:
        return Ruling(Verdict.HOLDS, text)
    if strayed.value <= _RUNAWAY_ERROR:
        return Ruling(
            Verdict.CONDITION,
            "It stops the drone, but what moving air shifts it by stays: it knows no place to"
            " return to. " + text,
        )
    return Ruling(Verdict.FAILS, text)


def _arrived(evidence: Evidence, key: str) -> IntervalEstimate:
    return share(np.isfinite(evidence.trials[key]["arrival_time"]))


def _inside(evidence: Evidence, key: str) -> IntervalEstimate:
    return share(evidence.trials[key]["arrival_error"] < _IN_CELL)


BEHAVIOR_CLAIMS: tuple[Claim, ...] = (
    Claim("equations of motion", "V-A", "(5)-(7) follow from Newton's law (4)", _motion, ("8",)),
    Claim(
        "unknown thrust",
        "V-A",
        "motor speeds cannot be read on this drone, so the thrust is unknown",
        untestable("A property of the drone's closed firmware; the law does not need the thrust."),
    ),
    Claim("planar dynamics", "V-B", "at constant height the drone obeys (8)-(10)", _planar, ("8",)),
    Claim(
        "acceptors fit",
        "V-B",
        "finite state acceptors specify such behaviors best",
        untestable("A quotation about design; nothing to measure."),
        ("9", "10"),
    ),
    Claim(
        "two directions",
        "V-B",
        "two major directions can be identified, psi = 0 and pi",
        _two_directions,
        ("7",),
    ),
    Claim(
        "yaw law",
        "V-B",
        "a proportional law controls the heading, psi_ref = pi among them",
        _heading_pi,
    ),
    Claim("height law", "V-B", "u_z = K2 (z - z_ref) controls the height", judge_height_law),
    Claim(
        "fewer degrees of freedom",
        "V-B",
        "height and heading are kept fixed by behaviors of their own, which leaves a 2-D path to"
        " track",
        _one_at_a_time,
        ("10",),
    ),
    Claim("q2 after q1", "V-B", "q2 cannot be true until q1 is not", _q2_after_q1, ("10",)),
    Claim(
        "execution order",
        "V-B",
        "the transitions have a predefined execution order",
        _execution_order,
        ("10",),
    ),
    Claim("eps2", "V-B", "eps2 = 0.2 deg was used in the experiments", _eps2, ("10",)),
    Claim("eps3 below a cell", "V-B", "eps3 below 0.5 m is convenient", _eps3_small, ("7",)),
    Claim(
        "eps3 of a metre", "V-B", "eps3 = 1 m does not give satisfying results", _eps3_one, ("7",)
    ),
    Claim("hover", "V-B, VI", "hover maintains a fixed position", _hover, ("10", "14")),
)
