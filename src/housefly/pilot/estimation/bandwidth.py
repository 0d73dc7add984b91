"""How stiff the position loop may be with the tracking that there is, compiled.

The compensated loop is limited by what its prediction has wrong. An error of delta seconds in the
delay multiplies the loop by exp(-i w delta), off by at most w delta; the closed loop of eq. (20)
with damping 1 has a gain of at most 2 wn / w there. It stays stable for 2 wn delta < 1 (small
gain), and ``GAIN_MARGIN`` keeps that far away. Derivation: ``docs/flight.md``.
"""

from __future__ import annotations

from math import isfinite

from housefly.numeric import compiled

GAIN_MARGIN = 2.0
"""The loop is this much softer than the bound of the small gain theorem."""


@compiled
def bandwidth(delay: float, latency: float, interval: float, lag: float, mistrust: float) -> float:
    """Return the largest natural frequency to ask for [rad/s].

    Args:
        delay: from command to first reaction [s].
        latency: of a sighting [s]; not a number where unknown.
        interval: between two sightings [s]; not a number where unknown.
        lag: lambda of eqs. (22)-(23) [1/s].
        mistrust: share by which delays and lag may be other than believed.
    """
    late = latency if isfinite(latency) else 0.0
    held = 0.5 * interval if isfinite(interval) else 0.0
    delta = mistrust * (delay + late + 1.0 / lag) + held
    return 1.0 / (2.0 * GAIN_MARGIN * delta)
