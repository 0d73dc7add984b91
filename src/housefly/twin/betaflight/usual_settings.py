"""How the simulated controller is set when it is switched on: as docs/drones/betaflight.md asks."""

from __future__ import annotations

from housefly.wires.betaflight.settings import (
    FEATURE_RX_MSP,
    Box,
    FailsafeProcedure,
    FailsafeSettings,
    FcSettings,
    ModeRange,
    SilentChannel,
)
from housefly.wires.betaflight.sticks import throttle_position

BOXES = (
    *(Box.ARM, Box.ANGLE, Box.HORIZON, Box.ALT_HOLD, Box.HEADFREE, Box.FAILSAFE, Box.CRASH_FLIP),
    *(Box.PREARM, Box.PARALYZE, Box.MSP_OVERRIDE),
)
"""Modes that it knows, in the order of its state."""
SINKING_THRUST = 0.97
"""Thrust over weight of an automatic landing: it ends at about 1 m/s."""
LANDING_TIME = 6.0
_HIGH = 1700, 2100


def usual_settings(hover: float) -> FcSettings:
    """Return the settings.

    Args:
        hover: share of full thrust that carries it.
    """
    usual = FcSettings(
        boxes=BOXES,
        ranges=(
            ModeRange(Box.ARM, 0, *_HIGH),
            ModeRange(Box.ANGLE, 1, *_HIGH),
            ModeRange(Box.MSP_OVERRIDE, 2, *_HIGH),
        ),
        features=FEATURE_RX_MSP,
    )
    idle = usual.motor_idle
    throttle = ((SINKING_THRUST * hover) ** 0.5 - idle) / (1.0 - idle)
    silent = list(usual.silent)
    silent[3] = (SilentChannel.HOLD, usual.middle)
    return FcSettings(
        boxes=usual.boxes,
        ranges=usual.ranges,
        features=usual.features,
        silent=tuple(silent),
        failsafe=FailsafeSettings(
            landing_time=LANDING_TIME,
            throttle=throttle_position(throttle, usual),
            procedure=FailsafeProcedure.AUTO_LAND,
        ),
    )
