"""The constants of one model of drone, with where each comes from: ``airframes/<model>.toml``.

What is one drone's and not ours stands there. A table of such a file gives a ``source`` for all of
its numbers, or each number as ``{ value = ..., source = "..." }``; a number without one is refused.
"""

from __future__ import annotations

import tomllib
from enum import Enum
from functools import lru_cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Self

from pydantic import Field, ValidationError, model_validator

from housefly.config.capabilities import Capabilities, OwnManoeuvre, OwnMeasurement
from housefly.config.section import Section, quantity
from housefly.errors import ConfigError
from housefly.geometry import stopping_distance
from housefly.messages.steering import SetpointForm

FOLDER = Path(__file__).parent / "airframes"
folders = [FOLDER]
"""Where airframe files lie: ours, and what a program of one's own adds before it opens a site."""
_SOURCED = {"value", "source"}


class BodyConstants(Section):
    """Mass and hull."""

    mass: float = quantity(..., 0.01, 10.0, "kg", "as it flies, with hull and battery")
    hull_length: float = quantity(..., 0.05, 2.0, "m", "longer side of the hull")
    hull_width: float = quantity(..., 0.05, 2.0, "m", "shorter side of the hull")
    hull_height: float = quantity(..., 0.02, 1.0, "m", "of the hull, planner space")
    standing_height: float = quantity(
        ..., 0.0, 1.0, "m", "height of its middle above the floor when it stands"
    )
    inertia_tilt: float | None = quantity(
        None, 1e-7, 1.0, "kg m^2", "moment about its roll and pitch axes; of the simulated drone"
    )
    inertia_turn: float | None = quantity(
        None, 1e-7, 1.0, "kg m^2", "moment about its yaw axis; of the simulated drone"
    )
    thrust_max: float | None = quantity(
        None, 0.01, 1000.0, "N", "of all its motors together; of the simulated drone"
    )
    rotor_arm: float | None = quantity(
        None, 0.01, 1.0, "m", "from each motor to the roll and pitch axes; of the simulated drone"
    )


class ResponseConstants(Section):
    """How it follows what it is asked for; a site and a drone profile may know better."""

    attitude_lag: float = quantity(
        ..., 0.5, 50.0, "1/s", "lambda of paper eq. (22): pole of the attitude response"
    )
    attitude_gain: float = quantity(
        ..., 0.2, 2.0, "1", "c / lambda of paper eq. (22): achieved over commanded angle"
    )
    drag: float = quantity(..., 0.0, 5.0, "1/s", "linear drag over mass")
    command_delay: float = quantity(..., 0.0, 0.5, "s", "from command to first reaction")
    climb_lag: float = quantity(..., 0.2, 50.0, "1/s", "pole of the climb rate response")
    sink_gain: float = quantity(
        ...,
        0.5,
        3.0,
        "1",
        "what the drone makes of a commanded sinking, over what was commanded; counts with"
        " estimation.lift_wander",
    )
    yaw_lag: float = quantity(..., 0.2, 50.0, "1/s", "pole of the yaw rate response")
    hover_brake: float = quantity(
        0.0, 0.0, 20.0, "1/s", "how quickly its own hover stops it, on top of drag"
    )
    velocity_lag: float | None = quantity(
        None, 0.2, 50.0, "1/s", "pole of the velocity response, of a drone that takes velocities"
    )
    stiffness: float | None = quantity(
        None,
        0.1,
        400.0,
        "1/s^2",
        "how hard it flies to a place that is asked for, per distance; of one that takes places",
    )
    damping: float | None = quantity(
        None, 0.2, 50.0, "1/s", "how hard it brakes on the way there, per speed; climb_lag upwards"
    )
    speed_max: float | None = quantity(
        None, 0.1, 20.0, "m/s", "fastest flight that it makes of a velocity or a place asked for"
    )
    climb_max: float | None = quantity(
        None, 0.05, 20.0, "m/s", "fastest climb that it makes, whatever is asked for"
    )
    turn_max: float | None = quantity(
        None, 0.1, 20.0, "rad/s", "fastest turn that it makes, whatever is asked for"
    )


