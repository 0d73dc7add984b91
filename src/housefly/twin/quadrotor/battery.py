"""The flight battery: charge drains with thrust, voltage follows from charge."""

from __future__ import annotations

from bisect import bisect_right
from itertools import pairwise
from math import sqrt

from housefly.config.airframe import airframe_named
from housefly.twin.disturbance import Disturbances

_ENDURANCE = airframe_named("ardrone").battery.endurance
"""Of an AR.Drone [s] (the 3S 1000 mAh pack is rated for 12 minutes)."""
_IDLE_SHARE = 0.05
"""Share of the hovering power that the electronics draw with motors off."""
LOW_VOLTAGE = 9.7
FORCED_LANDING_VOLTAGE = 9.3
CUT_OFF_VOLTAGE = 9.0
"""Low flag, forced landing, power off [V]: paparazzi's two levels and the drone's own vbat_min."""

_CHARGE = (0.0, 0.03, 0.08, 0.2, 0.5, 1.0)
_VOLTAGE = (9.0, 9.3, 9.7, 10.9, 11.69, 12.4)
"""Ends and the 50 % point are facts; the knee in between is that of any lithium battery."""
_SLOPE = tuple(
    (v1 - v0) / (c1 - c0)
    for (c0, c1), (v0, v1) in zip(pairwise(_CHARGE), pairwise(_VOLTAGE), strict=True)
)
"""From each of those points to the next [V]."""


class Battery:
    """Charge from 0 to 1, drained by time and thrust.

    Args:
        charge: at the start.
        endurance: hovering from full to empty [s].
    """

    def __init__(self, charge: float, endurance: float = _ENDURANCE) -> None:
        self.charge, self._endurance = charge, endurance

    @property
    def voltage(self) -> float:
        """Voltage at this charge [V]."""
        knot = min(bisect_right(_CHARGE, self.charge), len(_CHARGE) - 1) - 1
        return _SLOPE[knot] * (self.charge - _CHARGE[knot]) + _VOLTAGE[knot]

    def drain(self, seconds: float, load: float) -> None:
        """Subtract what the electronics and the rotors used.

        Args:
            seconds: how long [s].
            load: thrust over weight; rotor power grows as its 3/2 power (momentum theory).
        """
        rotors = load * sqrt(load) if load > 0.0 else 0.0
        used = seconds / self._endurance * (_IDLE_SHARE + (1.0 - _IDLE_SHARE) * rotors)
        self.charge = max(0.0, self.charge - used)


class BatteryGauge:
    """What the drone's computer knows of its battery.

    Attributes:
        charge: 0 to 1, as it says.
        voltage: as it says [V].
    """

    def __init__(self, battery: Battery) -> None:
        self._battery = battery
        self.charge, self.voltage = battery.charge, battery.voltage

    def read(self, disturbances: Disturbances) -> None:
        """Measure, with the voltage lost under load; a stuck gauge says what it said last."""
        if not disturbances.battery_gauge_stuck:
            self.charge = self._battery.charge
            self.voltage = self._battery.voltage - disturbances.voltage_sag
