"""What a site file must say for gains to keep their promise, limits included."""

from __future__ import annotations

from collections.abc import Mapping
from math import ceil

from housefly.config.site import Site
from housefly.lab.tuning.advice import Advice, GainQuestion
from housefly.lab.tuning.loop import Loop

_LEVEL_STEP = 0.05
"""Ages of a pose are rounded up to multiples of this [s]."""
_LAND_AFTER_LEVEL = 1.0
"""The drone holds itself at least this long before it lands [s]."""
_SAME_SHARE = 1e-3
"""Numbers that differ by a smaller share are the same."""
_ROUNDING = 1e-9

SiteLines = dict[str, dict[str, float | str]]
"""Values by table and key."""


def _pose_age_needed(loop: Loop) -> float:
    """Return the age of the newest pose that the drone must bear [s].

    A frame is used a tick after it has arrived at the latest, and until the next but one comes: a
    single lost frame must not stop the drone.
    """
    oldest = loop.latency + 2.0 / loop.tracking_hz + 2.0 / loop.rate_hz
    return round(_LEVEL_STEP * ceil(oldest / _LEVEL_STEP - _ROUNDING), 3)


def site_lines(
    advice: Advice, question: GainQuestion, site: Site, drone: Mapping[str, float | str]
) -> SiteLines:
    """Return gains and filter, and every other value that differs from the site's.

    Args:
        advice: the recommendation.
        question: what it answers.
        site: where what is not written comes from.
        drone: constants that were given otherwise, or the profile that holds them.
    """
    loop, limits = advice.judgement.loop, site.limits
    level = max(limits.pose_age_level, _pose_age_needed(loop))
    wanted: dict[str, dict[str, float | str]] = {
        "drone": dict(drone),
        "control": {
            "alpha": loop.alpha,
            "beta": loop.beta,
            "yaw_gain": advice.yaw.gain,
            "height_gain": advice.height.gain,
            "acceleration_noise": loop.acceleration_noise,
            "position_noise": loop.position_noise,
        },
        "limits": {
            "tilt_max": question.tilt_max,
            "pose_age_level": level,
            "pose_age_land": max(limits.pose_age_land, level + _LAND_AFTER_LEVEL),
        },
        "twin": {
            "mocap_rate_hz": loop.tracking_hz,
            "mocap_latency": loop.latency,
            "mocap_noise": question.noise,
        },
    }
    return {
        table: kept
        for table, values in wanted.items()
        if (kept := values if table == "control" else _changed(values, getattr(site, table)))
    }


def as_toml(lines: SiteLines) -> str:
    """Return the lines as they stand in a site file."""
    tables = (
        "\n".join((f"[{table}]", *(f"{key} = {_written(value)}" for key, value in values.items())))
        for table, values in lines.items()
    )
    return "\n\n".join(tables)


def _changed(values: Mapping[str, float | str], section: object) -> dict[str, float | str]:
    return {key: value for key, value in values.items() if not _is(value, getattr(section, key))}


def _is(value: float | str, own: object) -> bool:
    if isinstance(value, str) or not isinstance(own, int | float):
        return value == own
    return abs(value - own) <= _SAME_SHARE * abs(own)


def _written(value: float | str) -> str:
    return f'"{value}"' if isinstance(value, str) else f"{value:.5g}"
