"""What Housefly sets on an AR.Drone, and what a full stick then means."""

from __future__ import annotations

from math import isclose

from housefly.config.site import LimitsConfig
from housefly.wires.ardrone.config import Dump, Value, VideoChannel, VideoCodec
from housefly.wires.ardrone.signs import Maxima

FREE_FLIGHT = 0
NO_DETECTION = 3
BITRATE = 4000
"""Of the video [kbit/s]; a real 360p stream needs about 1200."""
FRAME_RATE = 30


def wanted_settings(limits: LimitsConfig) -> tuple[tuple[str, Value], ...]:
    """Return keys and values in the order of writing: ``outdoor`` first, because it replaces the
    limits.
    """
    return (
        ("control:outdoor", False),
        ("control:flight_without_shell", False),
        ("control:euler_angle_max", limits.tilt_max),
        ("control:control_vz_max", 1000.0 * limits.vertical_speed_max),
        ("control:control_yaw", limits.yaw_rate_max),
        ("control:altitude_max", round(1000.0 * limits.height_max)),
        ("control:flying_mode", FREE_FLIGHT),
        ("detect:detect_type", NO_DETECTION),
        ("video:video_codec", int(VideoCodec.H264_360P)),
        ("video:codec_fps", FRAME_RATE),
        ("video:bitrate", BITRATE),
        ("video:max_bitrate", BITRATE),
        ("video:video_channel", int(VideoChannel.FRONT)),
    )


def maxima_of(limits: LimitsConfig) -> Maxima:
    """Return what a full stick means once all limits are set."""
    return Maxima(limits.tilt_max, limits.vertical_speed_max, limits.yaw_rate_max)


def maxima_in(dump: Dump, wanted: Maxima) -> Maxima:
    """Return what a full stick means by the drone's own words; what it does not say is as wanted."""
    return Maxima(
        tilt=_number(dump, "control:euler_angle_max", wanted.tilt),
        climb=_number(dump, "control:control_vz_max", 1000.0 * wanted.climb) / 1000.0,
        yaw_rate=_number(dump, "control:control_yaw", wanted.yaw_rate),
    )


def differences(dump: Dump, limits: LimitsConfig) -> tuple[str, ...]:
    """Return, in words, the settings that the drone did not take."""
    return tuple(
        f"the drone keeps {name} = {dump.texts.get(name, 'nothing')} instead of {value}"
        for name, value in wanted_settings(limits)
        if not _same(dump.values.get(name), value)
    )


def _same(found: Value | None, wanted: Value) -> bool:
    if isinstance(found, int | float) and isinstance(wanted, int | float):
        return isclose(found, wanted, rel_tol=1e-5)
    return found == wanted


def _number(dump: Dump, name: str, otherwise: float) -> float:
    value = dump.values.get(name)
    return float(value) if isinstance(value, int | float) and value > 0 else otherwise
