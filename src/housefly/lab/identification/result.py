"""From blocks to the drone's constants, or to the reasons why the data cannot tell them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from housefly.config.profile import CONSTANTS, Interval
from housefly.lab.identification.fit import Fit
from housefly.lab.identification.pattern import TILT_AXES, Axis
from housefly.lab.identification.rates import TIME_CONSTANT, RateFit, fit_climb, fit_turn
from housefly.lab.identification.samples import Samples
from housefly.lab.identification.tilt import (
    TILT_DELAY,
    TILT_DRAG,
    TILT_GAIN,
    TILT_LAG,
    TiltFit,
    fit_tilt,
)
from housefly.lab.identification.truth import missed_constants

_MIN_BLOCKS = 4
"""Fewest blocks of each kind that give an interval."""
_MIN_FRAMES = 12
"""A block with fewer frames counts as unseen."""
_MAX_GAP = 0.25
"""A block with a longer gap between frames counts as unseen [s]."""
_MIN_SHARE = 0.05
"""A block whose command stays below this share of the limit excites nothing."""
_SATURATED_SHARE = 0.98
"""A block whose command exceeds this share of a limit may have been clipped."""
_MAX_HALF_WIDTH: dict[str, float] = {
    "attitude_gain": 0.15, "attitude_lag": 0.35, "command_delay": 0.03,
    "drag": 0.35, "climb_lag": 0.5, "yaw_lag": 1.5,
}  # fmt: skip
"""Largest half-width of an interval: a share of the value; in s for the delay, 1/s for drag."""
_ABSOLUTE_WIDTH = ("command_delay", "drag")


@dataclass(frozen=True, slots=True)
class Limits:
    """The site's limits: tilt [rad], climb [m/s], turn [rad/s]."""

    tilt: float
    climb: float
    turn: float


@dataclass(frozen=True, slots=True, eq=False)
class Identified:
    """The constants identified from a flight.

    Attributes:
        constants: by the keys of ``profile.CONSTANTS``.
        problems: why some cannot be believed, in words; a profile is written only when there are
            none.
        tilt, climb, turn: the fits; None where there was nothing to fit.
        blocks: that counted.
        truth: what a simulated drone ought to show, by the same keys; empty for a real one.
    """

    constants: dict[str, Interval]
    problems: tuple[str, ...]
    tilt: TiltFit | None
    climb: RateFit | None
    turn: RateFit | None
    blocks: tuple[Samples, ...]
    truth: Mapping[str, float] = field(default_factory=dict)

    @property
    def missed(self) -> tuple[str, ...]:
        """Keys of the constants whose interval does not hold the truth."""
        return missed_constants(self.constants, self.truth)

    @property
    def advice(self) -> str:
        """What to think of the constants and do with them, in plain sentences."""
        if self.problems:
            return f"no profile: {'; '.join(self.problems)}"
        if not self.truth:
            return "the profile may be written"
        if not self.missed:
            return "each interval holds the simulated value; the profile may be written"
        outside = ", ".join(f"{key} ({self.truth[key]:.3g})" for key in self.missed)
        return (
            f"outside its interval: {outside}. About one flight in four misses one of six constants"
            " by chance, and rarely two: fly again with another seed, and do not use the profile"
            " if the same constant misses again"
        )


def fit_constants(
    blocks: tuple[Samples, ...],
    limits: Limits,
    seed: int = 0,
    truth: Mapping[str, float] | None = None,
) -> Identified:
    """Return the constants with their 95 % intervals, and what is wrong with them.

    ``truth`` is what a simulated drone ought to show (``truth.simulated_truth``).
    """
    known = dict(truth or {})
    seen = tuple(
        block for block in blocks if block.at.size >= _MIN_FRAMES and block.gap <= _MAX_GAP
    )
    problems = [*_gaps(blocks, seen), *_excitation(seen, limits)]
    if problems:
        return Identified({}, tuple(problems), None, None, None, seen, known)
    tilt = fit_tilt(tuple(block for block in seen if block.block.axis in TILT_AXES), seed)
    delay, half = float(tilt.fit.constants[TILT_DELAY]), float(tilt.fit.half[TILT_DELAY])
    climb = fit_climb(
        tuple(block for block in seen if block.block.axis is Axis.CLIMB), delay, half, seed
    )
    turn = fit_turn(
        tuple(block for block in seen if block.block.axis is Axis.TURN), delay, half, seed
    )
    constants = {
        "attitude_gain": _interval(tilt.fit, TILT_GAIN),
        "attitude_lag": _interval(tilt.fit, TILT_LAG),
        "command_delay": _interval(tilt.fit, TILT_DELAY),
        "drag": _interval(tilt.fit, TILT_DRAG),
        "climb_lag": _pole(climb, "climb_lag"),
        "yaw_lag": _pole(turn, "yaw_lag"),
    }
    return Identified(constants, tuple(_doubts(constants, tilt)), tilt, climb, turn, seen, known)


