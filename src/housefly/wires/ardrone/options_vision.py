"""Navdata options of vision and video.

Units are the drone's own (mm, mm/s, millidegrees, mg) in its own frame forward-right-down;
``conversions`` turns them into ours. Field names follow Parrot's header where that says enough.
Facts: Parrot ARDroneLib SDK 2.0.1, navdata_common.h.
"""

from __future__ import annotations

from dataclasses import dataclass

from housefly.wires.ardrone.layout import Structure, wire


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
    """Up to four detected tags; image coordinates 0..1000, distance in cm, angles in degrees."""

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
class HdVideoStream(Structure):
    """Recording and live fifo statistics."""

    state: int = wire("I")
    storage_fifo_packets: int = wire("I")
    storage_fifo_size: int = wire("I")
    usbkey_size: int = wire("I")
    usbkey_free: int = wire("I")
    frame_number: int = wire("I")
    usbkey_remaining_time: int = wire("I")
