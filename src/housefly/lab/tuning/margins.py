"""Gain, phase and delay margins of the sampled loop."""

from __future__ import annotations

from cmath import exp
from collections.abc import Callable
from dataclasses import replace
from math import inf, pi
from typing import NamedTuple

import numpy as np

from housefly.lab.tuning.loop import Loop, growth_of

_FRAME_PHASES = (0.02, 0.5, 0.98)
"""Frames may fall anywhere between two ticks; margins are the worst of these phases."""
_MAX_GAIN = 40.0
_MAX_DELAY = 1.5
"""Larger margins are not searched for: 40 times the gain, 1.5 s."""
_PRECISION = 0.003
"""Relative precision of the margins."""


class Margins(NamedTuple):
    """What may change before the loop becomes unstable; zero or one when it already is.

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
    return all(growth_of(replace(loop, phase=phase)) < 1.0 for phase in _FRAME_PHASES)


def margins_of(loop: Loop) -> Margins:
    """Return the margins of a loop."""
    if not is_stable(loop):
        return Margins(1.0, 0.0, 0.0)
    return Margins(gain_margin(loop), phase_margin(loop), delay_margin(loop))


def gain_margin(loop: Loop) -> float:
    """Return the factor by which the drone's response may exceed the model's."""
    return _first_edge(
        lambda factor: is_stable(replace(loop, factor=factor)), np.geomspace(1.0, _MAX_GAIN, 24)
    )


def phase_margin(loop: Loop) -> float:
    """Return the additional phase lag [rad] at which stability ends."""
    return _first_edge(
        lambda angle: is_stable(replace(loop, factor=exp(-1j * angle))), np.linspace(0.0, pi, 37)
    )


def delay_margin(loop: Loop) -> float:
    """Return the additional command delay [s], unknown to the filter, at which stability ends."""
    known = loop.delay if loop.model_delay is None else loop.model_delay
    places = np.concatenate(([0.0], np.geomspace(0.01, _MAX_DELAY, 24)))
    return _first_edge(
        lambda extra: is_stable(replace(loop, delay=loop.delay + extra, model_delay=known)), places
    )


def _first_edge(stable: Callable[[float], bool], places: np.ndarray) -> float:
    """Return the first value at which stability ends: searched in steps, then by bisection."""
    inside = float(places[0])
    for outside in map(float, places[1:]):
        if not stable(outside):
            return _bisected(stable, inside, outside)
        inside = outside
    return inf


def _bisected(stable: Callable[[float], bool], inside: float, outside: float) -> float:
    while outside - inside > _PRECISION * outside:
        middle = 0.5 * (inside + outside)
        inside, outside = (middle, outside) if stable(middle) else (inside, middle)
    return 0.5 * (inside + outside)
