"""The simulated drone under disturbances; without any, sensors and motors are left alone."""

from __future__ import annotations

from housefly.config.site import Site
from housefly.twin.disturbance import NEUTRAL, Disturbances
from housefly.twin.drone_body import DroneBody
from housefly.twin.external_forces import ExternalForce, ExternalForces
from housefly.twin.quadrotor.battery import CUT_OFF_VOLTAGE, Battery
from housefly.twin.quadrotor.motors import achieved_wrench
from housefly.twin.quadrotor.sensor_faults import FaultySensors
from housefly.twin.simulated_body import MOTORS_OFF, BodyState, SensorReading, Wrench

_STRONG = (1.0, 1.0, 1.0, 1.0)


class DisturbedDrone:
    """Stands between sensors and firmware, and between firmware and physics.

    Args:
        site: seed, and the drag of the drone.
        body: what is pushed and loaded.
        battery: what a new charge is given to.
    """

    def __init__(self, site: Site, body: DroneBody, battery: Battery) -> None:
        self._body, self._battery = body, battery
        self._sensors = FaultySensors(site.twin.seed)
        self._forces = ExternalForces(
            site.twin.seed, site.drone.drag, site.drone.airframe.body.mass
        )
        self._by = NEUTRAL
        self._pushes: ExternalForce | None = None

    @property
    def by(self) -> Disturbances:
        """What disturbs it; setting it counts from the next control period on."""
        return self._by

    @by.setter
    def by(self, disturbances: Disturbances) -> None:
        if disturbances.payload != self._by.payload:
            self._body.load(disturbances.payload)
        if disturbances.charge is not None and disturbances.charge != self._by.charge:
            self._battery.charge = disturbances.charge
        self._by = NEUTRAL if disturbances == NEUTRAL else disturbances

    def sense(self, reading: SensorReading, motors_turn: bool) -> SensorReading:
        """Return what the firmware reads of what healthy sensors read."""
        if self._by is NEUTRAL:
            return reading
        return self._sensors.read(reading, self._by, motors_turn)

    def push(self, wrench: Wrench, state: BodyState) -> None:
        """Push the drone for the next control period by what the firmware asks of its motors."""
        by = self._by
        if by is NEUTRAL:
            self._pushes = None
            self._body.push(wrench, state)
            return
        self._pushes = self._forces.step(by, state)
        self._body.push(self._achieved(wrench), state, self._pushes)

    def push_again(self, wrench: Wrench, state: BodyState) -> None:
        """Push the drone anew within the control period; what else pushes it goes on."""
        achieved = wrench if self._by is NEUTRAL else self._achieved(wrench)
        self._body.lift(achieved, state, self._pushes)

    def _achieved(self, wrench: Wrench) -> Wrench:
        """Return what the motors make of a wrench."""
        by, voltage = self._by, self._battery.voltage
        if by.battery_gauge_stuck and voltage <= CUT_OFF_VOLTAGE:
            return MOTORS_OFF
        if by.motor_gains == _STRONG and by.voltage_sag == 0.0:
            return wrench
        return achieved_wrench(
            wrench, by.motor_gains, max(0.0, 1.0 - by.voltage_sag / voltage), self._body.mechanics
        )
