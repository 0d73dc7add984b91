"""The navdata options, tag by tag, with their exact sizes.

Units are the drone's own (mm, mm/s, millidegrees, mg) in its own frame forward-right-down; ``signs`` turns them into ours.
Field names follow Parrot's header where that says enough. Facts: ardrone-wire, section 1.3.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

from housefly.wires.ardrone.layout import Structure, wire


class MajorState(IntEnum):
    """High half of ``Demo.ctrl_state``."""

    DEFAULT = 0
    INIT = 1
    LANDED = 2
    FLYING = 3
    HOVERING = 4
    TEST = 5
    TAKING_OFF = 6
    GOING_TO_FIX = 7
    LANDING = 8
    LOOPING = 9


class MinorFlying(IntEnum):
    """Low half of ``Demo.ctrl_state`` while flying."""

    OK = 0
    LOST_ALTITUDE = 1
    LOST_ALTITUDE_GO_DOWN = 2
    ALTITUDE_OUT_OF_ZONE = 3
    COMBINED_YAW = 4
    BRAKE = 5
    NO_VISION = 6


@dataclass(frozen=True, slots=True)
class Demo(Structure):
    """What every client needs: state, battery, attitude, height, velocity.

    theta, phi, psi in millidegrees (nose up, right side down, clockwise positive), altitude in mm, battery in percent,
    velocity forward, right, down in mm/s; a real drone leaves vz at 0.
    The ``detection`` and ``camera`` parts are deprecated fillers.
    """

    ctrl_state: int = wire("I")
    battery_percent: int = wire("I")
    theta: float = wire("f")
    phi: float = wire("f")
    psi: float = wire("f")
    altitude: int = wire("i")
    vx: float = wire("f")
    vy: float = wire("f")
    vz: float = wire("f")
    frame_index: int = wire("I")
    detection_rotation: tuple[float, ...] = wire("9f")
    detection_translation: tuple[float, ...] = wire("3f")
    detection_tag_index: int = wire("I")
    detection_camera_type: int = wire("I")
    camera_rotation: tuple[float, ...] = wire("9f")
    camera_translation: tuple[float, ...] = wire("3f")

    @property
    def major(self) -> int:
        """Major control state, a MajorState where the number is known."""
        return self.ctrl_state >> 16

    @property
    def minor(self) -> int:
        """Minor control state."""
        return self.ctrl_state & 0xFFFF


@dataclass(frozen=True, slots=True)
class Time(Structure):
    """Drone time: 11 high bits seconds, 21 low bits microseconds."""

    time: int = wire("I")

    @property
    def seconds(self) -> float:
        """The time [s]; wraps after 2048 s."""
        return (self.time >> 21) + (self.time & 0x1FFFFF) * 1e-6

    @classmethod
    def of(cls, seconds: float) -> Time:
        """Return the option for a time [s]."""
        whole, part = divmod(round(seconds * 1e6), 1_000_000)
        return cls((whole % 2048) << 21 | part)


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
    """Calibrated inertial readings: accelerations in mg, rates in deg/s, body forward-right-down."""

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
class References(Structure):
    """What the inner loops are asked for."""

    theta: int = wire("i")
    phi: int = wire("i")
    theta_integral: int = wire("i")
    phi_integral: int = wire("i")
    pitch: int = wire("i")
    roll: int = wire("i")
    yaw: int = wire("i")
    psi: int = wire("i")
    v_ref: tuple[float, ...] = wire("2f")
    theta_mod: float = wire("f")
    phi_mod: float = wire("f")
    k_v: tuple[float, ...] = wire("2f")
    k_mode: int = wire("I")
    ui: tuple[float, ...] = wire("5f")
    ui_sequence: int = wire("i")


@dataclass(frozen=True, slots=True)
class Trims(Structure):
    """Trim angles and rate."""

    rates: float = wire("f")
    theta: float = wire("f")
    phi: float = wire("f")


@dataclass(frozen=True, slots=True)
class RcReferences(Structure):
    """Sticks as the drone heard them."""

    pitch: int = wire("i")
    roll: int = wire("i")
    yaw: int = wire("i")
    gaz: int = wire("i")
    ag: int = wire("i")


@dataclass(frozen=True, slots=True)
class Pwm(Structure):
    """Motor duty cycles 0..255 and what they are made of."""

    motors: tuple[int, ...] = wire("4B")
    saturated_motors: tuple[int, ...] = wire("4B")
    gaz_feed_forward: float = wire("f")
    gaz_altitude: float = wire("f")
    altitude_integral: float = wire("f")
    vz_reference: float = wire("f")
    u_pitch: int = wire("i")
    u_roll: int = wire("i")
    u_yaw: int = wire("i")
    yaw_integral: float = wire("f")
    planned_pitch: int = wire("i")
    planned_roll: int = wire("i")
    planned_yaw: int = wire("i")
    planned_gaz: float = wire("f")
    motor_currents: tuple[int, ...] = wire("4H")
    altitude_proportional: float = wire("f")
    altitude_derivative: float = wire("f")


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
class VisionRaw(Structure):
    """Optical flow before scaling."""

    tx: float = wire("f")
    ty: float = wire("f")
    tz: float = wire("f")


@dataclass(frozen=True, slots=True)
class VisionOf(Structure):
    """Optical flow at five points."""

    dx: tuple[float, ...] = wire("5f")
    dy: tuple[float, ...] = wire("5f")


@dataclass(frozen=True, slots=True)
class Vision(Structure):
    """Vision state machine, its trims, delays and body velocity."""

    state: int = wire("I")
    misc: int = wire("i")
    phi_trim: float = wire("f")
    phi_reference_proportional: float = wire("f")
    theta_trim: float = wire("f")
    theta_reference_proportional: float = wire("f")
    new_raw_picture: int = wire("i")
    theta_capture: float = wire("f")
    phi_capture: float = wire("f")
    psi_capture: float = wire("f")
    altitude_capture: int = wire("i")
    time_capture: int = wire("I")
    body_velocity: tuple[float, ...] = wire("3f")
    delta_phi: float = wire("f")
    delta_theta: float = wire("f")
    delta_psi: float = wire("f")
    gold_defined: int = wire("I")
    gold_reset: int = wire("I")
    gold_x: float = wire("f")
    gold_y: float = wire("f")


@dataclass(frozen=True, slots=True)
class VisionPerf(Structure):
    """Times of the vision stages."""

    szo: float = wire("f")
    corners: float = wire("f")
    compute: float = wire("f")
    tracking: float = wire("f")
    translation: float = wire("f")
    update: float = wire("f")
    custom: tuple[float, ...] = wire("20f")


@dataclass(frozen=True, slots=True)
class TrackersSend(Structure):
    """State and image position of thirty trackers."""

    locked: tuple[int, ...] = wire("30i")
    points: tuple[int, ...] = wire("60i")


@dataclass(frozen=True, slots=True)
class VisionDetect(Structure):
    """Up to four detected tags; image coordinates 0..1000, distance in cm, orientation in degrees."""

    count: int = wire("I")
    types: tuple[int, ...] = wire("4I")
    x_centres: tuple[int, ...] = wire("4I")
    y_centres: tuple[int, ...] = wire("4I")
    widths: tuple[int, ...] = wire("4I")
    heights: tuple[int, ...] = wire("4I")
    distances_cm: tuple[int, ...] = wire("4I")
    orientations: tuple[float, ...] = wire("4f")
    rotations: tuple[float, ...] = wire("36f")
    translations: tuple[float, ...] = wire("12f")
    cameras: tuple[int, ...] = wire("4I")


@dataclass(frozen=True, slots=True)
class Watchdog(Structure):
    """Watchdog counter."""

    watchdog: int = wire("i")


@dataclass(frozen=True, slots=True)
class AdcDataFrame(Structure):
    """Raw bytes of the sensor board."""

    version: int = wire("I")
    data: tuple[int, ...] = wire("32B")


@dataclass(frozen=True, slots=True)
class VideoStream(Structure):
    """Encoder and TCP queue statistics."""

    quantizer: int = wire("B")
    frame_size: int = wire("I")
    frame_number: int = wire("I")
    atcmd_reference_sequence: int = wire("I")
    atcmd_mean_gap: int = wire("I")
    atcmd_variance_gap: float = wire("f")
    atcmd_reference_quality: int = wire("I")
    out_bitrate: int = wire("I")
    desired_bitrate: int = wire("I")
    data: tuple[int, ...] = wire("5i")
    tcp_queue_level: int = wire("I")
    fifo_queue_level: int = wire("I")


@dataclass(frozen=True, slots=True)
class Games(Structure):
    """Game counters."""

    double_taps: int = wire("I")
    finish_lines: int = wire("I")


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


@dataclass(frozen=True, slots=True)
class HdVideoStream(Structure):
    """Recording and live fifo statistics."""

    state: int = wire("I")
    storage_fifo_packets: int = wire("I")
    storage_fifo_size: int = wire("I")
    usbkey_size: int = wire("I")
    usbkey_free: int = wire("I")
    frame_number: int = wire("I")
    usbkey_remaining_time: int = wire("I")


@dataclass(frozen=True, slots=True)
class Wifi(Structure):
    """Wi-Fi link quality."""

    link_quality: int = wire("I")


OPTIONS: tuple[type[Structure], ...] = (
    Demo,
    Time,
    RawMeasures,
    PhysMeasures,
    GyrosOffsets,
    EulerAngles,
    References,
    Trims,
    RcReferences,
    Pwm,
    Altitude,
    VisionRaw,
    VisionOf,
    Vision,
    VisionPerf,
    TrackersSend,
    VisionDetect,
    Watchdog,
    AdcDataFrame,
    VideoStream,
    Games,
    PressureRaw,
    Magneto,
    WindSpeed,
    KalmanPressure,
    HdVideoStream,
    Wifi,
)
"""All known options; the index is the tag."""

TAGS: dict[type[Structure], int] = {option: tag for tag, option in enumerate(OPTIONS)}

TAG_27_SIZES = (12, 216)
"""Tag 27 with its header: an engineering option in old firmware, GPS from firmware 2.4 on; we only carry its bytes."""
