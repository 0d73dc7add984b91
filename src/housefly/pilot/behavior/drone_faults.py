"""Which complaints of the drone end a flight and forbid the next one."""

from __future__ import annotations

LANDING_FAULTS = frozenset(
    {
        "motors problem",
        "software fault",
        "motors cut out",
        "battery low",
        "tilted too far",
        "sensor board silent",
        "flight timer elapsed",
        "too much wind",
    }
)
"""The drone is landed at once."""
DEAF_SONAR = "ultrasound deaf"
"""The complaint of a drone that does not know its height."""
GROUNDING_FAULTS = LANDING_FAULTS | {DEAF_SONAR}
"""No take-off with one of these."""