class BrakeConstants(Section):
    """How it is brought to rest when nobody else steers any more."""

    gain: float = quantity(..., 0.1, 20.0, "1/s", "deceleration per speed, still well damped")
    lead: float = quantity(
        ..., 0.0, 2.0, "s", "the present attitude goes on accelerating for so long: delay and lag"
    )
    time_max: float = quantity(..., 0.0, 5.0, "s", "longest time before its own hover takes over")
    rest_speed: float = quantity(
        ..., 0.0, 1.0, "m/s", "slower than this, lead included, its own hover holds better"
    )
    attitude_lag: float = quantity(..., 0.01, 2.0, "s", "it leans as it was asked to this late")


class BrakingConstants(Section):
    """How it comes to rest in the pilot's hands."""

    deceleration: float = quantity(
        ..., 0.1, 20.0, "m/s^2", "how hard it can be counted on to brake"
    )
    reaction_time: float = quantity(
        ..., 0.0, 2.0, "s", "from the cause, or the order, to braking: what distances allow for"
    )
    coast_time: float = quantity(
        ..., 0.0, 5.0, "s", "told to stay, it comes to rest this far ahead at its speed"
    )

    def way_to_rest(self, speed: float) -> float:
        """Return how far it flies on from a speed [m/s] when it is to stop [m]."""
        return stopping_distance(speed, self.deceleration, self.reaction_time)


class TakeOffConstants(Section):
    """How its own take-off climbs, which nobody steers, and how one that is given up ends."""

    climb_rate: float = quantity(..., 0.05, 5.0, "m/s", "usual")
    climb_rate_min: float = quantity(..., 0.05, 5.0, "m/s", "the least to count on")
    steerable_height: float = quantity(..., 0.1, 5.0, "m", "it can be steered from here on")
    steerable_height_min: float = quantity(..., 0.1, 5.0, "m", "it may be from here on")
    give_up_time: float = quantity(
        ..., 0.0, 20.0, "s", "one that is given up stands again after this"
    )
    give_up_time_per_height: float = quantity(..., 0.0, 20.0, "s/m", "... and this for every metre")


class LandingConstants(Section):
    """How its own landing goes, which nobody steers."""

    touchdown_time: float = quantity(
        ..., 0.1, 30.0, "s", "from flight height no longer than this until it stands"
    )
    sink_rate: float = quantity(..., 0.05, 3.0, "m/s", "near the floor")
    turn_time: float = quantity(
        ..., 0.0, 5.0, "s", "out of a climb near the floor it still rises for so long ..."
    )
    turn_rise: float = quantity(..., 0.0, 2.0, "m", "... and so far ...")
    turn_sink_rate: float = quantity(..., 0.05, 3.0, "m/s", "... and then sinks slowly")


class BatteryConstants(Section):
    """Its battery."""

    endurance: float = quantity(..., 30.0, 7200.0, "s", "flight time of a full battery, as rated")


class FlowConstants(Section):
    """Its own measurement of its velocity over the ground."""

    delay: float = quantity(..., 0.0, 0.5, "s", "velocity and height of a report are this old")
    noise: float = quantity(..., 0.0, 1.0, "m/s", "white noise of a velocity, one sigma")
    bias: float = quantity(..., 0.0, 0.5, "m/s", "slowly wandering bias, one sigma")
    bias_time: float = quantity(..., 0.1, 1000.0, "s", "correlation time of that bias")


class SonarConstants(Section):
    """Its own measurement of the height above what is below."""

    floor_reading_max: float = quantity(..., 0.0, 1.0, "m", "on the floor it tells less than this")
    range_min: float = quantity(
        ..., 0.0, 1.0, "m", "nothing nearer is measured: a lower height says that something is near"
    )
    beam_radius: float = quantity(
        ..., 0.0, 2.0, "m", "it may find something so far around the drone's middle"
    )
    noise: float = quantity(..., 0.0, 0.5, "m", "a reading may be off by this")
    ping_time: float = quantity(
        ..., 0.001, 1.0, "s", "reports repeat what it measured last; it measures this often"
    )
    climb_rate_max: float = quantity(
        ..., 0.1, 20.0, "m/s", "the drone climbs or sinks no faster: faster is the floor below"
    )


