"""The campaign file: mission, fixed columns, grid, and columns drawn for each seed.

Every key is checked; columns are those of ``experiments.cases.PARAMETERS``, in SI.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import prod
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field

from housefly.config.section import Section, quantity
from housefly.config.toml import read_toml
from housefly.config.validation import Location, dotted, validated
from housefly.errors import ConfigError
from housefly.lab.campaigns.draws import ColumnValue, Draw
from housefly.lab.experiments.cases import BY_NAME, PARAMETERS, WHOLE, checked
from housefly.lab.experiments.outcomes import SUMMARY_MEASURES

_MAX_DRONES = 50_000_000
"""More drones than this are refused: their results would fill the disk."""
_MAX_POINTS = 100_000
"""A grid with more points than this is refused: nobody reads that many rows."""
COLUMN_WORDS: dict[str, dict[str, int]] = {
    "mode": {"default": 0, "paper": 1},
    "estimator": {
        "delay_compensated": 0,
        "on_arrival": 1,
        "held_sample": 2,
        "finite_difference": 3,
    },
}
"""Words for the values of the columns that hold whole numbers."""
_UNION_TAGS = ("constrained-float", "float", "str")
"""Parts that pydantic adds to the location of an error in a value that is a number or a word."""

_Coordinate = Annotated[float, Field(ge=-1000.0, le=1000.0, allow_inf_nan=False)]
_Point = tuple[_Coordinate, _Coordinate]


class _MissionSpec(Section):
    """What every drone flies: a planned path to a place, or given waypoints."""

    task: Literal["path", "step", "hold"] = Field(
        default="path", description="how the reference moves"
    )
    goal: str = Field(
        default="", description="a place of the site's room; the way is planned in each mode"
    )
    start: str = Field(default="home", description="a place of the site's room")
    waypoints: tuple[_Point, ...] = Field(
        default=(), max_length=1000, description="world x, y [m], in place of goal"
    )
    duration_s: float = quantity(30.0, 3.0, 3600.0, "s", "of each flight")


class CampaignSpec(Section):
    """One campaign."""

    name: str = Field(
        min_length=1,
        max_length=80,
        pattern=r"^[\w .,()-]+$",
        description="names the folder of the results",
    )
    site: str = Field(
        default="bsen", description="shipped site or site file, relative to this file"
    )
    seeds: int = Field(
        default=20, ge=1, le=10_000_000, description="drones for each point of the grid"
    )
    first_seed: int = Field(default=0, ge=0, le=2**40, description="seeds are numbered from here")
    mission: _MissionSpec = _MissionSpec()
    fixed: dict[str, ColumnValue] = Field(default={}, description="columns with one value")
    grid: dict[str, tuple[ColumnValue, ...]] = Field(
        default={}, description="columns with several; every combination is flown"
    )
    draw: dict[str, Draw] = Field(default={}, description="columns drawn anew for each seed")
    plot: tuple[str, ...] = Field(default=("stable", "rms_error"), description="measures to draw")

    @property
    def points(self) -> int:
        """How many points the grid has."""
        return prod(len(values) for values in self.grid.values())

    @property
    def drones(self) -> int:
        """How many drones fly in all."""
        return self.points * self.seeds


def load_spec(path: Path) -> CampaignSpec:
    """Read and check a campaign file (TOML).

    Raises:
        ConfigError: naming the key, the value, what is allowed, and the unit.
    """
    tree = read_toml(path, "campaign file")
    return spec_from_tree(tree, str(path))


def spec_from_tree(tree: Mapping[str, Any], source: str = "") -> CampaignSpec:
    """Check plain values and return the campaign; raises ConfigError for the first error."""
    spec = validated(CampaignSpec, tree, "campaign file", source, _key)
    try:
        return _with_numbers(spec)
    except ConfigError as error:
        raise ConfigError(error.key, error.problem, source) from error


def _key(location: Location) -> str:
    return dotted(part for part in location if part not in _UNION_TAGS)


def _with_numbers(spec: CampaignSpec) -> CampaignSpec:
    """Return the campaign with words replaced by numbers, and columns and sizes checked."""
    _check_names(spec)
    fixed = {name: _number(f"fixed.{name}", name, value) for name, value in spec.fixed.items()}
    grid = {
        name: tuple(_number(f"grid.{name}", name, value) for value in values)
        for name, values in spec.grid.items()
    }
    for name, values in grid.items():
        if not values:
            raise ConfigError(f"grid.{name}", "is empty; give at least one value")
        if len(set(values)) != len(values):
            raise ConfigError(f"grid.{name}", "names a value twice")
    draw = {name: _drawable(f"draw.{name}", name, draw) for name, draw in spec.draw.items()}
    whole = spec.model_copy(update={"fixed": fixed, "grid": grid, "draw": draw})
    if whole.points > _MAX_POINTS:
        raise ConfigError("grid", f"has {whole.points} points; allowed: at most {_MAX_POINTS}")
    if whole.drones > _MAX_DRONES:
        raise ConfigError(
            "seeds",
            f"{whole.points} points times {spec.seeds} seeds are {whole.drones} drones; allowed: at"
            f" most {_MAX_DRONES}",
        )
    return whole


def _check_names(spec: CampaignSpec) -> None:
    known = [parameter.name for parameter in PARAMETERS]
    seen: dict[str, str] = {}
    for section in ("fixed", "grid", "draw"):
        for name in getattr(spec, section):
            if name not in known:
                raise ConfigError(
                    f"{section}.{name}", f"is no column; there are: {', '.join(known)}"
                )
            if name in seen:
                raise ConfigError(f"{section}.{name}", f"is given in [{seen[name]}] too")
            seen[name] = section
    if "mode" in spec.draw:
        raise ConfigError(
            "draw.mode",
            "the way is planned for each mode beforehand: put mode into [grid] or [fixed]",
        )
    measures = [measure.name for measure in SUMMARY_MEASURES]
    for name in spec.plot:
        if name not in measures:
            raise ConfigError("plot", f"{name!r} is no measure; there are: {', '.join(measures)}")
    mission = spec.mission
    if bool(mission.goal) == bool(mission.waypoints):
        raise ConfigError(
            "mission", "give either goal (a place) or waypoints ([[x, y], ...] in metres)"
        )
    if mission.task != "hold" and mission.waypoints and len(mission.waypoints) < 2:
        raise ConfigError("mission.waypoints", f"task {mission.task!r} needs at least two points")


def _drawable(key: str, name: str, draw: Draw) -> Draw:
    if draw.kind == "choice":
        return Draw(
            choice=tuple(_number(f"{key}.choice", name, value) for value in draw.choice or ())
        )
    if name in WHOLE:
        raise ConfigError(
            key, f"is {draw.kind}; allowed: choice, because the column holds whole numbers"
        )
    draw.check(key, BY_NAME[name])
    return draw


def _number(key: str, name: str, value: ColumnValue) -> float:
    words = COLUMN_WORDS.get(name, {})
    if isinstance(value, str):
        if value not in words:
            allowed = f"one of {', '.join(words)}" if words else "a number"
            raise ConfigError(key, f"is {value!r}; allowed: {allowed}")
        return float(words[value])
    try:
        checked(name, np.asarray(value))
    except ConfigError as error:
        raise ConfigError(key, error.problem) from error
    if words and value != int(value):
        raise ConfigError(
            key,
            f"is {value:g}; allowed:"
            f" {', '.join(f'{word} ({number})' for word, number in words.items())}",
        )
    return float(value)
