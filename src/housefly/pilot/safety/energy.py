"""What charge and clock still allow: the way home decides, with the drain that was measured."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, isfinite, nan

from housefly.config.limits import LimitsConfig
from housefly.pilot.behavior.way_home import LANDING_TIME, charge_for
from housefly.pilot.safety.inputs import GateInputs
from housefly.pilot.safety.timers import Stopwatch, Window

DRAIN_KNOWN_AFTER, DRAIN_KNOWN_SHARE = 30.0, 0.03
"""The drain is measured once a flight took this long [s] and cost this share of the charge."""
DRAIN_MARGIN = 1.2
"""The measured drain is taken this many times."""
GAUGE_STILL_TIME = 60.0
"""A gauge that does not change for so long in the air is stuck [s]."""
CLIFF_SPAN = 3.0
"""A charge that falls is compared with that of so long ago [s]."""


@dataclass(frozen=True, slots=True)
class EnergyBudget:
    """What charge and clock allow; charges from 0 to 1.

    Attributes:
        airborne_for: how long the drone has been in the air [s].
        time_left: how long it may still fly by the clock alone, on the charge at take-off [s].
        time_needed: to come home from here and land [s].
        charge_needed: to come home from here and land above the floor.
        charge_lost: in the last ``CLIFF_SPAN``.
        gauge_still_for: how long the charge has not changed in the air [s].
        gauge_stuck: it stood still too long in the air, and has shown no other charge since.
    """

    airborne_for: float
    time_left: float
    time_needed: float
    charge_needed: float
    charge_lost: float
    gauge_still_for: float
    gauge_stuck: bool = False


NO_ENERGY = EnergyBudget(0.0, inf, 0.0, 0.0, 0.0, 0.0)


class EnergyMonitor:
    """Watches the charge of one flight."""

    def __init__(self, limits: LimitsConfig) -> None:
        self._limits = limits
        self._airborne = Stopwatch()
        self._gauge_still = Stopwatch()
        self._recent_charges: Window[float] = Window(CLIFF_SPAN)
        self._charge_at_take_off = nan
        self._charge = nan
        self._stuck_charge = nan

    def observe(self, inputs: GateInputs) -> EnergyBudget:
        """Take one step in."""
        now, charge = inputs.now, inputs.battery
        airborne_for = self._airborne.update(inputs.airborne, now)
        if not inputs.airborne:
            self._recent_charges.clear()
        is_higher = not charge <= self._charge_at_take_off
        if isfinite(charge) and (is_higher or not inputs.airborne):
            self._charge_at_take_off = charge
        if isfinite(charge):
            self._recent_charges.add_or_renew(now, charge)
        still = inputs.airborne and charge == self._charge
        self._charge = charge
        still_for = self._gauge_still.update(still, now)
        if still_for >= GAUGE_STILL_TIME:
            self._stuck_charge = charge
        elif isfinite(charge) and charge != self._stuck_charge:
            self._stuck_charge = nan
        return EnergyBudget(
            airborne_for=airborne_for,
            time_left=self._endurance() - airborne_for,
            time_needed=inputs.home_time + LANDING_TIME,
            charge_needed=charge_for(inputs.home_time, self._drain(airborne_for), self._limits),
            charge_lost=max([0.0, *self._recent_charges.values(now)]) - charge
            if isfinite(charge)
            else 0.0,
            gauge_still_for=still_for,
            gauge_stuck=isfinite(self._stuck_charge),
        )

    def _endurance(self) -> float:
        """Return how long the charge at take-off lasts [s]; infinite where it is unknown."""
        if not isfinite(self._charge_at_take_off):
            return inf
        usable = max(0.0, self._charge_at_take_off - self._limits.battery_floor)
        return usable * self._limits.flight_time

    def _drain(self, airborne_for: float) -> float:
        """Return the drain to count on [1/s]: that of the limits, or a greater measured one."""
        expected = 1.0 / self._limits.flight_time
        used = self._charge_at_take_off - self._charge
        if airborne_for < DRAIN_KNOWN_AFTER or not used >= DRAIN_KNOWN_SHARE:
            return expected
        return max(expected, DRAIN_MARGIN * used / airborne_for)
