"""How the drone can be counted on to brake, how fast it evades, how the pilot sinks to land."""

from __future__ import annotations

from housefly.geometry import Vec2

REFERENCE_BRAKING = 1.0
"""How hard a reference brakes that is to stop [m/s^2]; every airframe can."""
EVASION_SPEED = 1.2
"""It makes way as fast as this only where somebody would else touch it [m/s]."""
LAST_HEIGHT = 0.45
"""The pilot steers a landing down to here, unless the site says otherwise
(``limits.landing_height``); the last bit is the drone's own [m].
"""
SINK_LEAD = 0.33
"""The wanted height is this much below the drone [m]: it sinks at about 0.4 m/s."""
BESIDE_MAX = 1.2
"""A landing that the gate asks for is steered no farther beside its place than this [m] ..."""
BESIDE_SPEED = 0.4
"""... at this speed [m/s]."""


def sink_height(height: float, lowest: float = LAST_HEIGHT) -> float:
    """Return the height to want next while sinking from a height; the lowest to want [m]."""
    return max(lowest, height - SINK_LEAD)


def coasted(place: Vec2, velocity: Vec2, coast_time: float) -> Vec2:
    """Return where a drone comes to rest [m], by the coast time of its airframe [s]."""
    return place[0] + coast_time * velocity[0], place[1] + coast_time * velocity[1]
