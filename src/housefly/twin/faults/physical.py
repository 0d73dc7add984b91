"""Faults that act on the drone's body: air, load, motors, battery, its own sensors."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Protocol

from housefly.twin.contracts import GroundTruth
from housefly.twin.disturbance import (
    NEUTRAL,
    CeilingFan,
    Disturbances,
    Motor,
    Payload,
    PropellerDamage,
    SensorCondition,
    Tether,
)
from housefly.twin.faults.fault import Fault
from housefly.twin.faults.vocabulary import FaultComponent, FaultKind

Disturb = Callable[[Disturbances, Fault, GroundTruth], Disturbances]
"""What disturbs so far, a fault, the true state when it began: what disturbs with it."""


class TrueDrone(Protocol):
    """What knows where a drone is."""

    def truth(self) -> GroundTruth:
        """Return the true state now."""
        ...


class PhysicalFaults:
    """Turns the faults that are active into disturbances."""

    def __init__(self) -> None:
        self._active: tuple[Fault, ...] = ()
        self._began: dict[Fault, GroundTruth] = {}

    def changed(self, active: tuple[Fault, ...], drone: TrueDrone) -> Disturbances | None:
        """Return what disturbs from now on; None when that is what disturbed before."""
        physical = tuple(fault for fault in active if disturb_of(fault))
        if physical == self._active:
            return None
        disturbances, self._active = NEUTRAL, physical
        for fault in physical:
            disturb = disturb_of(fault)
            if disturb is not None:
                began = self._began.setdefault(fault, drone.truth())
                disturbances = disturb(disturbances, fault, began)
        return disturbances


def disturb_of(fault: Fault) -> Disturb | None:
    """Return how a fault disturbs; None for one that is not physical."""
    return _DISTURB.get((fault.component, fault.kind, fault.aspect))


def _wind(so_far: Disturbances, x: float, y: float) -> Disturbances:
    wx, wy, wz = so_far.wind
    return replace(so_far, wind=(wx + x, wy + y, wz))


def _wind_from_somewhere(so_far: Disturbances, fault: Fault, truth: GroundTruth) -> Disturbances:
    x, y = fault.direction()
    return _wind(so_far, fault.size * x, fault.size * y)


def _discharged(so_far: Disturbances, fault: Fault, truth: GroundTruth) -> Disturbances:
    return replace(so_far, charge=fault.size)


def _fan(so_far: Disturbances, fault: Fault, truth: GroundTruth) -> Disturbances:
    return replace(so_far, fan=CeilingFan(truth.pose.position[:2], downwash=fault.size))


def _tether(so_far: Disturbances, fault: Fault, truth: GroundTruth) -> Disturbances:
    x, y, _ = truth.pose.position
    return replace(so_far, tether=Tether((x, y, 0.0), fault.size))


def _weak(motor: Motor) -> Disturb:
    def disturb(so_far: Disturbances, fault: Fault, truth: GroundTruth) -> Disturbances:
        left = 0.0 if fault.kind is FaultKind.OFF else fault.size
        a, b, c, d = (
            gain * (left if number == motor.value else 1.0)
            for number, gain in enumerate(so_far.motor_thrust)
        )
        return replace(so_far, motor_thrust=(a, b, c, d))

    return disturb


def _all_weak(so_far: Disturbances, fault: Fault, truth: GroundTruth) -> Disturbances:
    a, b, c, d = so_far.motor_thrust
    left = fault.size
    return replace(so_far, motor_thrust=(left * a, left * b, left * c, left * d))


def _sensor(**values: SensorCondition) -> Disturb:
    return lambda so_far, fault, truth: replace(
        so_far,
        sensors=replace(so_far.sensors, **values),  # type: ignore[arg-type]
    )


def _sensor_size(key: str) -> Disturb:
    return lambda so_far, fault, truth: replace(
        so_far,
        sensors=replace(so_far.sensors, **{key: fault.size}),  # type: ignore[arg-type]
    )


def _sensor_pair(key: str, x: float, y: float) -> Disturb:
    """Return a fault of two axes; its size counts along the unit vector (x, y)."""
    return lambda so_far, fault, truth: replace(
        so_far,
        sensors=replace(so_far.sensors, **{key: (fault.size * x, fault.size * y)}),  # type: ignore[arg-type]
    )


_C, _K = FaultComponent, FaultKind
_DISTURB: dict[tuple[FaultComponent, FaultKind, str], Disturb] = {
    (_C.WIND, _K.WRONG, ""): _wind_from_somewhere,
    (_C.WIND, _K.WRONG, "x"): lambda so_far, fault, truth: _wind(so_far, fault.size, 0.0),
    (_C.WIND, _K.WRONG, "y"): lambda so_far, fault, truth: _wind(so_far, 0.0, fault.size),
    (_C.WIND, _K.WRONG, "gust"): lambda so_far, fault, truth: replace(so_far, gust=fault.size),
    (_C.FAN, _K.WRONG, ""): _fan,
    (_C.PAYLOAD, _K.WRONG, ""): lambda so_far, fault, truth: replace(
        so_far, payload=Payload(fault.size)
    ),
    (_C.TETHER, _K.WRONG, ""): _tether,
    (_C.BATTERY, _K.WRONG, ""): _discharged,
    (_C.BATTERY, _K.WRONG, "voltage"): lambda so_far, fault, truth: replace(
        so_far, voltage_sag=fault.size
    ),
    (_C.BATTERY, _K.STUCK, ""): lambda so_far, fault, truth: replace(
        so_far, battery_gauge_stuck=True
    ),
    **{(_C.MOTOR, _K.WRONG, motor.name.lower()): _weak(motor) for motor in Motor},
    **{(_C.MOTOR, _K.OFF, motor.name.lower()): _weak(motor) for motor in Motor},
    (_C.MOTOR, _K.WRONG, "all"): _all_weak,
    (_C.MOTOR, _K.WRONG, "propeller"): lambda so_far, fault, truth: replace(
        so_far, propeller_damage=PropellerDamage(Motor.FRONT_LEFT, fault.size)
    ),
    (_C.SONAR, _K.OFF, ""): _sensor(sonar=SensorCondition.OFF),
    (_C.SONAR, _K.STUCK, ""): _sensor(sonar=SensorCondition.STUCK),
    (_C.FLOW, _K.OFF, ""): _sensor(flow=SensorCondition.OFF),
    (_C.FLOW, _K.STUCK, ""): _sensor(flow=SensorCondition.STUCK),
    (_C.FLOW, _K.WRONG, "gain"): _sensor_size("flow_gain"),
    (_C.FLOW, _K.WRONG, "bias"): _sensor_pair("flow_bias", 1.0, 0.0),
    (_C.FLOW, _K.WRONG, "bias_left"): _sensor_pair("flow_bias", 0.0, 1.0),
    (_C.FLOW, _K.GARBAGE, ""): _sensor_size("flow_noise"),
    (_C.SONAR, _K.WRONG, ""): _sensor_size("sonar_bias"),
    (_C.SONAR, _K.GARBAGE, ""): _sensor_size("sonar_noise"),
    (_C.IMU, _K.WRONG, ""): _sensor_pair("tilt_bias", 0.0, 1.0),
    (_C.IMU, _K.STUCK, ""): _sensor(attitude=SensorCondition.STUCK),
    (_C.IMU, _K.GARBAGE, "gyro"): _sensor_size("gyro_noise"),
    (_C.IMU, _K.GARBAGE, "acceleration"): _sensor_size("acceleration_noise"),
}
