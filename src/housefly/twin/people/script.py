"""The file of a scene: people and their steps, things, and devices. Lengths in metres."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from housefly.config.section import Section, quantity

_Coordinate = Annotated[float, Field(ge=-1000.0, le=1000.0, allow_inf_nan=False)]
_Point2 = tuple[_Coordinate, _Coordinate]
_Point3 = tuple[_Coordinate, _Coordinate, _Coordinate]
_Name = Annotated[str, Field(pattern=r"^[A-Za-z0-9][A-Za-z0-9_.:-]{0,63}$")]
_DeviceKind = Literal[
    "floor", "cabinet", "refrigerator", "bed", "door", "doorbell", "motion",
    "switch", "power", "temperature", "contact", "level",
]  # fmt: skip


class Go(Section):
    """Walk straight to a point."""

    do: Literal["go"]
    to: _Point2
    speed: float = quantity(0.8, 0.05, 3.0, "m/s", "walking speed")


class Wait(Section):
    """Stand still."""

    do: Literal["wait"]
    seconds: float = quantity(1.0, 0.0, 3600.0, "s", "how long")
    yaw: float | None = Field(
        default=None, ge=-6.3, le=6.3, description="where to face [rad]; as before when not given"
    )


class Sit(Section):
    """Sit down, then get up again in the place before."""

    do: Literal["sit"]
    at: _Point2
    yaw: float = quantity(0.0, -6.3, 6.3, "rad", "where to face")
    seat: float = quantity(0.44, 0.0, 1.5, "m", "height of the seat")
    seconds: float = quantity(10.0, 0.0, 3600.0, "s", "how long")


class Lie(Section):
    """Lie down, then get up again in the place before."""

    do: Literal["lie"]
    at: _Point2
    yaw: float = quantity(0.0, -6.3, 6.3, "rad", "direction from feet to head")
    height: float = quantity(0.46, 0.0, 2.0, "m", "height of the mattress")
    seconds: float = quantity(10.0, 0.0, 3600.0, "s", "how long")


class Take(Section):
    """Take a thing from where it is."""

    do: Literal["take"]
    thing: _Name


class Put(Section):
    """Put down a carried thing: into a device, or somewhere."""

    do: Literal["put"]
    thing: _Name
    into: str = ""
    at: _Point3 | None = None


class Handle(Section):
    """Open or close a device's door, press its button, or switch it on or off."""

    do: Literal["open", "close", "press", "on", "off"]
    what: _Name


class Appear(Section):
    """Enter the room at a point."""

    do: Literal["appear"]
    at: _Point2
    yaw: float = quantity(0.0, -6.3, 6.3, "rad", "where to face")


class Vanish(Section):
    """Leave the room."""

    do: Literal["vanish"]


_Step = Annotated[
    Go | Wait | Sit | Lie | Take | Put | Handle | Appear | Vanish, Field(discriminator="do")
]


class PersonScript(Section):
    """One person."""

    name: _Name
    start: _Point2 | None = Field(
        default=None, description="where they stand at first; away when not given"
    )
    yaw: float = quantity(0.0, -6.3, 6.3, "rad", "where they face at first")
    height: float = quantity(1.65, 0.5, 2.3, "m", "body height")
    weight: float = quantity(60.0, 2.0, 300.0, "kg", "body weight")
    visitor: bool = Field(
        default=False,
        description="whether this is the visitor, whose body the room has and who stands still",
    )
    steps: tuple[_Step, ...] = Field(max_length=1000)


class ThingScript(Section):
    """One thing that can be carried."""

    name: _Name
    tag: _Name
    weight: float = quantity(0.2, 0.0, 100.0, "kg", "weight")
    at: _Point3 | None = Field(default=None, description="where it is at first")
    inside: str = Field(default="", description="id of the device that contains it at first")


class DeviceScript(Section):
    """One device and its place; a device with doors starts closed."""

    kind: _DeviceKind
    id: _Name
    position: _Point3 = (0.0, 0.0, 0.0)
    yaw: float = quantity(0.0, -6.3, 6.3, "rad", "direction of its x axis")
    area: tuple[_Coordinate, _Coordinate, _Coordinate, _Coordinate] = Field(
        default=(-1000.0, -1000.0, 1000.0, 1000.0),
        description="x_min, y_min, x_max, y_max of what it notices [m]",
    )
    noise: float = quantity(
        0.0, 0.0, 10.0, "", "one-sigma error in its own unit: m of a floor, kg of a load cell"
    )
    value_on: float | None = Field(
        default=None,
        ge=-1e5,
        le=1e5,
        description="what it measures when on [W, degrees Celsius, %]",
    )
    value_off: float | None = Field(
        default=None, ge=-1e5, le=1e5, description="what it measures when off, likewise"
    )


class SceneScript(Section):
    """A whole scene."""

    name: str = Field(min_length=1, max_length=80)
    seed: int = Field(default=1, ge=0, le=2**31 - 1)
    variation: float = quantity(
        0.0, 0.0, 0.5, "", "largest share by which speeds and waits differ, drawn with the seed"
    )
    loop: bool = Field(default=False, description="whether it begins anew when everybody is done")
    pause: float = quantity(5.0, 0.0, 3600.0, "s", "rest at the end of each round")
    people: tuple[PersonScript, ...] = ()
    things: tuple[ThingScript, ...] = ()
    devices: tuple[DeviceScript, ...] = ()