def _interval(fit: Fit, number: int) -> Interval:
    value, half = float(fit.constants[number]), float(fit.half[number])
    return Interval(value, value - half, value + half)


def _pole(fit: RateFit, key: str) -> Interval:
    """Return a pole with its interval from the time constant's, clipped to the constant's range."""
    time, known = float(fit.fit.constants[TIME_CONSTANT]), CONSTANTS[key]
    low, high = 1.0 / (time + fit.half_time), 1.0 / max(time - fit.half_time, 1.0 / known.high)
    return Interval(min(1.0 / time, known.high), max(low, known.low), high)


def _gaps(blocks: tuple[Samples, ...], seen: tuple[Samples, ...]) -> list[str]:
    found = []
    for name, axes in (("tilt", TILT_AXES), ("climb", (Axis.CLIMB,)), ("turn", (Axis.TURN,))):
        flown = [block for block in blocks if block.block.axis in axes]
        good = [block for block in seen if block.block.axis in axes]
        if len(good) >= _MIN_BLOCKS:
            continue
        lost = len(flown) - len(good)
        if lost:
            worst = max(block.gap for block in flown)
            found.append(
                f"{lost} of {len(flown)} {name} steps were not seen well enough (longest gap of"
                f" tracking {worst:.2f} s, allowed {_MAX_GAP:g} s, at least {_MIN_FRAMES}"
                f" frames each): {len(good)} are left, {_MIN_BLOCKS} are needed"
            )
        else:
            found.append(
                f"{len(good)} {name} steps were flown, {_MIN_BLOCKS} are needed: fly with more"
                " --repeats"
            )
    return found


def _excitation(seen: tuple[Samples, ...], limits: Limits) -> list[str]:
    found = []
    bounds = {
        Axis.PITCH: limits.tilt,
        Axis.ROLL: limits.tilt,
        Axis.CLIMB: limits.climb,
        Axis.TURN: limits.turn,
    }
    for axis, bound in bounds.items():
        largest = [
            float(np.abs(block.sent[block.sent_at >= 0.0]).max(initial=0.0))
            for block in seen
            if block.block.axis is axis
        ]
        if largest and min(largest) < _MIN_SHARE * bound:
            found.append(
                f"{axis.value}: nothing was commanded in a step (no excitation), so nothing can be"
                " learned from it"
            )
        if largest and max(largest) > _SATURATED_SHARE * bound:
            found.append(
                f"{axis.value}: the command reached its limit ({bound:g}), so what was asked is not"
                " what was done"
            )
    return found


def _doubts(constants: dict[str, Interval], tilt: TiltFit) -> list[str]:
    found = [
        f"{key}: the fit ends on its bound ({constants[key].value:.3g}): the drone does not answer"
        " like the model"
        for number, key in enumerate(("attitude_gain", "attitude_lag", "command_delay", "drag"))
        if number in tilt.fit.at_bound and not (key == "drag" and constants[key].value < 0.05)
    ]
    for key, interval in constants.items():
        half = 0.5 * (interval.high - interval.low)
        allowed = _MAX_HALF_WIDTH[key] * (1.0 if key in _ABSOLUTE_WIDTH else interval.value)
        if half > allowed:
            known = CONSTANTS[key]
            unit = "" if known.unit == "1" else f" {known.unit}"
            found.append(
                f"{key}: {interval.value:.3g}{unit} is known only to ±{half:.2g} (allowed"
                f" ±{allowed:.2g}): fly more --repeats, or track faster or with less noise"
            )
    return found