class LinkConstants(Section):
    """When its driver sends commands."""

    interval: float = quantity(..., 0.001, 1.0, "s", "time between commands that suits it")
    interval_min: float = quantity(
        ..., 0.0, 1.0, "s", "a setpoint leaves at once when the last command is this old"
    )
    repeat_after: float = quantity(
        ..., 0.001, 1.0, "s", "the command in force is repeated when no new one came for so long"
    )


class Ability(Enum):
    """What the pilot makes use of where a drone has it, and does without where it has not."""

    HOVER = "a hover of its own"
    HEIGHT = "its own height"
    VELOCITY = "its own velocity"
    ATTITUDE = "its own attitude"
    TILT = "steering by tilt"
    CAMERA = "a camera"


class Airframe(Section):
    """One model of drone.

    Attributes:
        name: as its maker calls it.
        capabilities: what it can do.
        body, response, braking, brake, take_off, landing, battery, link: its constants.
        sonar, flow: its own measurements of height and velocity; None where it has none.
    """

    name: str = Field(min_length=1, max_length=60, description="as its maker calls it")
    usual_address: str = Field(
        default="", max_length=60, description="where one answers in a network of its own"
    )
    capabilities: Capabilities
    body: BodyConstants
    response: ResponseConstants
    braking: BrakingConstants
    brake: BrakeConstants
    take_off: TakeOffConstants
    landing: LandingConstants
    battery: BatteryConstants
    sonar: SonarConstants | None = None
    flow: FlowConstants | None = None
    link: LinkConstants

    @property
    def lacks(self) -> frozenset[Ability]:
        """What others of its kind have, and it has not."""
        able = self.capabilities
        has = {
            Ability.HOVER: able.hovers,
            Ability.HEIGHT: self.sonar is not None,
            Ability.VELOCITY: self.flow is not None,
            Ability.ATTITUDE: OwnMeasurement.ATTITUDE in able.measures,
            Ability.TILT: able.form is SetpointForm.TILT_AND_CLIMB,
            Ability.CAMERA: able.camera is not None,
        }
        return frozenset(ability for ability, is_had in has.items() if not is_had)

    @property
    def lands_itself(self) -> bool:
        """Whether its own landing keeps it level and at rest while nobody tells it where it is.

        So lands what flies velocities or places by loops of its own; one that is steered by tilt
        has no loop for that but its hover.
        """
        is_own = OwnManoeuvre.LANDING in self.capabilities.manoeuvres
        return is_own and self.capabilities.form is not SetpointForm.TILT_AND_CLIMB

    @model_validator(mode="after")
    def _knows_what_it_measures(self) -> Self:
        for part, own in (("sonar", OwnMeasurement.HEIGHT), ("flow", OwnMeasurement.VELOCITY)):
            if (getattr(self, part) is not None) is not (own in self.capabilities.measures):
                raise ValueError(
                    f"{part} and {own.value!r} in capabilities.measures: one without the other;"
                    " allowed: both, or neither"
                )
        return self

    @model_validator(mode="after")
    def _says_what_its_form_needs(self) -> Self:
        form = self.capabilities.form
        for constant in _NEEDED.get(form, ()):
            if getattr(self.response, constant) is None:
                raise ValueError(
                    f"response.{constant} is missing; a drone that is steered by {form.value}"
                    " needs it"
                )
        return self


_NEEDED: dict[SetpointForm, tuple[str, ...]] = {
    SetpointForm.VELOCITY: ("velocity_lag", "speed_max"),
    SetpointForm.POSITION: ("stiffness", "damping", "speed_max"),
}
"""Constants of the response that the pilot needs for a form of setpoints."""


