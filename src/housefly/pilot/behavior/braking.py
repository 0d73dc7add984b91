"""How soon and how hard the drone can be counted on to brake."""

from __future__ import annotations

BRAKING_DECELERATION = 1.0
"""How hard the drone can be counted on to brake [m/s^2]; at full tilt it is twice that."""
REACTION_TIME = 0.3
"""Time from the cause, or the order, to braking that distances allow for [s]."""
