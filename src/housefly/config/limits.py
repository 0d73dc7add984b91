"""What a drone may do, and when it has to land."""

from __future__ import annotations

from typing import Self

from pydantic import model_validator

from housefly.config.section import Section, quantity


class LimitsConfig(Section):
    """What the drone may do."""

    tilt_max: float = quantity(0.21, 0.02, 0.5, "rad", "largest pitch or roll (paper: 0.21)")
    vertical_speed_max: float = quantity(0.7, 0.05, 2.0, "m/s", "largest climb or sink rate")
    yaw_rate_max: float = quantity(1.75, 0.1, 6.2, "rad/s", "largest yaw rate")
    speed: float = quantity(0.5, 0.05, 2.0, "m/s", "cruise speed along a path")
    height_min: float = quantity(0.3, 0.1, 3.0, "m", "lowest height to fly at")
    height_max: float = quantity(2.0, 0.3, 10.0, "m", "highest height to fly at")
    battery_floor: float = quantity(
        0.15, 0.05, 0.9, "1", "land below this charge; no take-off below it plus 0.05"
    )
    pose_age_level: float = quantity(0.25, 0.05, 2.0, "s", "level the drone when the pose is older")
    pose_age_land: float = quantity(2.0, 0.3, 10.0, "s", "land when the pose is older")
    telemetry_age: float = quantity(
        1.0, 0.1, 10.0, "s", "land when the drone's own report is older"
    )
    fence_margin: float = quantity(
        1.0, 0.2, 5.0, "m", "land when further outside the map than this"
    )
    take_off_timeout: float = quantity(
        10.0, 2.0, 60.0, "s", "give up a take-off that is not acknowledged"
    )
    landing_timeout: float = quantity(
        15.0,
        2.0,
        60.0,
        "s",
        "report a landing that is not acknowledged; from then on the drone is made to sink",
    )
    hold_timeout: float = quantity(
        120.0, 5.0, 3600.0, "s", "come home when nothing was ordered for this long"
    )
    flight_time: float = quantity(
        600.0, 30.0, 7200.0, "s", "how long the drone can fly on a full battery"
    )

    @model_validator(mode="after")
    def _combinations(self) -> Self:
        if self.height_min >= self.height_max:
            raise ValueError(
                f"height_min ({self.height_min} m) must be below height_max ({self.height_max} m)"
            )
        if self.pose_age_level >= self.pose_age_land:
            raise ValueError(
                f"pose_age_level ({self.pose_age_level} s) must be below pose_age_land"
                f" ({self.pose_age_land} s)"
            )
        return self
