"""The pilot's chain for one drone of the batch, made of the compiled functions that the live pilot
calls.

    track -> accept -> steer -> judge

Only the errand is left out: there is one task, the drone flies from the beginning, and a landing
    ends the flight.
"""

from __future__ import annotations

from math import inf, isfinite, isnan, nan, sqrt
from typing import Any, NamedTuple

from housefly.lab.experiments.belief import Estimated
from housefly.lab.experiments.route import PATH, STEP, Route
from housefly.numeric import compiled, wrapped
from housefly.pilot.behavior.acceptor import next_state, printed_conditions, steady_conditions
from housefly.pilot.behavior.cells import cell_after, cell_target, paper_heading
from housefly.pilot.behavior.nose import YAW_SLEW, Nose, nose_after
from housefly.pilot.behavior.ride import Ride, Target, headed, ridden, target_of
from housefly.pilot.control.laws import acceleration
from housefly.pilot.control.steering import Aim, Asked, Gains, Where, steered, steered_by_paper
from housefly.pilot.estimation.horizon import NO_TIME
from housefly.pilot.safety.limits import limited, too_old

HOVER, PATH_TRACKING = 0, 3
"""States of the acceptor in which the reference moves on."""
NOMINAL, LEVEL, LAND = 0, 1, 2
"""What the gate found."""


class Hold(NamedTuple):
    """A place [m] and a heading [rad] to keep."""

    x: float
    y: float
    yaw: float


class Course(NamedTuple):
    """What the pilot remembers besides its belief.

    Attributes:
        begun: the task has begun.
        hold: where the drone waits before, on a path where it was first seen; its heading is nan
            before anything was seen.
        ride: mode default's place on the path.
        cell, cell_yaw: mode paper's waypoint and heading [rad].
        nose: wanted headings.
        state, since: of the acceptor, and when it was entered [s].
        safety: what the gate found last.
    """

    begun: bool
    hold: Hold
    ride: Ride
    cell: int
    cell_yaw: float
    nose: Nose
    state: int
    since: float
    safety: int


@compiled
def course_begun() -> Course:
    """Return the course before anything was seen."""
    return Course(
        False,
        Hold(0.0, 0.0, nan),
        Ride(0.0, 0.0, 0.0, 0, nan),
        0,
        0.0,
        Nose(0.0, nan),
        HOVER,
        0.0,
        NOMINAL,
    )


@compiled
def remembering(c: Course, safety: int) -> Course:
    """Return the course with what the gate found."""
    return Course(c.begun, c.hold, c.ride, c.cell, c.cell_yaw, c.nose, c.state, c.since, safety)


@compiled
def standing(route: Route, waypoint: int) -> Target:
    """Return the reference that stands on a waypoint with the heading of the start."""
    return Target(
        route.cells[waypoint, 0],
        route.cells[waypoint, 1],
        0.0,
        0.0,
        0.0,
        0.0,
        route.yaw,
        waypoint,
        True,
    )


@compiled
def gains_of_case(case: Any) -> Gains:
    """Return what the laws need of one case."""
    return Gains(
        case.alpha,
        case.beta,
        case.height_gain,
        case.yaw_gain,
        case.tilt_max,
        case.vertical_speed_max,
        case.yaw_rate_max,
        case.model_gain,
        case.model_drag,
        case.model_delay,
        case.wrap_yaw > 0.5,
    )


@compiled
def tracked(
    c: Course, route: Route, case: Any, here: Estimated, now: float, dt: float
) -> tuple[Course, Target]:
    """Return the course with its reference moved on by dt [s], and the reference."""
    if isnan(c.hold.yaw):
        c = _found(c, route, here)
    if not c.begun and now >= route.settle - NO_TIME:
        heading = paper_heading(here.yaw)
        c = Course(True, c.hold, c.ride, 0, heading, c.nose, c.state, c.since, c.safety)
    if not c.begun:
        return c, Target(c.hold.x, c.hold.y, 0.0, 0.0, 0.0, 0.0, c.hold.yaw, 0, True)
    if route.task != PATH:
        return c, standing(route, len(route.cells) - 1 if route.task == STEP else 0)
    if case.mode > 0:
        cell, yaw = cell_after(
            c.cell, c.cell_yaw, route.cells, here.x, here.y, case.epsilon_position
        )
        moved = Course(True, c.hold, c.ride, cell, yaw, c.nose, c.state, c.since, c.safety)
        return moved, cell_target(cell, yaw, route.cells)
    moving = (c.state == PATH_TRACKING or c.state == HOVER) and c.safety == NOMINAL
    ride = headed(ridden(c.ride, route.way, case.speed, here.x, here.y, moving, dt), route.way)
    return Course(
        True, c.hold, ride, c.cell, c.cell_yaw, c.nose, c.state, c.since, c.safety
    ), target_of(ride, route.way)


