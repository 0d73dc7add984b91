"""The navdata options of the simulated drone, filled from its onboard state.

Native units and the native frame forward-right-down, as Parrot ARDroneLib SDK 2.0.1
(navdata_common.h) lists them. Options that the twin does not simulate keep one constant value and
are packed once.
"""

from __future__ import annotations

from dataclasses import replace
from math import cos, degrees, exp, radians, sin

from housefly.geometry import GRAVITY, Vec3
from housefly.twin.contracts import FlightState, OnboardState
from housefly.wires.ardrone.conversions import flu_from_frd, native_demo
from housefly.wires.ardrone.layout import Structure
from housefly.wires.ardrone.navdata import RawOption
from housefly.wires.ardrone.navdata_options import (
    OPTION_TYPES,
    TAGS,
    Altitude,
    Demo,
    EulerAngles,
    KalmanPressure,
    Magneto,
    MajorState,
    PhysMeasures,
    PressureRaw,
    Pwm,
    RawMeasures,
    Time,
    Vision,
    VisionDetect,
    VisionRaw,
    Wifi,
)

MAJOR_STATES: dict[FlightState, MajorState] = {
    FlightState.LANDED: MajorState.LANDED,
    FlightState.TAKING_OFF: MajorState.TAKING_OFF,
    FlightState.FLYING: MajorState.FLYING,
    FlightState.HOVERING: MajorState.HOVERING,
    FlightState.LANDING: MajorState.LANDING,
    FlightState.EMERGENCY: MajorState.DEFAULT,
}
"""The navdata control state of each firmware state."""

_HOVERING_WITHOUT_LINK = 8
"""Minor control state of hovering when commands stopped."""
_NO_TAG_DETECTION = 3
"""Default of ``detect:detect_type``: no tag is looked for."""
_MAGNETIC_FIELD = 320.0
_MAGNETIC_DIP = 350.0
"""Strength of the simulated field, horizontal and down [mG]; about that of Fukuoka."""
DEMO_OPTIONS = 1 << TAGS[Demo] | 1 << TAGS[VisionDetect]
"""Tags of the short packets as the drone comes."""
_SEA_LEVEL_PRESSURE = 101325.0
_SCALE_HEIGHT = 8434.0
"""Pressure at the floor [Pa] and the height over which it falls by e [m]."""
_ACCELEROMETER_ZERO = 2048
_ACCELEROMETER_STEP = 0.512
"""Centre of the 12-bit converter and its steps per mg (a recorded packet shows 509 per g)."""
_ULTRASOUND_MIN = 0.24
"""Nothing nearer is measured [m]: recorded drones that stand tell 0.237 to 0.243."""
_GYRO_STEP = 16.4
"""Steps per deg/s of a gyro with a range of 2000 deg/s and 16 bits."""


def demo_options(
    onboard: OnboardState, altitude: float, tells_vertical_speed: bool, wanted: int = DEMO_OPTIONS
) -> tuple[Structure | RawOption, ...]:
    """Return the options of demo mode: 500 bytes with header and checksum; altitude in m.

    What the client wants, a bit for each tag, comes with them.
    """
    if wanted & ~DEMO_OPTIONS == 0:
        return _demo(onboard, altitude, tells_vertical_speed), _CONSTANT_OPTIONS[VisionDetect]
    every = full_options(onboard, altitude, tells_vertical_speed)
    chosen = wanted | DEMO_OPTIONS
    return tuple(
        one for kind, one in zip(OPTION_TYPES, every, strict=True) if chosen >> TAGS[kind] & 1
    )


def full_options(
    onboard: OnboardState, altitude: float, tells_vertical_speed: bool
) -> tuple[Structure | RawOption, ...]:
    """Return the options of full mode: tags 0 to 26; firmware versions disagree on tag 27."""
    demo = _demo(onboard, altitude, tells_vertical_speed)
    moving: dict[type[Structure], Structure] = {
        Demo: demo,
        Time: Time.of(onboard.at),
        RawMeasures: _raw_measures(onboard),
        PhysMeasures: PhysMeasures(45.0, accelerations=_milli_g(onboard), rates=_rates(onboard)),
        EulerAngles: EulerAngles(theta=demo.theta, phi=demo.phi),
        Pwm: Pwm(motors=tuple(_clip(round(255 * duty), 0, 255) for duty in onboard.motors)),
        Altitude: _altitude(onboard, altitude),
        VisionRaw: VisionRaw(*flu_from_frd(onboard.velocity)),
        Vision: _vision(onboard, demo),
        PressureRaw: PressureRaw(
            temperature=250,
            pressure=round(_SEA_LEVEL_PRESSURE * exp(-altitude / _SCALE_HEIGHT)),
        ),
        Magneto: _magneto(demo),
        KalmanPressure: KalmanPressure(
            estimated_z=1e3 * altitude, estimated_zdot=1e3 * onboard.velocity[2]
        ),
    }
    return tuple(moving.get(kind) or _CONSTANT_OPTIONS[kind] for kind in OPTION_TYPES)


