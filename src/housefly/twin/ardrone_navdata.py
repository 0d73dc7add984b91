"""Navdata of the simulated drone: state bits and options made from what its firmware believes.

Native units and the native frame forward-right-down, as ardrone-wire 1.3 lists them. Options that the twin does not simulate
keep one constant value and are packed once.
"""

from __future__ import annotations

from dataclasses import replace
from math import degrees, exp

from housefly.geometry import GRAVITY, Vec3
from housefly.twin.ardrone_link import Link
from housefly.twin.contracts import Flight, Onboard
from housefly.wires.ardrone.layout import Structure
from housefly.wires.ardrone.navdata import DroneState, RawOption, encode_navdata
from housefly.wires.ardrone.navdata_options import (
    OPTIONS,
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
from housefly.wires.ardrone.signs import flu_from_frd, native_demo

MAJOR: dict[Flight, MajorState] = {
    Flight.LANDED: MajorState.LANDED,
    Flight.TAKING_OFF: MajorState.TAKING_OFF,
    Flight.FLYING: MajorState.FLYING,
    Flight.HOVERING: MajorState.HOVERING,
    Flight.LANDING: MajorState.LANDING,
    Flight.EMERGENCY: MajorState.DEFAULT,
}
"""Control state that navdata tells for each state of the firmware."""

HOVERING_WITHOUT_LINK = 8
"""Minor control state of hovering when commands stopped."""

NO_DETECTION = 3
"""Default of ``detect:detect_type``: no tag is looked for."""

ALWAYS = (
    DroneState.ALTITUDE_CONTROL
    | DroneState.CAMERA_READY
    | DroneState.PIC_VERSION_OK
    | DroneState.AT_THREAD
    | DroneState.NAVDATA_THREAD
    | DroneState.VIDEO_THREAD
    | DroneState.ACQUISITION_THREAD
)
"""Bits set in every recorded packet, landed or flying."""

AIRBORNE = frozenset({Flight.TAKING_OFF, Flight.FLYING, Flight.HOVERING, Flight.LANDING})

MAGNETIC_FIELD = 320.0
"""Horizontal strength of the simulated field [mG]; about that of Fukuoka."""
SEA_LEVEL = 101325.0
SCALE_HEIGHT = 8434.0
"""Pressure at the floor [Pa] and the height over which it falls by e [m]."""
ACCELEROMETER_ZERO = 2048
ACCELEROMETER_STEP = 0.512
"""Centre of the 12-bit converter, and its steps per mg; the recorded packet shows 509 steps per g."""
GYRO_STEP = 16.4
"""Steps per deg/s of a gyro with a range of 2000 deg/s and 16 bits."""


def state_bits(onboard: Onboard, link: Link, demo: bool) -> int:
    """Return the 32 state bits of the header; ``demo`` tells the chosen kind of navdata."""
    flying = onboard.flight in AIRBORNE
    conditions = (
        (flying, DroneState.FLYING | DroneState.VISION | DroneState.USER_START),
        (link.acknowledged, DroneState.COMMAND_ACK),
        (demo and not link.bootstrap, DroneState.NAVDATA_DEMO),
        (link.bootstrap, DroneState.NAVDATA_BOOTSTRAP),
        (onboard.motors_problem, DroneState.MOTORS_PROBLEM),
        (onboard.com_lost, DroneState.COM_LOST),
        (onboard.low_battery, DroneState.BATTERY_LOW),
        (onboard.angles_out_of_range, DroneState.ANGLES_OUT_OF_RANGE),
        (onboard.com_watchdog, DroneState.COM_WATCHDOG),
        (onboard.flight is Flight.EMERGENCY, DroneState.EMERGENCY),
    )
    bits = int(ALWAYS)
    for holds, flag in conditions:
        if holds:
            bits |= flag.value
    return bits


def demo_option(onboard: Onboard, tells_vertical_speed: bool) -> Demo:
    """Return the option that every client reads.

    Args:
        onboard: what the firmware believes.
        tells_vertical_speed: a real drone leaves vz at 0; True makes the twin better than that.
    """
    forward, left, up = onboard.velocity
    demo = native_demo(
        MAJOR[onboard.flight],
        min(1.0, max(0.0, onboard.battery)),
        phi=onboard.phi,
        theta=onboard.theta,
        psi=onboard.psi,
        height=onboard.height,
        velocity=(forward, left, up if tells_vertical_speed else 0.0),
    )
    lost = onboard.com_lost and onboard.flight is Flight.HOVERING
    minor = HOVERING_WITHOUT_LINK if lost else 0
    return replace(demo, ctrl_state=demo.ctrl_state | minor, detection_camera_type=NO_DETECTION)


def demo_options(onboard: Onboard, tells_vertical_speed: bool) -> tuple[Structure | RawOption, ...]:
    """Return the options of demo mode: 500 bytes with header and checksum."""
    return demo_option(onboard, tells_vertical_speed), CONSTANT[VisionDetect]


def full_options(onboard: Onboard, tells_vertical_speed: bool) -> tuple[Structure | RawOption, ...]:
    """Return the options of full mode: tags 0 to 26, without the 27 on which the firmwares disagree."""
    moving: dict[type[Structure], Structure] = {
        Demo: demo_option(onboard, tells_vertical_speed),
        Time: Time.of(onboard.at),
        RawMeasures: _raw_measures(onboard),
        PhysMeasures: _phys_measures(onboard),
        EulerAngles: EulerAngles(theta=-1e3 * degrees(onboard.theta), phi=1e3 * degrees(onboard.phi)),
        Pwm: Pwm(motors=tuple(round(255 * min(1.0, max(0.0, duty))) for duty in onboard.motors)),
        Altitude: _altitude(onboard),
        VisionRaw: _vision_raw(onboard),
        Vision: _vision(onboard),
        PressureRaw: _pressure(onboard),
        Magneto: _magneto(onboard),
        KalmanPressure: KalmanPressure(estimated_z=1e3 * onboard.height, estimated_zdot=1e3 * onboard.velocity[2]),
    }
    return tuple(moving.get(kind) or CONSTANT[kind] for kind in OPTIONS)


class NavdataWriter:
    """Numbers the packets and writes the kind that the client chose.

    Attributes:
        demo: True for the short packets; ``general:navdata_demo``.
    """

    def __init__(self, link: Link, tells_vertical_speed: bool) -> None:
        self.demo = False
        self._link = link
        self._tells_vertical_speed = tells_vertical_speed
        self._sequence = 0

    @property
    def full(self) -> bool:
        """Whether the next packet is a full one."""
        return not (self.demo or self._link.bootstrap)

    def packet(self, onboard: Onboard) -> bytes:
        """Return the next packet: bootstrap, demo or full."""
        self._sequence = self._sequence % 0xFFFFFFFF + 1
        return encode_navdata(state_bits(onboard, self._link, self.demo), self._sequence, self._options(onboard))

    def _options(self, onboard: Onboard) -> tuple[Structure | RawOption, ...]:
        if self._link.bootstrap:
            return ()
        return (demo_options if self.demo else full_options)(onboard, self._tells_vertical_speed)


def _milli_g(onboard: Onboard) -> Vec3:
    x, y, z = flu_from_frd(onboard.acceleration)
    return 1e3 * x / GRAVITY, 1e3 * y / GRAVITY, 1e3 * z / GRAVITY


def _rates(onboard: Onboard) -> Vec3:
    x, y, z = flu_from_frd(onboard.angular_rate)
    return degrees(x), degrees(y), degrees(z)


def _raw_measures(onboard: Onboard) -> RawMeasures:
    x, y, z = _milli_g(onboard)
    height = round(1e3 * max(0.0, onboard.height))
    return RawMeasures(
        accelerometers=(_converter(x), _converter(-y), _converter(-z)),
        gyros=tuple(_clip(round(GYRO_STEP * rate), -32768, 32767) for rate in _rates(onboard)),
        battery_millivolts=round(1e3 * onboard.battery_voltage),
        us_association=_clip(height, 0, 65535),
        echo_count=1,
        altitude_raw=height,
    )


def _converter(milli_g: float) -> int:
    return _clip(round(ACCELEROMETER_ZERO + ACCELEROMETER_STEP * milli_g), 0, 4095)


def _clip(value: int, low: int, high: int) -> int:
    return min(high, max(low, value))


def _phys_measures(onboard: Onboard) -> PhysMeasures:
    return PhysMeasures(accelerometer_temperature=45.0, accelerations=_milli_g(onboard), rates=_rates(onboard))


def _altitude(onboard: Onboard) -> Altitude:
    height = round(1e3 * onboard.height)
    return Altitude(vision=height, vz=1e3 * onboard.velocity[2], raw=height, observer_altitude=onboard.height)


def _vision_raw(onboard: Onboard) -> VisionRaw:
    forward, right, down = flu_from_frd(onboard.velocity)
    return VisionRaw(tx=forward, ty=right, tz=down)


def _vision(onboard: Onboard) -> Vision:
    forward, right, down = flu_from_frd(onboard.velocity)
    return Vision(
        theta_capture=-onboard.theta,
        phi_capture=onboard.phi,
        psi_capture=-onboard.psi,
        altitude_capture=round(1e3 * onboard.height),
        time_capture=Time.of(onboard.at).time,
        body_velocity=(1e3 * forward, 1e3 * right, 1e3 * down),
    )


def _pressure(onboard: Onboard) -> PressureRaw:
    return PressureRaw(temperature=250, pressure=round(SEA_LEVEL * exp(-onboard.height / SCALE_HEIGHT)))


def _magneto(onboard: Onboard) -> Magneto:
    heading = -degrees(onboard.psi)
    return Magneto(
        heading_unwrapped=heading,
        heading_gyro_unwrapped=heading,
        heading_fusion_unwrapped=heading,
        calibration_ok=1,
        radius=MAGNETIC_FIELD,
    )


def _constant(option: Structure) -> RawOption:
    return RawOption(TAGS[type(option)], option.encode())


CONSTANT: dict[type[Structure], RawOption] = {kind: _constant(kind()) for kind in OPTIONS} | {
    Wifi: _constant(Wifi(link_quality=0x3F800000))
}
"""Options as they stand when nothing moves them; the Wi-Fi quality is a single 1.0 read as an integer."""