@lru_cache
def installed_models() -> dict[str, str]:
    """Return the packages of drones that others have installed, by the names of their models.

    Each says so by one line, an entry point of the group ``housefly.drones``, and holds
    ``airframe.toml``, ``driver.py`` with a ``Driver``, and ``twin.py`` with a ``Server``.
    """
    # not loaded where all drones are ours: the driver's process is kept small
    from importlib.metadata import entry_points

    return {entry.name: entry.value for entry in entry_points(group="housefly.drones")}


def airframe_names() -> tuple[str, ...]:
    """Return the models that are known: ours by the names of their files, and installed ones."""
    ours = {path.stem for folder in folders for path in folder.glob("*.toml")}
    return tuple(sorted(ours | installed_models().keys()))


def is_model(name: str) -> bool:
    """Return whether there is a model of this name."""
    is_plain = name.isidentifier()
    return is_plain and (_own_file(name) is not None or name in installed_models())


@lru_cache
def airframe_steered(model: str, form: SetpointForm) -> Airframe:
    """Return the airframe of a model that prefers one of its forms of setpoints.

    Raises:
        ValueError: it does not take that form, or has no constants for it.
    """
    airframe = airframe_named(model)
    able = airframe.capabilities
    if form not in able.setpoints:
        told = ", ".join(one.value for one in able.setpoints)
        raise ValueError(f"is {form.value!r}, which {airframe.name} does not take; allowed: {told}")
    others = (one for one in able.setpoints if one is not form)
    able = able.model_copy(update={"setpoints": (form, *others)})
    return Airframe.model_validate(dict(airframe) | {"capabilities": able})


@lru_cache
def airframe_named(model: str) -> Airframe:
    """Return the airframe of a model; raises ConfigError as ``airframe_in`` does."""
    return airframe_in(_own_file(model) or _installed_file(model))


def _own_file(model: str) -> Path | None:
    files = (folder / f"{model}.toml" for folder in folders)
    return next(filter(Path.is_file, files), None)


def _installed_file(model: str) -> Path:
    found = find_spec(installed_models().get(model, "")) if model in installed_models() else None
    if found is None or found.origin is None:
        raise ConfigError("drone.kind", f"is {model!r}; there is no airframe of that name")
    return Path(found.origin).parent / "airframe.toml"


def airframe_in(path: Path) -> Airframe:
    """Read and check an airframe file.

    Raises:
        ConfigError: it cannot be read; a number has no source; or the key, its value, what is
            allowed, and the unit.
    """
    try:
        tree = tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise ConfigError("airframe", f"cannot be read: {error}", str(path)) from error
    values = _sourced(tree, (), path, is_sourced=False)
    try:
        return Airframe.model_validate(values)
    except ValidationError as error:
        # not loaded where all is well: the driver's process is kept small
        from housefly.config.validation import dotted, explain

        first = error.errors()[0]
        raise ConfigError(dotted(first["loc"]), explain(first, Airframe), str(path)) from error


def _sourced(tree: dict[str, Any], at: tuple[str, ...], path: Path, *, is_sourced: bool) -> Any:
    """Return a table without its sources, once each of its numbers has one."""
    if tree.keys() == _SOURCED:
        _check_source(tree["source"], at, path)
        return tree["value"]
    if "source" in tree:
        _check_source(tree["source"], at, path)
        is_sourced = True
    values: dict[str, Any] = {}
    for key, value in tree.items():
        if key == "source":
            continue
        if isinstance(value, dict):
            value = _sourced(value, (*at, key), path, is_sourced=is_sourced)
        elif not is_sourced and isinstance(value, int | float):
            raise ConfigError(
                ".".join((*at, key)),
                f'has no source; allowed: {{ value = {value}, source = "where it is from" }}, or'
                " one source for its whole table",
                str(path),
            )
        values[key] = value
    return values


def _check_source(source: Any, at: tuple[str, ...], path: Path) -> None:
    if not isinstance(source, str) or not source.strip():
        key = ".".join((*at, "source"))
        raise ConfigError(
            key, f"is {source!r}; allowed: words that say where it is from", str(path)
        )