@compiled
def _found(c: Course, route: Route, here: Estimated) -> Course:
    """Return the course of a drone just found in the air: on a path it waits right there, as the
    live pilot does.
    """
    hold = Hold(route.cells[0, 0], route.cells[0, 1], route.yaw)
    if route.task == PATH:
        hold = Hold(here.x, here.y, here.yaw)
    return Course(c.begun, hold, c.ride, c.cell, c.cell_yaw, c.nose, c.state, c.since, c.safety)


@compiled
def accepted(
    c: Course, route: Route, case: Any, here: Estimated, target: Target, now: float, dt: float
) -> Course:
    """Return the course with the wanted heading and the acceptor's state brought up to date."""
    follows = c.begun and route.task == PATH
    is_paper = case.mode > 0
    wish = (
        route.arrival_yaw
        if follows and target.finished and not is_paper and isfinite(route.arrival_yaw)
        else target.yaw
    )
    nose = nose_after(c.nose, wish, here.yaw, inf if is_paper else YAW_SLEW * dt)
    goal = len(route.cells) - 1
    x, y = target.x, target.y
    if follows and not is_paper:
        x, y = route.cells[goal, 0], route.cells[goal, 1]
    off = sqrt((here.x - x) ** 2 + (here.y - y) ** 2)
    turn = here.yaw - nose.target
    turn = wrapped(turn) if case.wrap_yaw > 0.5 else turn
    eps1, eps2, eps3 = case.epsilon_height, case.epsilon_yaw, case.epsilon_position
    rise = here.z - route.height
    if is_paper:
        conditions = printed_conditions(rise, turn, off, eps1, eps2, eps3)
    else:
        conditions = steady_conditions(c.state, rise, turn, off, eps1, eps2, eps3)
    state = next_state(c.state, c.since, conditions, now, case.dwell)
    since = c.since if state == c.state else now
    return Course(c.begun, c.hold, c.ride, c.cell, c.cell_yaw, nose, state, since, c.safety)


@compiled
def asked_of(
    c: Course, target: Target, where: Where, height: float, gains: Gains, mode: int
) -> Asked:
    """Return what control asks."""
    aim = Aim(
        (target.x, target.y),
        (target.vx, target.vy),
        (target.ax, target.ay),
        height,
        c.nose.reference,
    )
    return steered_by_paper(c.state, aim, where, gains) if mode > 0 else steered(aim, where, gains)


@compiled
def judged(asked: Asked, flying: bool, age: float, case: Any, order: Any) -> int:
    """Write into an order what may leave the gate, and return what the gate found.

    Args:
        asked: by control.
        flying: control flies; else it asks for the drone's own hover.
        age: of the pose [s].
        case: limits.
        order: record to write to.
    """
    found = LEVEL if too_old(age, case.pose_age_level) else NOMINAL
    found = LAND if too_old(age, case.pose_age_land) else found
    is_number = (
        isfinite(asked.theta)
        and isfinite(asked.phi)
        and isfinite(asked.vz)
        and isfinite(asked.yaw_rate)
    )
    found = LEVEL if found == NOMINAL and not is_number else found
    order.flying = 1 if flying and found == NOMINAL else 0
    order.theta = order.phi = order.vz = order.yaw_rate = 0.0
    if order.flying > 0:
        order.theta, order.phi, order.vz, order.yaw_rate = limited(
            asked.theta,
            asked.phi,
            asked.vz,
            asked.yaw_rate,
            case.tilt_max,
            case.vertical_speed_max,
            case.yaw_rate_max,
        )
    return found


@compiled
def pushed_by(order: Any, yaw: float) -> tuple[float, float]:
    """Return the world acceleration [m/s^2] that an order asks at a heading [rad]."""
    return acceleration(order.theta, order.phi, yaw)
