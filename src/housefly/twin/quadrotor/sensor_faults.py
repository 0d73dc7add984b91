"""What faults make of the readings of the drone's own sensors."""

from __future__ import annotations

import numpy as np

from housefly.geometry import Vec3
from housefly.twin.disturbance import Disturbances, SensorCondition, SensorFaults
from housefly.twin.simulated_body import SensorReading

_SEED_KEY = 7753
"""Keeps this noise apart from all other noise of the same seed."""
_SHAKE = 0.05
"""Gyro noise [rad/s] per acceleration noise [m/s^2] of a damaged propeller."""
_ATTITUDE = ("phi", "theta", "psi")
_FLOW = ("forward", "left")


class FaultySensors:
    """Keeps what stuck sensors last said; draws noise only while there is any."""

    def __init__(self, seed: int) -> None:
        self._random = np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(_SEED_KEY,)))
        self._stuck: dict[str, float] = {}

    def read(
        self, reading: SensorReading, disturbances: Disturbances, motors_turn: bool
    ) -> SensorReading:
        """Return what the firmware reads instead.

        Args:
            reading: of sensors without fault.
            disturbances: what is wrong with them.
            motors_turn: whether a damaged propeller shakes.
        """
        faults = disturbances.sensors
        reading = self._noisy(self._shaken(reading, disturbances, motors_turn), faults)
        roll, pitch = faults.tilt_bias
        reading = reading._replace(phi=reading.phi + roll, theta=reading.theta + pitch)
        if faults.flow is not SensorCondition.STUCK:
            reading = _flow(reading, faults)
        stuck = {
            **dict.fromkeys(_ATTITUDE, faults.attitude is SensorCondition.STUCK),
            **dict.fromkeys(_FLOW, faults.flow is SensorCondition.STUCK),
            "height": faults.sonar is not SensorCondition.OK,
        }
        values: dict[str, float] = reading._asdict()
        self._stuck = {
            name: self._stuck.get(name, values[name]) for name, holds in stuck.items() if holds
        }
        return reading._replace(**self._stuck)  # type: ignore[arg-type]

    def _shaken(
        self, reading: SensorReading, disturbances: Disturbances, motors_turn: bool
    ) -> SensorReading:
        damage, faults = disturbances.propeller_damage, disturbances.sensors
        shaking = damage.vibration if damage is not None and motors_turn else 0.0
        rate = faults.gyro_noise + _SHAKE * shaking
        acceleration = faults.acceleration_noise + shaking
        if rate <= 0.0 and acceleration <= 0.0:
            return reading
        return reading._replace(
            rate=self._blurred(reading.rate, rate),
            acceleration=self._blurred(reading.acceleration, acceleration),
        )

    def _noisy(self, reading: SensorReading, faults: SensorFaults) -> SensorReading:
        """Return the reading with the noise of flow and sonar, and the sonar's bias."""
        if faults.flow_noise > 0.0:
            forward, left, _ = self._blurred(
                (reading.forward, reading.left, 0.0), faults.flow_noise
            )
            reading = reading._replace(forward=forward, left=left)
        if faults.sonar_noise <= 0.0 and faults.sonar_bias == 0.0:
            return reading
        blur, _, _ = self._blurred((0.0, 0.0, 0.0), faults.sonar_noise)
        return reading._replace(height=max(0.0, reading.height + faults.sonar_bias + blur))

    def _blurred(self, value: Vec3, sigma: float) -> Vec3:
        x, y, z = (np.array(value) + sigma * self._random.standard_normal(3)).tolist()
        return x, y, z


def _flow(reading: SensorReading, faults: SensorFaults) -> SensorReading:
    """Return the reading with the speeds that optical flow says."""
    if faults.flow is SensorCondition.OFF:
        return reading._replace(forward=0.0, left=0.0)
    (bias_forward, bias_left), gain = faults.flow_bias, faults.flow_gain
    return reading._replace(
        forward=gain * reading.forward + bias_forward, left=gain * reading.left + bias_left
    )
