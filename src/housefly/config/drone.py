"""The drone: model, address, and the constants of its airframe that a site may know better."""

from __future__ import annotations

from math import hypot
from typing import Annotated, Any

from pydantic import Field, ValidationInfo, field_validator

from housefly.config.airframe import (
    Airframe,
    airframe_named,
    airframe_names,
    airframe_steered,
    is_model,
)
from housefly.config.section import Section
from housefly.messages.steering import SetpointForm

TWIN_ODOMETRY_ERROR = 0.001
"""The simulated drone's flow has the right scale."""
REAL_ODOMETRY_ERROR = 0.05
"""What an unmeasured drone is given."""
DRONE_NAME = "drone"
"""What the drone of a site that has one is called."""
NAME_PATTERN = "^[a-z][a-z0-9_-]{0,30}$"
"""Of a drone's name: it is a part of topics and file names."""
_Metres = Annotated[float, Field(ge=-1000.0, le=1000.0, allow_inf_nan=False)]
_Heading = Annotated[float, Field(ge=-3.1416, le=3.1416, allow_inf_nan=False)]


def _of_airframe(part: str, constant: str) -> Any:
    """Declare a constant that the airframe gives unless the site does, with the same bounds."""
    declared = Airframe.model_fields[part].annotation.model_fields[constant]  # type: ignore[union-attr]
    bounds = {
        side: getattr(item, side)
        for item in declared.metadata
        for side in ("ge", "le")
        if hasattr(item, side)
    }

    def given_by(fields: dict[str, Any]) -> Any:
        return getattr(getattr(airframe_named(fields["kind"]), part), constant)

    return Field(
        default_factory=given_by,
        **bounds,
        allow_inf_nan=False,
        description=declared.description,
        json_schema_extra=declared.json_schema_extra,
    )


class DroneConfig(Section):
    """The drone and where it answers."""

    name: str = Field(
        default=DRONE_NAME, pattern=NAME_PATTERN, description="what people and programs call it"
    )
    enabled: bool = Field(
        default=True,
        description="whether there is one; false: the room sees, remembers and answers, no flight",
    )
    kind: str = Field(
        default="ardrone", description="model: its driver, and the airframe with its constants"
    )
    address: str = Field(
        default="127.0.0.1", description="IP address; a real AR.Drone 2.0 is 192.168.1.1"
    )
    interface: str = Field(
        default="",
        pattern="^[A-Za-z0-9._@-]{0,15}$",
        description=(
            "network interface that leads to it, as wlan1: for drones that all have one address, as"
            " Tellos; left out: found by the address"
        ),
    )
    steered_by: SetpointForm | None = Field(
        default=None,
        description="setpoints that it is flown by, of those it takes; left out: as it prefers",
    )
    hull_length: float = _of_airframe("body", "hull_length")
    hull_width: float = _of_airframe("body", "hull_width")
    hull_height: float = _of_airframe("body", "hull_height")
    attitude_lag: float = _of_airframe("response", "attitude_lag")
    attitude_gain: float = _of_airframe("response", "attitude_gain")
    drag: float = _of_airframe("response", "drag")
    command_delay: float = _of_airframe("response", "command_delay")
    climb_lag: float = _of_airframe("response", "climb_lag")
    sink_gain: float = _of_airframe("response", "sink_gain")
    yaw_lag: float = _of_airframe("response", "yaw_lag")
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
    pad: tuple[_Metres, _Metres, _Heading] | None = Field(
        default=None,
        description="where it starts and lands: x, y [m], heading [rad]; left out: the room's pad",
    )

    @property
    def has_camera(self) -> bool:
        """Whether it is flown and has a camera."""
        return self.enabled and self.airframe.capabilities.camera is not None

    @property
    def reach(self) -> float:
        """From its middle to the corners of its hull [m]."""
        return 0.5 * hypot(self.hull_length, self.hull_width)

    @property
    def airframe(self) -> Airframe:
        """The constants of its model; those that the site may give itself are above."""
        if self.steered_by is not None:
            return airframe_steered(self.kind, self.steered_by)
        return airframe_named(self.kind)

    @field_validator("steered_by")
    @classmethod
    def _taken(cls, form: SetpointForm | None, info: ValidationInfo) -> SetpointForm | None:
        if form is not None and "kind" in info.data:
            airframe_steered(info.data["kind"], form)
        return form

    @field_validator("kind")
    @classmethod
    def _known(cls, kind: str) -> str:
        if not is_model(kind):
            raise ValueError(f"is {kind!r}; allowed: {', '.join(airframe_names())}")
        return kind
