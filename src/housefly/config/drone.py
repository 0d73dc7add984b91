"""The drone: driver, address, and the constants of its airframe."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from housefly.config.section import Section, quantity

TWIN_ODOMETRY_ERROR = 0.001
"""The simulated drone's flow has the right scale."""
REAL_ODOMETRY_ERROR = 0.05
"""What an unmeasured drone is given."""


class DroneConfig(Section):
    """The drone and where it answers."""

    enabled: bool = Field(
        default=True,
        description="whether there is one; false: the room sees, remembers and answers, no flight",
    )
    kind: Literal["ardrone"] = Field(default="ardrone", description="driver")
    address: str = Field(
        default="127.0.0.1", description="IP address; a real AR.Drone 2.0 is 192.168.1.1"
    )
    hull_length: float = quantity(0.517, 0.05, 2.0, "m", "longer side of the hull")
    hull_width: float = quantity(0.451, 0.05, 2.0, "m", "shorter side of the hull")
    hull_height: float = quantity(0.13, 0.02, 1.0, "m", "of the hull, planner space")
    attitude_lag: float = quantity(
        7.0, 0.5, 50.0, "1/s", "lambda of paper eq. (22): pole of the attitude response"
    )
    attitude_gain: float = quantity(
        1.0, 0.2, 2.0, "1", "c / lambda of paper eq. (22): achieved over commanded angle"
    )
    drag: float = quantity(0.58, 0.0, 5.0, "1/s", "linear drag over mass")
    command_delay: float = quantity(0.06, 0.0, 0.5, "s", "from command to first reaction")
    climb_lag: float = quantity(1.4, 0.2, 50.0, "1/s", "pole of the climb rate response")
    sink_gain: float = quantity(
        2.0,
        0.5,
        3.0,
        "1",
        "what the drone makes of a commanded sinking, over what was commanded (an AR.Drone's stick"
        " sinks twice as fast as it climbs); counts with estimation.lift_wander",
    )
    yaw_lag: float = quantity(25.0, 0.2, 50.0, "1/s", "pole of the yaw rate response")
    profile: str = Field(
        default="",
        description=(
            "drone profile of housefly identify, relative to this file; gives the constants"
        ),
    )
    odometry_error: float | None = Field(
        default=None,
        ge=0.0,
        le=0.3,
        description=(
            "share of a way by which the drone's own odometry (flow scale, tracked heading) may"
            f" misjudge it; left out: {TWIN_ODOMETRY_ERROR} with the simulated drone, else"
            f" {REAL_ODOMETRY_ERROR}"
        ),
        json_schema_extra={"unit": "1"},
    )
    has_video: bool = Field(default=True, description="whether to open the camera stream")
