"""The tables that the paper lacks: one measure per table, with 95 % intervals over drones."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from housefly.config.site import Mode
from housefly.lab.experiments.intervals import IntervalEstimate, mean, share
from housefly.lab.experiments.outcomes import Outcomes
from housefly.lab.reproduction.edges import ESTIMATORS, FREQUENCIES
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.exhibit import Table
from housefly.lab.reproduction.stability_limit import StabilityLimit, stability_limit
from housefly.lab.reproduction.streams import (
    LATENCIES,
    LOOP_FREQUENCIES,
    LOSSES,
    OWN_FREQUENCY,
    RATES,
    TYPICAL_LATENCY,
    TYPICAL_LOSS,
    TYPICAL_RATE,
)

MODE_ORDER: tuple[Mode, Mode] = ("paper", "default")
_MIN_STABLE_SHARE = 0.5
"""Errors are means over stable flights; below this share of them the cell stays empty."""
_NO_NUMBER = "-"
_AS_FIRST = "Flights, drones, intervals and what counts as stable: as in Table 1."


@dataclass(frozen=True, slots=True)
class _Measure:
    """One measure of the service as tables show it.

    Attributes:
        title: of its table.
        measure: column of the outcomes.
        heading: with the unit, for tables of several measures.
        scale: shown over SI.
        digits: behind the point.
    """

    title: str
    measure: str
    heading: str
    scale: float = 1.0
    digits: int = 2


_STABLE = _Measure(
    "How many flights stay near the path and end at rest? [%]", "stable", "stable [%]", 100.0, 0
)
_MEASURES: tuple[_Measure, ...] = (
    _STABLE,
    _Measure(
        "How far from the planned path? Root mean square [cm]", "rms_error", "RMS [cm]", 100.0, 1
    ),
    _Measure("How far from the planned path at worst? [cm]", "max_error", "max. [cm]", 100.0, 1),
    _Measure("How far from the goal at the end? [cm]", "arrival_error", "arrival [cm]", 100.0, 1),
    _Measure("How far past the goal? [cm]", "overshoot", "overshoot [cm]", 100.0, 1),
    _Measure("How long until it is there for good? [s]", "arrival_time", "time [s]", 1.0, 1),
    _Measure(
        "How often does the acceptor change its state? [1/s]",
        "switches_per_s",
        "switches [1/s]",
        1.0,
        2,
    ),
)


def tables(evidence: Evidence) -> tuple[Table, ...]:
    """Return all tables: by stream, by gains, by gains on the worst stream, edges by estimator."""
    first, *others = (_by_stream(evidence, question) for question in _MEASURES)
    return (
        first,
        *(replace(table, note=_AS_FIRST) for table in others),
        _by_gains(evidence),
        _stable_by_gains(evidence),
        _edges(evidence),
    )


def _by_stream(evidence: Evidence, question: _Measure) -> Table:
    streams = list(product(LOSSES, LATENCIES))
    rows = []
    for mode, rate in product(MODE_ORDER, RATES):
        cells = (
            _cell(
                evidence.streams.where(
                    mode=mode, mocap_rate_hz=rate, mocap_latency=latency, mocap_dropout=loss
                ),
                question,
            )
            for loss, latency in streams
        )
        rows.append((mode, f"{rate:.0f}", *cells))
    headings = ("mode", "frames/s", *(_stream_name(latency, loss) for loss, latency in streams))
    return Table(question.title, headings, tuple(rows), _note(evidence))


def _by_gains(evidence: Evidence) -> Table:
    rows = []
    for mode, frequency in product(MODE_ORDER, LOOP_FREQUENCIES):
        outcomes = _at_gains(evidence, mode, frequency, TYPICAL_RATE, TYPICAL_LATENCY, TYPICAL_LOSS)
        rows.append(
            (mode, *_gains_cells(frequency), *(_cell(outcomes, question) for question in _MEASURES))
        )
    headings = (
        "mode",
        "omega [rad/s]",
        "alpha [1/s]",
        "beta [1/s^2]",
        *(question.heading for question in _MEASURES),
    )
    stream = f"{TYPICAL_RATE:.0f} frames/s, {1000 * TYPICAL_LATENCY:.0f} ms late"
    note = (
        f"Tracking at {stream}. alpha = 2 omega, beta = omega^2: critically damped; {OWN_FREQUENCY}"
        " rad/s is the site's own. "
    )
    return Table("What do cautious and stiff gains give?", headings, tuple(rows), note + _AS_FIRST)


def _stable_by_gains(evidence: Evidence) -> Table:
    latency, loss = LATENCIES[-1], LOSSES[-1]
    rows = []
    for mode, frequency in product(MODE_ORDER, LOOP_FREQUENCIES):
        cells = (
            _cell(_at_gains(evidence, mode, frequency, rate, latency, loss), _STABLE)
            for rate in RATES
        )
        rows.append((mode, *_gains_cells(frequency), *cells))
    headings = (
        "mode",
        "omega [rad/s]",
        "alpha [1/s]",
        "beta [1/s^2]",
        *(f"{rate:.0f} frames/s" for rate in RATES),
    )
    title = (
        f"How stiff may the gains be where tracking is worst ({_stream_name(latency, loss)})?"
        " Flights that stay near the path and end at rest [%]"
    )
    return Table(title, headings, tuple(rows), _AS_FIRST)


def _edges(evidence: Evidence) -> Table:
    rows = tuple(
        (
            name,
            f"{1000 * latency:.0f}",
            *(_limit(stability_limit(evidence.edges, estimator, rate, latency)) for rate in RATES),
        )
        for (estimator, name), latency in product(ESTIMATORS.items(), LATENCIES)
    )
    note = (
        "Law (20)-(21), a step of one cell in still air, no frame lost; mean over all"
        f" {evidence.edges.values.shape[-1]} drones with its 95 % bootstrap interval. A drone that"
        f" rings at every frequency tried, from {FREQUENCIES[0]:.1f} rad/s on, counts as 0, one"
        f" that never rings as {FREQUENCIES[-1]:.0f} rad/s; \u2193 and \u2191 say how many. The"
        " command delay of the drone comes on top of the latency."
    )
    headings = ("estimator", "latency [ms]", *(f"{rate:.0f} frames/s" for rate in RATES))
    return Table(
        "Largest natural frequency at which the position loop does not ring [rad/s]",
        headings,
        rows,
        note,
    )


def _limit(limit: StabilityLimit) -> str:
    middle, low, high = limit.frequency
    outside = f" \u2193{limit.ringing}" * (limit.ringing > 0)
    outside += f" \u2191{limit.beyond}" * (limit.beyond > 0)
    return f"{middle:.1f} ({low:.1f}-{high:.1f}){outside}"


def _at_gains(
    evidence: Evidence, mode: Mode, frequency: float, rate: float, latency: float, loss: float
) -> Outcomes:
    return evidence.streams.where(
        mode=mode,
        frequency=frequency,
        mocap_rate_hz=rate,
        mocap_latency=latency,
        mocap_dropout=loss,
    )


def _gains_cells(frequency: float) -> tuple[str, str, str]:
    return f"{frequency:.1f}", f"{2 * frequency:.1f}", f"{frequency**2:.2f}"


def _cell(outcomes: Outcomes, question: _Measure) -> str:
    stable = outcomes["stable"] == 1.0
    if question is _STABLE:
        part = share(stable)
        return f"{100 * part.value:.0f} ({100 * part.low:.0f}-{100 * part.high:.0f})"
    if stable.mean() < _MIN_STABLE_SHARE:
        return _NO_NUMBER
    numbers = outcomes[question.measure][stable]
    measured = int(np.isfinite(numbers).sum())
    cell = _number(mean(numbers), question.scale, question.digits)
    return cell if measured == numbers.size else f"{cell} [{measured}/{numbers.size}]"


def _number(estimate: IntervalEstimate, scale: float, digits: int) -> str:
    if not np.isfinite(estimate.value):
        return _NO_NUMBER
    middle = f"{scale * estimate.value:.{digits}f}"
    return (
        f"{middle} ± {scale * estimate.half:.{digits}f}" if np.isfinite(estimate.half) else middle
    )


def _stream_name(latency: float, loss: float) -> str:
    late = f"{1000 * latency:.0f} ms late"
    return f"{late}, {100 * loss:.0f} % lost" if loss else late


def _note(evidence: Evidence) -> str:
    seeds = evidence.streams.where(
        mode=MODE_ORDER[0],
        mocap_rate_hz=RATES[0],
        mocap_latency=LATENCIES[0],
        mocap_dropout=LOSSES[0],
    ).size
    return (
        f"The service's outbound way; {seeds} drones with constants drawn around the identified"
        " ones, the same in every cell. Shares with Wilson's 95 % interval; means ± half the"
        " width of Student's. Errors are of the flights that stayed stable"
        f" ({_NO_NUMBER}: less than half did, or none arrived): never more than 1 m off the way,"
        " moving by less than 10 cm in the last 2 s. So a drone that soft gains leave under way, or"
        " that moving air pushes off while no behavior holds its place, is not counted as stable"
        " either. [n/m]: only n of the m stable flights arrived, and the mean is theirs."
    )
