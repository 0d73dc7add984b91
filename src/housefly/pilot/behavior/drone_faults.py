"""Which complaints of the drone end a flight and forbid the next one."""

from __future__ import annotations

from collections.abc import Iterable

from housefly.messages.sensing import DroneFault
from housefly.messages.words import Words, joined, said

LANDING_FAULTS = frozenset(
    {
        DroneFault.MOTORS_PROBLEM,
        DroneFault.SOFTWARE_FAULT,
        DroneFault.MOTORS_CUT_OUT,
        DroneFault.BATTERY_LOW,
        DroneFault.TILTED_TOO_FAR,
        DroneFault.SENSOR_BOARD_SILENT,
        DroneFault.FLIGHT_TIMER_ELAPSED,
        DroneFault.WIND,
    }
)
"""The drone is landed at once."""
GROUNDING_FAULTS = LANDING_FAULTS | {DroneFault.ULTRASOUND_DEAF}
"""No take-off with one of these: who is deaf does not know its height."""


def fault_list(faults: Iterable[DroneFault]) -> Words:
    """Return complaints of the drone in words, UNSAID for none."""
    return joined(", ", map(said, faults))
