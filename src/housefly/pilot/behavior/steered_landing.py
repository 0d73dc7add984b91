"""How low the pilot steers a landing, and how it sinks; the last bit is the drone's own landing."""

from __future__ import annotations

LAST_HEIGHT = 0.45
"""From here the drone lands by itself [m]."""
SINK_LEAD = 0.33
"""The wanted height is this much below the drone [m]: it sinks at about 0.4 m/s."""


def sink_height(height: float) -> float:
    """Return the height to want next while sinking from a height [m]."""
    return max(LAST_HEIGHT, height - SINK_LEAD)
