"""Numbers of the MSP commands that are spoken here.

Source: betaflight/betaflight, src/main/msp/msp_protocol.h (MSP API 1.49, August 2026).
"""

from __future__ import annotations

from enum import IntEnum


class Msp(IntEnum):
    """A command, or the question that a number answers."""

    API_VERSION = 1
    FC_VARIANT = 2
    FC_VERSION = 3
    MODE_RANGES = 34
    FEATURE_CONFIG = 36
    RX_CONFIG = 44
    RX_MAP = 64
    FAILSAFE_CONFIG = 75
    RXFAIL_CONFIG = 77
    ADVANCED_CONFIG = 90
    PID_ADVANCED = 94
    STATUS = 101
    RAW_IMU = 102
    RC = 105
    ATTITUDE = 108
    ALTITUDE = 109
    ANALOG = 110
    RC_TUNING = 111
    BOXIDS = 119
    RC_DEADBAND = 125
    BATTERY_STATE = 130
    STATUS_EX = 150
    SET_RAW_RC = 200


VARIANT = b"BTFL"
"""What Betaflight answers to FC_VARIANT."""
COMMANDS_PER_SECOND = 100
"""A flight controller takes one command each time it looks at its serial ports (fc/tasks.c)."""
