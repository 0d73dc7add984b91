"""Several drones of one site: what all have, what a model has, and what each has of its own.

As in Crazyswarm, the nearer word counts: ``[[drones]]`` before ``[models.NAME]`` before
``[drone]``, and what none of them says is the airframe's.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import combinations
from math import hypot
from typing import Any

from pydantic import Field, SerializerFunctionWrapHandler, model_serializer

from housefly.config.airframe import airframe_names
from housefly.config.drone import DRONE_NAME, NAME_PATTERN, DroneConfig
from housefly.config.text import did_you_mean

RESERVED_NAMES = frozenset({"all", "any"})
"""What orders call every drone, and whichever is free."""


class DroneModelConfig(DroneConfig):
    """What all drones of a model have: any key of `[drone]`."""

    @model_serializer(mode="wrap")
    def _as_given(self, dump: SerializerFunctionWrapHandler) -> dict[str, Any]:
        """What is left out stays so, for others to give."""
        return {key: value for key, value in dump(self).items() if key in self.model_fields_set}


class NamedDroneConfig(DroneModelConfig):
    """One of several drones: any key of `[drone]`; what it leaves out its model gives, or that."""

    # A key that was left out reads as its default here: what holds, only drone_of knows.
    name: str = Field(
        pattern=NAME_PATTERN,
        description="what people and programs call it: a-z, 0-9, - and _, a letter first",
    )
    model: str = Field(
        default="", description="a table [models.NAME] of this file, or an airframe; gives the kind"
    )
    body: str = Field(
        default="", max_length=100, description="its name among the tracked bodies; left out: name"
    )

    @property
    def tracked_body(self) -> str:
        """Its name among the tracked bodies."""
        return self.body or self.name


def drone_of(
    own: NamedDroneConfig, models: Mapping[str, DroneModelConfig], all_have: DroneConfig
) -> DroneConfig:
    """Return one of several drones with all that it has.

    Args:
        own: its table.
        models: of the site, by name.
        all_have: what ``[drone]`` says.
    """
    kind = {"kind": own.model} if own.model in airframe_names() else {}
    model = models[own.model].model_dump() if own.model in models else {}
    named = own.model_dump(exclude={"model", "body"})
    return DroneConfig(**(_given(all_have) | kind | model | named))


def drone_in_tree(site: Mapping[str, Any], name: str) -> DroneConfig:
    """Return a drone of a checked site that was written as JSON, without reading all of it.

    Raises:
        KeyError: there is none of this name.
    """
    all_have = DroneConfig(**site["drone"])
    if not site["drones"]:
        return all_have
    models = {key: DroneModelConfig(**model) for key, model in site["models"].items()}
    own = {table["name"]: NamedDroneConfig(**table) for table in site["drones"]}
    return drone_of(own[name], models, all_have)


def resolved(
    own: NamedDroneConfig, models: Mapping[str, DroneModelConfig], all_have: DroneConfig
) -> NamedDroneConfig:
    """Return the table of a drone with every key in it, so that it needs no others."""
    whole = drone_of(own, models, all_have).model_dump()
    return NamedDroneConfig(**whole, model="", body=own.tracked_body)


def _given(drone: DroneConfig) -> dict[str, Any]:
    """Return what a drone does not have by default; constants of its airframe are its kind's."""
    plain = DroneConfig(kind=drone.kind).model_dump()
    plain |= {"kind": DroneConfig().kind}
    return {key: value for key, value in drone.model_dump().items() if value != plain[key]}


def check_names(
    drones: tuple[NamedDroneConfig, ...],
    models: Mapping[str, DroneModelConfig],
    taken: Iterable[str],
    in_focus: str,
) -> None:
    """Raise ValueError for names that are used twice, reserved, or unknown.

    Args:
        drones: of the site.
        models: likewise, by name.
        taken: bodies and names of people and furniture.
        in_focus: the name of the one drone that a site was made for.
    """
    names = [drone.name for drone in drones]
    for number, drone in enumerate(drones):
        if drone.name in RESERVED_NAMES:
            raise ValueError(
                f"drones.{number}.name: {drone.name!r} is what orders call"
                f" {'every drone' if drone.name == 'all' else 'whichever is free'}; choose another"
            )
        if drone.model and drone.model not in models and drone.model not in airframe_names():
            known = [*models, *airframe_names()]
            raise ValueError(
                f"drones.{number}.model: there is neither a table [models.{drone.model}] nor such"
                f" an airframe{did_you_mean(drone.model, known)} (there is: {', '.join(known)})"
            )
    for one, other in combinations(drones, 2):
        if one.name == other.name:
            raise ValueError(f"drones: two are called {one.name!r}; give each a name of its own")
        if one.tracked_body == other.tracked_body:
            raise ValueError(
                f"drones: {one.name!r} and {other.name!r} have the same body"
                f" ({one.tracked_body!r}); give each a body of its own in the tracking system"
            )
    clashes = set(taken) & {*names, *(drone.tracked_body for drone in drones)}
    if clashes:
        raise ValueError(
            f"drones: {min(clashes)!r} is a person's or a piece of furniture's name or body, too;"
            " choose another"
        )
    if drones and in_focus != DRONE_NAME and in_focus not in names:
        raise ValueError(
            f"drone.name ({in_focus}) is none of [[drones]] ({', '.join(names)}); leave it out"
        )


def check_apart(drones: Iterable[DroneConfig], distance: float) -> None:
    """Raise ValueError where two drones share an address, or stand too near to each other.

    Args:
        drones: those that are flown, with all that they have.
        distance: that they keep from what moves [m].
    """
    for one, other in combinations([drone for drone in drones if drone.enabled], 2):
        if (one.address, one.interface) == (other.address, other.interface):
            raise ValueError(
                f"drones: {one.name!r} and {other.name!r} have the same address ({one.address});"
                " each drone answers at its own: give each an address"
            )
        if one.pad is None or other.pad is None:
            if one.pad is other.pad:
                raise ValueError(
                    f"drones: {one.name!r} and {other.name!r} both stand on the room's pad; give"
                    " one of them a pad: x, y [m] and heading [rad]"
                )
            continue
        check_pads(one, other, (one.pad, other.pad), distance)


def check_pads(
    one: DroneConfig,
    other: DroneConfig,
    pads: tuple[tuple[float, float, float], tuple[float, float, float]],
    distance: float,
) -> None:
    """Raise ValueError where two drones on their pads are nearer than they may fly.

    Args:
        one: a drone.
        other: another.
        pads: of both: x, y [m] and heading [rad].
        distance: that they keep from what moves [m].
    """
    (x, y, _), (other_x, other_y, _) = pads
    apart, needed = hypot(x - other_x, y - other_y), one.reach + other.reach + distance
    if apart < needed:
        raise ValueError(
            f"drones: the pads of {one.name!r} and {other.name!r} are {apart:.2f} m apart; allowed:"
            f" {needed:.2f} m or more (both hulls, and people.min_distance between them)"
        )
