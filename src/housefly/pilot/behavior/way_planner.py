"""From a mission to the task of flying there: in the plane or in space, from rest or in flight."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import dist, hypot, nan

import numpy as np

from housefly.geometry import Vec2, Vec3
from housefly.messages.flight import OrderOutcome
from housefly.messages.steering import PlanAnswer
from housefly.messages.words import Words, figure
from housefly.numeric import FloatArray
from housefly.pilot.behavior.braking import REFERENCE_BRAKING, coasted
from housefly.pilot.behavior.mission import (
    Mission,
    Refused,
    TrackingTask,
    TrajectoryReference,
    VehicleStatus,
)
from housefly.pilot.behavior.navigator import Navigator
from housefly.pilot.behavior.path_profile import path_profile
from housefly.pilot.behavior.path_progress import LAG_MAX
from housefly.pilot.behavior.trajectory_profile import trajectory_path, trajectory_profile
from housefly.pilot.planning.trajectory.kinematic_state import TICK, KinematicState
from housefly.pilot.planning.trajectory.time_scale import stopping_rows

_AT_REST = 0.15
"""A drone slower than this [m/s] sets off from rest."""


@dataclass(frozen=True, slots=True, eq=False)
class _Departure:
    """A state that a trajectory may set off from.

    Attributes:
        state: place, velocity, acceleration.
        before: what is flown until then, shape (n, 9); without rows it sets off at once.
    """

    state: KinematicState
    before: FloatArray


NOWHERE_TO_GO = Words("there is nowhere to go")
"""Why a drone without a goal plans no way."""


def refusal_of(answer: PlanAnswer) -> Refused:
    """Return in words why there is no way."""
    if answer.suggestion is None:
        return Refused(OrderOutcome.NO_WAY, answer.reason)
    x, y = answer.suggestion
    words = Words(
        "{why}; nearest free place: ({x}, {y}) m",
        why=answer.reason,
        x=figure(x, ".2f"),
        y=figure(y, ".2f"),
    )
    return Refused(OrderOutcome.NO_WAY, words)


def planned_task(
    navigator: Navigator,
    mission: Mission,
    task: TrackingTask,
    vehicle: VehicleStatus,
    coast_time: float,
) -> TrackingTask | Refused | None:
    """Return the task of flying to the goal of a mission; None when it has none.

    Args:
        navigator: knows the room.
        mission: what is to be done.
        task: under way.
        vehicle: where the drone is.
        coast_time: told to stay, it comes to rest this far ahead at its speed [s].
    """
    if mission.goal is None:
        return None
    if vehicle.place is None:
        return Refused(OrderOutcome.UNTRACKED, Words("tracking has not seen the drone yet"))
    if navigator.in_space:
        return _task_in_space(navigator, mission, mission.goal, task, vehicle, coast_time)
    answer = navigator.route(vehicle.place, mission.goal)
    if answer.path is None:
        return refusal_of(answer)
    return TrackingTask(path_profile(answer.path.waypoints), answer.path, answer.duration)


def _task_in_space(
    navigator: Navigator,
    mission: Mission,
    goal: Vec2,
    task: TrackingTask,
    vehicle: VehicleStatus,
    coast_time: float,
) -> TrackingTask | Refused:
    assert vehicle.estimate is not None
    arrival_yaw = mission.arrival_yaw(goal)
    yaw = vehicle.reference.yaw if vehicle.reference else vehicle.estimate.yaw
    refused = Refused(OrderOutcome.NO_WAY, NOWHERE_TO_GO)
    for departure in _departures(task, vehicle, coast_time):
        lead = TICK * len(departure.before)
        answer = navigator.way(departure.state, goal, yaw, lead)
        if answer.trajectory is None:
            where = answer.suggestion[:2] if answer.suggestion else None
            refused = refusal_of(PlanAnswer(goal, goal, None, answer.reason, where))
            continue
        rows = np.concatenate((departure.before, answer.trajectory.rows))
        clearance = answer.trajectory.clearance + navigator.hull_radius
        profile = trajectory_profile(
            rows, yaw, nan if arrival_yaw is None else arrival_yaw, answer.trajectory.yaws
        )
        return TrackingTask(
            profile=profile,
            path=trajectory_path(rows, clearance),
            duration=TICK * (len(rows) - 1),
            comfort=answer.comfort,
            arrival=lead + answer.arrival,
        )
    return refused


def departure_state(
    task: TrackingTask, vehicle: VehicleStatus, coast_time: float
) -> KinematicState:
    """Return the state that a new motion goes on from: the reference as it moves, else the drone.

    Args:
        task: under way.
        vehicle: where the drone is; it was seen.
        coast_time: of the drone [s].
    """
    return next(_departures(task, vehicle, coast_time)).state


def _departures(
    task: TrackingTask, vehicle: VehicleStatus, coast_time: float
) -> Iterator[_Departure]:
    """Yield where a new trajectory may begin, the best first.

    A reference that moves goes on without a jump, else it stops on its own curve before; where
    none is flown, or the drone is far from it, the drone itself counts.
    """
    assert vehicle.estimate is not None
    place, velocity = vehicle.estimate.position, vehicle.estimate.velocity
    reference, profile = vehicle.reference, task.profile
    if reference is not None and profile is not None and _off(reference, place) <= LAG_MAX:
        target = reference.target
        moving = _state(
            (target.x, target.y, target.z),
            (target.vx, target.vy, target.vz),
            (target.ax, target.ay, target.az),
        )
        if not moving.velocity.any():
            yield _Departure(_resting((target.x, target.y, target.z)), _NOTHING)
            return
        yield _Departure(moving, _NOTHING)
        rows = stopping_rows(reference.scale, profile.motion, TICK, REFERENCE_BRAKING)
        yield _Departure(_resting(rows[-1, :3].tolist()), rows[:-1])
        return
    if hypot(*velocity) >= _AT_REST:
        yield _Departure(_state(place, velocity, (0.0, 0.0, 0.0)), _NOTHING)
        rest = coasted(place[:2], velocity[:2], coast_time)
        yield _Departure(_resting((*rest, place[2])), _NOTHING)
    yield _Departure(_resting(place), _NOTHING)


_NOTHING: FloatArray = np.zeros((0, 9))


def _off(reference: TrajectoryReference, place: Vec3) -> float:
    return dist((reference.target.x, reference.target.y, reference.target.z), place)


def _state(place: Vec3, velocity: Vec3, acceleration: Vec3) -> KinematicState:
    return KinematicState(np.array(place), np.array(velocity), np.array(acceleration))


def _resting(place: Vec3) -> KinematicState:
    return _state(place, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
