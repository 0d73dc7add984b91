"""The part of a site file about tasks: what may fly by itself, and what is kept of it."""

from __future__ import annotations

from typing import Literal, Self

from pydantic import Field, model_validator

from housefly.config.section import Section, quantity

ModeName = Literal["home", "away", "night", "privacy", "maintenance"]


class PrivacyZone(Section):
    """A part of the room that no clip, snapshot or live picture shows."""

    name: str = Field(min_length=1, max_length=60, description="shown on the map")
    polygon: tuple[tuple[float, float], ...] = Field(
        min_length=3, max_length=40, description="corners on the floor, world xy [m]"
    )
    z_min: float = quantity(0.0, -1.0, 10.0, "m", "lower end")
    z_max: float = quantity(2.5, -1.0, 10.0, "m", "upper end")

    @model_validator(mode="after")
    def _ordered(self) -> Self:
        if self.z_min >= self.z_max:
            raise ValueError(f"z_min ({self.z_min} m) must lie below z_max ({self.z_max} m)")
        return self


class TasksConfig(Section):
    """Services: tasks, rules, clips."""

    enabled: bool = Field(default=True, description="start them; false flies by orders only")
    documents: str = Field(
        default="", max_length=500, description="folder of own tasks (YAML), relative to this file"
    )
    rules: str = Field(
        default="", max_length=500, description="file of rules (YAML), relative to this file"
    )
    mode: ModeName = Field(default="home", description="mode of the house at the first start")
    language: Literal["en", "de", "ja"] = Field(
        default="en", description="of sentences, where the asking surface does not say"
    )
    queue: int = Field(
        default=20, ge=1, le=200, description="tasks that may wait; one more is refused"
    )
    clip_before: float = quantity(5.0, 0.0, 30.0, "s", "that a clip shows before its beginning")
    clip_days: float = quantity(30.0, 0.0, 3650.0, "d", "clips of people are kept so long")
    snapshot_days: float = quantity(90.0, 0.0, 3650.0, "d", "snapshots are kept so long")
    clip_space_gb: float = quantity(
        2.0, 0.01, 1000.0, "GB", "that clips may take; then the oldest go first"
    )
    privacy_zones: tuple[PrivacyZone, ...] = Field(
        default=(), max_length=50, description="what no picture shows"
    )