def _demo(onboard: OnboardState, altitude: float, tells_vertical_speed: bool) -> Demo:
    forward, left, up = onboard.velocity
    demo = native_demo(
        MAJOR_STATES[onboard.flight],
        min(1.0, max(0.0, onboard.battery)),
        phi=onboard.phi,
        theta=onboard.theta,
        psi=onboard.psi,
        height=altitude,
        velocity=(forward, left, up if tells_vertical_speed else 0.0),
    )
    lost = onboard.com_lost and onboard.flight is FlightState.HOVERING
    minor = _HOVERING_WITHOUT_LINK if lost else 0
    return replace(
        demo, ctrl_state=demo.ctrl_state | minor, detection_camera_type=_NO_TAG_DETECTION
    )


def _milli_g(onboard: OnboardState) -> Vec3:
    x, y, z = flu_from_frd(onboard.acceleration)
    return 1e3 * x / GRAVITY, 1e3 * y / GRAVITY, 1e3 * z / GRAVITY


def _rates(onboard: OnboardState) -> Vec3:
    x, y, z = flu_from_frd(onboard.angular_rate)
    return degrees(x), degrees(y), degrees(z)


def _raw_measures(onboard: OnboardState) -> RawMeasures:
    x, y, z = _milli_g(onboard)
    echo = _echo(onboard)
    return RawMeasures(
        accelerometers=(_converter(x), _converter(-y), _converter(-z)),
        gyros=tuple(_clip(round(_GYRO_STEP * rate), -32768, 32767) for rate in _rates(onboard)),
        battery_millivolts=round(1e3 * onboard.battery_voltage),
        us_association=_clip(echo, 0, 65535),
        echo_count=1,
        altitude_raw=echo,
    )


def _echo(onboard: OnboardState) -> int:
    """Return the raw ultrasound height [mm]; a standing drone tells its shortest one."""
    return round(1e3 * max(onboard.height, _ULTRASOUND_MIN))


def _converter(milli_g: float) -> int:
    return _clip(round(_ACCELEROMETER_ZERO + _ACCELEROMETER_STEP * milli_g), 0, 4095)


def _clip(value: int, low: int, high: int) -> int:
    return min(high, max(low, value))


def _altitude(onboard: OnboardState, altitude: float) -> Altitude:
    echo, climb = _echo(onboard), 1e3 * onboard.velocity[2]
    return Altitude(vision=echo, vz=climb, raw=echo, observer_altitude=altitude)


def _vision(onboard: OnboardState, demo: Demo) -> Vision:
    return Vision(
        theta_capture=radians(demo.theta / 1e3),
        phi_capture=radians(demo.phi / 1e3),
        psi_capture=radians(demo.psi / 1e3),
        altitude_capture=demo.altitude,
        time_capture=Time.of(onboard.at).time,
        body_velocity=(demo.vx, demo.vy, demo.vz),
    )


def _magneto(demo: Demo) -> Magneto:
    heading = demo.psi / 1e3
    field = _field(radians(heading))
    return Magneto(
        m=tuple(map(round, field)),
        raw=field,
        rectified=field,
        heading_unwrapped=heading,
        heading_gyro_unwrapped=heading,
        heading_fusion_unwrapped=heading,
        calibration_ok=1,
        radius=_MAGNETIC_FIELD,
    )


def _field(heading: float) -> Vec3:
    """Return the field in a level body [mG], forward, right, down; its tilt is left out."""
    return _MAGNETIC_FIELD * cos(heading), -_MAGNETIC_FIELD * sin(heading), _MAGNETIC_DIP


def _constant(option: Structure) -> RawOption:
    return RawOption(TAGS[type(option)], option.encode())


_CONSTANT_OPTIONS: dict[type[Structure], RawOption] = {
    kind: _constant(kind()) for kind in OPTION_TYPES
} | {Wifi: _constant(Wifi(link_quality=0x3F800000))}
"""Constant options, packed once; the Wi-Fi quality is a single 1.0 read as an integer."""
