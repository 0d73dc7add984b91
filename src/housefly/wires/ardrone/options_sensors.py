"""Navdata options of sensors and of the estimates made from them.

Units are the drone's own (mm, mm/s, millidegrees, mg) in its own frame forward-right-down;
``conversions`` turns them into ours. Field names follow Parrot's header where that says enough.
Facts: Parrot ARDroneLib SDK 2.0.1, navdata_common.h.
"""

from __future__ import annotations

from dataclasses import dataclass

from housefly.wires.ardrone.layout import Structure, wire


@dataclass(frozen=True, slots=True)
class RawMeasures(Structure):
    """Sensor readings in their own steps; battery in mV, altitude_raw in mm."""

    accelerometers: tuple[int, ...] = wire("3H")
    gyros: tuple[int, ...] = wire("3h")
    gyros_110: tuple[int, ...] = wire("2h")
    battery_millivolts: int = wire("I")
    us_echo_start: int = wire("H")
    us_echo_end: int = wire("H")
    us_association: int = wire("H")
    us_distance: int = wire("H")
    us_curve_time: int = wire("H")
    us_curve_value: int = wire("H")
    us_curve_reference: int = wire("H")
    echo_flag: int = wire("H")
    echo_count: int = wire("H")
    echo_sum: int = wire("I")
    altitude_raw: int = wire("i")
    gradient: int = wire("h")


@dataclass(frozen=True, slots=True)
class PhysMeasures(Structure):
    """Calibrated inertial readings: accelerations in mg, rates in deg/s, forward-right-down."""

    accelerometer_temperature: float = wire("f")
    gyro_temperature: int = wire("H")
    accelerations: tuple[float, ...] = wire("3f")
    rates: tuple[float, ...] = wire("3f")
    supply_3v3: int = wire("I")
    reference_epson: int = wire("I")
    reference_idg: int = wire("I")


@dataclass(frozen=True, slots=True)
class GyrosOffsets(Structure):
    """Gyro offsets."""

    offsets: tuple[float, ...] = wire("3f")


@dataclass(frozen=True, slots=True)
class EulerAngles(Structure):
    """Attitude from the accelerometers."""

    theta: float = wire("f")
    phi: float = wire("f")


@dataclass(frozen=True, slots=True)
class Altitude(Structure):
    """Altitude estimator; altitudes in mm, vz in mm/s."""

    vision: int = wire("i")
    vz: float = wire("f")
    reference: int = wire("i")
    raw: int = wire("i")
    observer_acceleration: float = wire("f")
    observer_altitude: float = wire("f")
    observer_x: tuple[float, ...] = wire("3f")
    observer_state: int = wire("I")
    estimated_vb: tuple[float, ...] = wire("2f")
    estimated_state: int = wire("I")


@dataclass(frozen=True, slots=True)
class AdcDataFrame(Structure):
    """Raw bytes of the sensor board."""

    version: int = wire("I")
    data: tuple[int, ...] = wire("32B")


@dataclass(frozen=True, slots=True)
class PressureRaw(Structure):
    """Barometer: temperature in 0.1 deg C, pressure in Pa."""

    up: int = wire("i")
    ut: int = wire("h")
    temperature: int = wire("i")
    pressure: int = wire("i")


@dataclass(frozen=True, slots=True)
class Magneto(Structure):
    """Magnetometer in mG, headings in degrees."""

    m: tuple[int, ...] = wire("3h")
    raw: tuple[float, ...] = wire("3f")
    rectified: tuple[float, ...] = wire("3f")
    offset: tuple[float, ...] = wire("3f")
    heading_unwrapped: float = wire("f")
    heading_gyro_unwrapped: float = wire("f")
    heading_fusion_unwrapped: float = wire("f")
    calibration_ok: int = wire("B")
    state: int = wire("I")
    radius: float = wire("f")
    error_mean: float = wire("f")
    error_variance: float = wire("f")


@dataclass(frozen=True, slots=True)
class WindSpeed(Structure):
    """Wind estimate."""

    speed: float = wire("f")
    angle: float = wire("f")
    compensation_theta: float = wire("f")
    compensation_phi: float = wire("f")
    state: tuple[float, ...] = wire("6f")
    debug: tuple[float, ...] = wire("3f")


@dataclass(frozen=True, slots=True)
class KalmanPressure(Structure):
    """Altitude from the barometer."""

    offset: float = wire("f")
    estimated_z: float = wire("f")
    estimated_zdot: float = wire("f")
    estimated_bias_pwm: float = wire("f")
    estimated_bias_pressure: float = wire("f")
    offset_us: float = wire("f")
    prediction_us: float = wire("f")
    covariance_alt: float = wire("f")
    covariance_pwm: float = wire("f")
    covariance_velocity: float = wire("f")
    ground_effect: int = wire("I")
    innovation_sum: float = wire("f")
    reject_us: int = wire("I")
    multisinus: float = wire("f")
    gaz_altitude: float = wire("f")
    multisinus_on: int = wire("I")
    multisinus_start: int = wire("I")
