"""What a drone can do, as data: its driver declares it, its airframe file states it."""

from __future__ import annotations

from enum import Enum
from typing import Self

from pydantic import Field, model_validator

from housefly.config.section import Section, quantity
from housefly.messages.steering import SetpointForm

TIME_MAX, RATE_MAX = 3600.0, 1000.0
MADE_FORMS = {
    SetpointForm.TILT_AND_CLIMB: SetpointForm.TILT_AND_CLIMB,
    SetpointForm.VELOCITY: SetpointForm.VELOCITY,
    SetpointForm.POSITION: SetpointForm.POSITION,
    SetpointForm.TRAJECTORY: SetpointForm.POSITION,
}
"""What the pilot makes for each form: a full state says the place, and leaves the rest at zero."""


class OwnManoeuvre(Enum):
    """What a drone does by itself, told once."""

    HOVER = "hover"
    TAKE_OFF = "take-off"
    LANDING = "landing"


class OwnMeasurement(Enum):
    """What a drone measures and reports, beside its state and its charge."""

    ATTITUDE = "attitude"
    VELOCITY = "velocity"
    HEIGHT = "height"


class SilenceAnswer(Enum):
    """What a drone does by itself once it hears nothing."""

    FLIES_ON = "flies on"
    HOVERS = "hovers"
    LANDS = "lands"
    CUTS_MOTORS = "cuts its motors"


class Silence(Section):
    """What a drone does by itself after how long without a command."""

    after: float = quantity(..., 0.0, TIME_MAX, "s", "silence that it bears")
    answer: SilenceAnswer = Field(description="what it does then")
    setpoint_ends_after: float | None = quantity(
        None, 0.0, TIME_MAX, "s", "before that: a velocity counts no longer, and it comes to rest"
    )


class OnboardCamera(Section):
    """The drone's camera: fixed to a level drone, looking ahead, square pixels, no distortion."""

    field_of_view: float = quantity(..., 0.1, 3.1, "rad", "horizontal")
    field_of_view_up: float = quantity(..., 0.1, 3.1, "rad", "vertical")
    width: int = Field(ge=16, le=8192, description="of a picture [px]")
    height: int = Field(ge=16, le=8192, description="of a picture [px]")
    ahead: float = quantity(..., -1.0, 1.0, "m", "how far before the drone's middle it sits")


class Capabilities(Section):
    """What one drone can do; what is left out it cannot."""

    setpoints: tuple[SetpointForm, ...] = Field(
        min_length=1, description="forms that it takes, the one to prefer first"
    )
    manoeuvres: frozenset[OwnManoeuvre] = Field(
        default=frozenset(), description="what it does by itself"
    )
    measures: frozenset[OwnMeasurement] = Field(
        default=frozenset(), description="what it reports of its motion"
    )
    arms: bool = Field(default=False, description="whether it must be armed before a take-off")
    external_pose_rate: float | None = Field(
        default=None,
        gt=0.0,
        le=RATE_MAX,
        description="how often it wants to be told its own pose; left out: not at all",
        json_schema_extra={"unit": "Hz"},
    )
    external_pose_stamped: bool = Field(
        default=False,
        description="whether it takes the time of a pose, too; else it is told where it is by now",
    )
    light: bool = Field(
        default=False, description="whether it can show that its camera is recorded"
    )
    camera: OnboardCamera | None = Field(default=None, description="its camera; left out: none")
    silence: Silence = Field(description="what it does by itself when it hears nothing")

    @model_validator(mode="after")
    def _can_be_flown(self) -> Self:
        if self.form is SetpointForm.POSITION and self.external_pose_rate is None:
            raise ValueError(
                "setpoints: a place in the room means nothing to a drone that is not told where it"
                " is; allowed: with external_pose_rate only"
            )
        return self

    @property
    def form(self) -> SetpointForm:
        """The form of setpoints that the pilot makes for it."""
        return MADE_FORMS[self.setpoints[0]]

    @property
    def forms(self) -> frozenset[SetpointForm]:
        """All that the pilot could make for it."""
        return frozenset(MADE_FORMS[form] for form in self.setpoints)

    @property
    def is_told_full_state(self) -> bool:
        """Whether a place is told it as a full state."""
        return self.setpoints[0] is SetpointForm.TRAJECTORY

    @property
    def hovers(self) -> bool:
        """Whether it can be left to hold its place by itself."""
        return OwnManoeuvre.HOVER in self.manoeuvres
