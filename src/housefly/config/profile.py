"""Drone profiles: the measured constants of one drone with their intervals, in a readable file."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from housefly.config.toml import read_toml
from housefly.errors import ConfigError


class DroneConstant(NamedTuple):
    """One constant of a drone.

    Attributes:
        unit: "1" for pure numbers.
        low: smallest plausible value.
        high: largest plausible value.
        meaning: one line.
    """

    unit: str
    low: float
    high: float
    meaning: str


CONSTANTS: dict[str, DroneConstant] = {
    "attitude_gain": DroneConstant(
        "1", 0.2, 2.0, "c / lambda of paper eq. (22): achieved over commanded angle"
    ),
    "attitude_lag": DroneConstant(
        "1/s", 0.5, 50.0, "lambda of paper eq. (22): pole of the attitude response"
    ),
    "command_delay": DroneConstant("s", 0.0, 0.5, "from command to first reaction"),
    "drag": DroneConstant("1/s", 0.0, 5.0, "linear drag over mass"),
    "climb_lag": DroneConstant("1/s", 0.2, 50.0, "pole of the climb rate response"),
    "yaw_lag": DroneConstant("1/s", 0.2, 50.0, "pole of the yaw rate response"),
}
"""By the key that the constant has in ``[drone]`` of a site file."""


@dataclass(frozen=True, slots=True)
class Interval:
    """A measured value with its 95 % interval."""

    value: float
    low: float
    high: float


def load_profile(path: Path) -> dict[str, float]:
    """Return the constants of a profile by their keys in ``[drone]``.

    Raises:
        ConfigError: naming the key, the value and the allowed range.
    """
    tree = read_toml(path, "drone.profile")
    constants = tree.get("constants")
    if not isinstance(constants, dict) or not constants:
        raise ConfigError("constants", "is missing: this is no drone profile", str(path))
    return {key: _checked(key, value, path) for key, value in constants.items()}


def _checked(key: str, value: Any, path: Path) -> float:
    known = CONSTANTS.get(key)
    if known is None:
        raise ConfigError(
            f"constants.{key}",
            f"is no constant of a drone; there are: {', '.join(CONSTANTS)}",
            str(path),
        )
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    if not is_number or not known.low <= value <= known.high:
        unit = "" if known.unit == "1" else f" {known.unit}"
        allowed = f"a number from {known.low:g} to {known.high:g}{unit}"
        raise ConfigError(f"constants.{key}", f"is {value!r}; allowed: {allowed}", str(path))
    return float(value)


def write_profile(path: Path, constants: dict[str, Interval], measured: dict[str, str]) -> None:
    """Write a profile.

    Args:
        path: the file.
        constants: by key, in the order of ``CONSTANTS``.
        measured: how and when, as lines of key and words.
    """
    lines = [
        "# Drone profile, written by housefly identify. A site uses it with:",
        "#   [drone]",
        f'#   profile = "{path.name}"',
        "",
    ]
    lines += ["[constants]"]
    for key, found in constants.items():
        known = CONSTANTS[key]
        unit = "" if known.unit == "1" else f" {known.unit}"
        lines.append(
            f"{key} = {found.value:.5g}  # {known.meaning}; 95 %: {found.low:.4g} to"
            f" {found.high:.4g}{unit}"
        )
    lines += ["", "[intervals]  # 95 %"]
    lines += [f"{key} = [{found.low:.5g}, {found.high:.5g}]" for key, found in constants.items()]
    lines += ["", "[measured]", *(f'{key} = "{words}"' for key, words in measured.items())]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
