"""How far a loop is from its edge: gain, phase and delay margins, found on the sampled loop itself."""

from __future__ import annotations

from cmath import exp
from collections.abc import Callable
from dataclasses import replace
from math import inf, pi
from typing import NamedTuple

import numpy as np

from housefly.lab.tuning.loop import Loop, period_of

PHASES = (0.02, 0.5, 0.98)
"""Frames may come anywhere between two ticks; margins are those of the worst of these places."""
GAIN_MAX = 40.0
DELAY_MAX = 1.5
"""Margins beyond these are not looked for: 40 times the gain, 1.5 s."""
PRECISION = 0.003
"""Share to which margins are found."""


class Margins(NamedTuple):
    """What may change before the loop is unstable; zero or one when it is so already.

    Attributes:
        gain: the drone may do this many times what it is asked.
        phase: further lag at any frequency [rad].
        delay: further delay that the filter does not know [s].
    """

    gain: float
    phase: float
    delay: float


def is_stable(loop: Loop) -> bool:
    """Return whether the loop is stable wherever frames fall between two ticks."""
    return all(period_of(replace(loop, phase=phase)).growth < 1.0 for phase in PHASES)


def margins_of(loop: Loop) -> Margins:
    """Return the margins of a loop."""
    if not is_stable(loop):
        return Margins(1.0, 0.0, 0.0)
    return Margins(gain_margin(loop), phase_margin(loop), delay_margin(loop))


def gain_margin(loop: Loop) -> float:
    """Return by how much the drone's answer may be larger than the filter and the law believe."""
    return _first_edge(
        lambda factor: is_stable(replace(loop, factor=factor)), np.geomspace(1.0, GAIN_MAX, 24)
    )


def phase_margin(loop: Loop) -> float:
    """Return the further lag [rad] at which the loop begins to swing."""
    return _first_edge(
        lambda angle: is_stable(replace(loop, factor=exp(-1j * angle))), np.linspace(0.0, pi, 37)
    )


def delay_margin(loop: Loop) -> float:
    """Return the further command delay [s], unknown to the filter, at which the loop begins to
    swing.
    """
    known = loop.delay if loop.model_delay is None else loop.model_delay
    places = np.concatenate(([0.0], np.geomspace(0.01, DELAY_MAX, 24)))
    return _first_edge(
        lambda extra: is_stable(replace(loop, delay=loop.delay + extra, model_delay=known)), places
    )


def _first_edge(stable: Callable[[float], bool], places: np.ndarray) -> float:
    """Return the first place at which stability ends: looked for in steps, then by bisection."""
    inside = float(places[0])
    for outside in map(float, places[1:]):
        if not stable(outside):
            return _bisected(stable, inside, outside)
        inside = outside
    return inf


def _bisected(stable: Callable[[float], bool], inside: float, outside: float) -> float:
    while outside - inside > PRECISION * outside:
        middle = 0.5 * (inside + outside)
        inside, outside = (middle, outside) if stable(middle) else (inside, middle)
    return 0.5 * (inside + outside)
