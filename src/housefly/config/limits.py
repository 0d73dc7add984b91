"""What a drone may do, and when it has to land."""

from __future__ import annotations

from typing import Self

from pydantic import model_validator

from housefly.config.section import Section, quantity

LIFTING_HEADROOM = 1.0
"""The drone's own highest altitude lies this far above ``height_max`` [m]: it halves what is left
to it every second, and a load needs climb rate only to stand still.
"""


class LimitsConfig(Section):
    """What the drone may do."""

    tilt_max: float = quantity(0.21, 0.02, 0.5, "rad", "largest pitch or roll (paper: 0.21)")
    vertical_speed_max: float = quantity(0.7, 0.05, 2.0, "m/s", "largest climb or sink rate")
    climb_command_max: float = quantity(
        1.0,
        0.0,
        2.0,
        "m/s",
        "largest climb rate asked of the drone's own loop: a load takes its share of it, a tenth of"
        " the weight 0.7 m/s; below vertical_speed_max, and in mode paper, it is that",
    )
    yaw_rate_max: float = quantity(1.75, 0.1, 6.2, "rad/s", "largest yaw rate")
    speed: float = quantity(0.5, 0.05, 2.0, "m/s", "cruise speed along a path")
    nudge_speed: float = quantity(
        0.0, 0.0, 0.5, "m/s", "largest speed when a person moves the drone by hand; 0: not possible"
    )
    acceleration: float = quantity(
        1.6, 0.1, 5.0, "m/s^2", "largest of a trajectory, level, drag included (PX4: MPC_ACC_HOR)"
    )
    jerk: float = quantity(
        12.0, 0.5, 100.0, "m/s^3", "largest of a trajectory (PX4: MPC_JERK_AUTO)"
    )
    vertical_acceleration: float = quantity(
        0.6, 0.05, 5.0, "m/s^2", "largest of a trajectory, up or down (PX4: MPC_ACC_UP_MAX)"
    )
    height_min: float = quantity(0.3, 0.1, 3.0, "m", "lowest height to fly at")
    landing_height: float = quantity(
        0.25,
        0.15,
        1.0,
        "m",
        "the pilot steers a landing down to here by tracking, the last bit is the drone's own",
    )
    landing_lead: float = quantity(
        0.25,
        0.0,
        0.5,
        "m",
        "at the end of a steered descent a height this far below landing_height is wanted, so that"
        " the drone arrives there sinking and its own landing is short",
    )
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

    @property
    def full_climb(self) -> float:
        """What a full stick up means to the drone [m/s]."""
        return max(self.climb_command_max, self.vertical_speed_max)

    @property
    def onboard_height_max(self) -> float:
        """Altitude above which the drone does not climb by its own word [m]."""
        can_lift = self.climb_command_max > self.vertical_speed_max
        return self.height_max + (LIFTING_HEADROOM if can_lift else 0.0)

    @model_validator(mode="after")
    def _combinations(self) -> Self:
        if self.height_min >= self.height_max:
            raise ValueError(
                f"height_min ({self.height_min} m) must be below height_max ({self.height_max} m)"
            )
        if self.landing_lead > self.landing_height:
            raise ValueError(
                f"landing_lead ({self.landing_lead} m) must not be above landing_height"
                f" ({self.landing_height} m)"
            )
        if self.pose_age_level >= self.pose_age_land:
            raise ValueError(
                f"pose_age_level ({self.pose_age_level} s) must be below pose_age_land"
                f" ({self.pose_age_land} s)"
            )
        return self
