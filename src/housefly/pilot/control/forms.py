"""What control wants as a drone of another form is asked for it: a velocity, or a place.

Such a drone closes one loop more by itself. Asked for w it accelerates by p (w - v), asked for a
place r by k (r - x) - c v: to the estimator it is a drone of drag p or c that is asked for an
acceleration u = p w or k (r - x). So control and estimator are those of every drone, with another
drag; here u becomes w or r, within what the gate allows, and back.
"""

from __future__ import annotations

from enum import IntEnum
from math import cos, inf, sin, sqrt
from typing import NamedTuple

from housefly.numeric import compiled
from housefly.pilot.estimation.estimator_state import ControlState


class FormCode(IntEnum):
    """The forms as compiled code knows them."""

    TILT_AND_CLIMB = 0
    VELOCITY = 1
    POSITION = 2


class FormModel(NamedTuple):
    """How a drone answers a setpoint of its form, and what may be asked of it.

    Attributes:
        form: a ``FormCode``.
        gain: achieved over commanded.
        pull: what brings it to rest where nothing is asked: drag, p or c [1/s].
        stiffness: k [1/s^2].
        climb_pull: the same as ``pull``, upwards [1/s].
        speed_max: fastest flight that may be asked for [m/s].
        x_min, y_min, x_max, y_max, z_max: no place beyond is asked for [m].
    """

    form: int = FormCode.TILT_AND_CLIMB.value
    gain: float = 1.0
    pull: float = 0.0
    stiffness: float = 1.0
    climb_pull: float = 0.0
    speed_max: float = inf
    x_min: float = -inf
    y_min: float = -inf
    x_max: float = inf
    y_max: float = inf
    z_max: float = inf


class FormedCommand(NamedTuple):
    """What is asked of a drone that is not steered by tilt; zeros where it is.

    Attributes:
        flown: there is something to ask.
        forward, left: velocity along the axes of the level drone [m/s].
        x, y, z: place in the world [m].
        ux, uy: the acceleration u that the estimator is told [m/s^2].
    """

    flown: bool
    forward: float
    left: float
    x: float
    y: float
    z: float
    ux: float
    uy: float


TILTS = FormModel()
"""A drone that is steered by tilt and climb."""
NOT_FORMED = FormedCommand(False, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@compiled
def velocity_asked(ax: float, ay: float, heading: float, model: FormModel) -> FormedCommand:
    """Return the velocity that accelerates a drone as wanted, no faster than allowed.

    Args:
        ax: wanted acceleration, and what holds the drone back, along x [m/s^2].
        ay: the same along y.
        heading: of the drone when it obeys [rad].
        model: of the drone.
    """
    vx, vy = _shortened(
        ax / (model.pull * model.gain), ay / (model.pull * model.gain), model.speed_max
    )
    c, s = cos(heading), sin(heading)
    return FormedCommand(
        flown=True,
        forward=c * vx + s * vy,
        left=c * vy - s * vx,
        x=0.0,
        y=0.0,
        z=0.0,
        ux=model.pull * vx,
        uy=model.pull * vy,
    )


@compiled
def place_asked(
    ax: float, ay: float, climb: float, ahead: ControlState, model: FormModel
) -> FormedCommand:
    """Return the place that accelerates a drone as wanted, within the room and no faster.

    Args:
        ax: wanted acceleration, and what holds the drone back, along x [m/s^2].
        ay: the same along y.
        climb: wanted climb rate [m/s].
        ahead: of the drone when it obeys.
        model: of the drone.
    """
    reach = model.speed_max * model.pull / model.stiffness
    rx, ry = _shortened(
        ax / (model.stiffness * model.gain), ay / (model.stiffness * model.gain), reach
    )
    here_x, here_y = ahead.position
    x = min(max(here_x + rx, model.x_min), model.x_max)
    y = min(max(here_y + ry, model.y_min), model.y_max)
    rise = climb * model.climb_pull / model.stiffness
    return FormedCommand(
        flown=True,
        forward=0.0,
        left=0.0,
        x=x,
        y=y,
        z=min(ahead.height + rise, model.z_max),
        ux=model.stiffness * (x - here_x),
        uy=model.stiffness * (y - here_y),
    )


@compiled
def _shortened(x: float, y: float, bound: float) -> tuple[float, float]:
    length = sqrt(x * x + y * y)
    if length <= bound:
        return x, y
    return x * bound / length, y * bound / length
