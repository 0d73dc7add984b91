"""Navdata options of state, references and motors.

Units are the drone's own (mm, mm/s, millidegrees, mg) in its own frame forward-right-down;
``conversions`` turns them into ours. Field names follow Parrot's header where that says enough.
Facts: Parrot ARDroneLib SDK 2.0.1, navdata_common.h.
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

    theta, phi, psi in millidegrees (nose up, right side down, clockwise positive), altitude in mm,
    battery in percent, velocity forward, right, down in mm/s; a real drone leaves vz at 0. The
    ``detection`` and ``camera`` parts are deprecated fillers.
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
class Watchdog(Structure):
    """Watchdog counter."""

    watchdog: int = wire("i")


@dataclass(frozen=True, slots=True)
class Games(Structure):
    """Game counters."""

    double_taps: int = wire("I")
    finish_lines: int = wire("I")


@dataclass(frozen=True, slots=True)
class Wifi(Structure):
    """Wi-Fi link quality."""

    link_quality: int = wire("I")
