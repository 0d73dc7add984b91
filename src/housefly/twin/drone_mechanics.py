"""What pushes and what resists in a simulated drone, by its airframe."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.config.airframe import Airframe, airframe_named
from housefly.config.drone import DroneConfig
from housefly.geometry import Vec3

_USUAL: str = DroneConfig.model_fields["kind"].default

_ROUNDING = 1e-6
"""Models are written with nine digits."""


@dataclass(frozen=True, slots=True)
class Mechanics:
    """One model as a rigid body with four motors.

    Attributes:
        mass: [kg].
        inertia: principal moments [kg m^2].
        thrust_max: of all motors together [N].
        rotor_arm: from each motor to the roll and pitch axes [m].
        standing_height: of its origin when it stands [m].
    """

    mass: float
    inertia: Vec3
    thrust_max: float
    rotor_arm: float
    standing_height: float


def mechanics_of(airframe: Airframe) -> Mechanics:
    """Return the mechanics of a model; what it leaves out is the usual drone's, for its mass."""
    body, usual = airframe.body, airframe_named(_USUAL).body
    share = body.mass / usual.mass
    tilt = body.inertia_tilt or share * (usual.inertia_tilt or 0.0)
    # MuJoCo refuses a moment that is more than both others together, however it is rounded.
    most = 2.0 * tilt * (1.0 - _ROUNDING)
    turn = body.inertia_turn or min(share * (usual.inertia_turn or 0.0), most)
    return Mechanics(
        mass=body.mass,
        inertia=(tilt, tilt, turn),
        thrust_max=body.thrust_max or share * (usual.thrust_max or 0.0),
        rotor_arm=body.rotor_arm or usual.rotor_arm or 0.0,
        standing_height=body.standing_height,
    )


USUAL = mechanics_of(airframe_named(_USUAL))
"""Of the model that a site has which names none."""
