"""What Housefly sets on an AR.Drone, and what a full stick then means."""

from __future__ import annotations

from math import isclose

from housefly.config.limits import LimitsConfig
from housefly.messages.stick import Maxima
from housefly.messages.words import Words
from housefly.wires.ardrone.config import (
    COM_WATCHDOG_TIME,
    ConfigValue,
    Dump,
    VideoChannel,
    VideoCodec,
)

_FREE_FLIGHT = 0
_NO_DETECTION = 3
_VIDEO_BITRATE = 4000
"""[kbit/s]; a real 360p stream needs about 1200."""
_VIDEO_RATE_HZ = 30


def wanted_settings(limits: LimitsConfig) -> tuple[tuple[str, ConfigValue], ...]:
    """Return keys and values in writing order; ``outdoor`` comes first: it resets the limits."""
    return (
        ("control:outdoor", False),
        ("control:flight_without_shell", False),
        ("control:euler_angle_max", limits.tilt_max),
        ("control:control_vz_max", 1000.0 * limits.full_climb),
        ("control:control_yaw", limits.yaw_rate_max),
        ("control:altitude_max", round(1000.0 * limits.onboard_height_max)),
        ("control:flying_mode", _FREE_FLIGHT),
        ("general:com_watchdog", COM_WATCHDOG_TIME),
        ("detect:detect_type", _NO_DETECTION),
        ("video:video_codec", int(VideoCodec.H264_360P)),
        ("video:codec_fps", _VIDEO_RATE_HZ),
        ("video:bitrate", _VIDEO_BITRATE),
        ("video:max_bitrate", _VIDEO_BITRATE),
        ("video:video_channel", int(VideoChannel.FRONT)),
    )


def maxima_of(limits: LimitsConfig) -> Maxima:
    """Return what a full stick means once the limits are set."""
    return Maxima(limits.tilt_max, limits.full_climb, limits.yaw_rate_max)


def maxima_in(dump: Dump, wanted: Maxima) -> Maxima:
    """Return what a full stick means by the drone's own report, or as wanted where it is silent."""
    return Maxima(
        tilt=_number(dump, "control:euler_angle_max", wanted.tilt),
        climb=_number(dump, "control:control_vz_max", 1000.0 * wanted.climb) / 1000.0,
        yaw_rate=_number(dump, "control:control_yaw", wanted.yaw_rate),
    )


def setting_mismatches(dump: Dump, limits: LimitsConfig) -> dict[str, Words]:
    """Return the settings that the drone did not accept: keys, and what is wrong in words."""
    return {
        name: Words(
            "the drone keeps {setting} = {kept} instead of {wanted}",
            setting=name,
            kept=dump.texts.get(name, "-"),
            wanted=str(value),
        )
        for name, value in wanted_settings(limits)
        if not _same(dump.values.get(name), value)
    }


def is_needed_to_fly(name: str) -> bool:
    """Return whether a setting limits the flight; the others only make worse pictures."""
    return name.startswith("control:")


def _same(found: ConfigValue | None, wanted: ConfigValue) -> bool:
    if isinstance(found, int | float) and isinstance(wanted, int | float):
        return isclose(found, wanted, rel_tol=1e-5)
    return found == wanted


def _number(dump: Dump, name: str, otherwise: float) -> float:
    value = dump.values.get(name)
    return float(value) if isinstance(value, int | float) and value > 0 else otherwise
