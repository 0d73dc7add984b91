"""A recorded flight as arrays: one row per step, one per sighting."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from math import hypot, nan

import numpy as np
from numpy.typing import NDArray

from housefly.messages import (
    Action,
    Behavior,
    DroneStatus,
    Event,
    Path,
    Phase,
    PilotStep,
    PlannedTrajectory,
    SafetyMode,
    TrajectoryPoint,
)
from housefly.messages.steering import SetpointForm, numbers_of
from housefly.numeric import FloatArray

IntArray = NDArray[np.int64]

PHASES, BEHAVIORS, SAFETY_MODES, STATUSES = (
    tuple(Phase),
    tuple(Behavior),
    tuple(SafetyMode),
    tuple(DroneStatus),
)
"""Meaning of the indices in the arrays of states."""

_NOWHERE = (nan, nan, nan)


@dataclass(frozen=True, slots=True, eq=False)
class FlightSeries:
    """One flight; unknown values are nan, states are indices into the tuples of this module.

    Attributes:
        time: of each step [s], shape (n,).
        estimate, reference: x, y, z [m] and yaw [rad], shape (n, 4).
        setpoint: its numbers in the order of its fields, shape (n, 4).
        form: of the setpoints.
        phase, behavior, safety: states, shape (n,).
        status: the drone's own state, shape (n,).
        battery: charge 0 to 1, shape (n,).
        pose_age, telemetry_age: [s], shape (n,).
        path: index into ``paths`` of the path in force, or -1, shape (n,).
        paths: each planned path once, in order of use.
        planned: each of them in space, or nothing where it is in the plane.
        sighting_step: step that received each sighting of the drone, shape (m,).
        sighting_time: when each was captured [s], shape (m,).
        sighting: x, y, z [m], shape (m, 3).
        goal_name: of each step.
        events: all of them, in order.
        missing_steps: gaps in the step numbers.
        speed: of the estimate [m/s], shape (n,).
        position_std: one-sigma uncertainty in x and y [m], shape (n,).
    """

    time: FloatArray
    estimate: FloatArray
    reference: FloatArray
    setpoint: FloatArray
    phase: IntArray
    behavior: IntArray
    safety: IntArray
    status: IntArray
    battery: FloatArray
    pose_age: FloatArray
    telemetry_age: FloatArray
    path: IntArray
    paths: tuple[Path, ...]
    planned: tuple[tuple[TrajectoryPoint, ...], ...]
    sighting_step: IntArray
    sighting_time: FloatArray
    sighting: FloatArray
    goal_name: tuple[str, ...]
    events: tuple[Event, ...]
    missing_steps: int
    speed: FloatArray
    position_std: FloatArray
    form: SetpointForm = SetpointForm.TILT_AND_CLIMB

    def during(self, *phases: Phase) -> NDArray[np.bool_]:
        """Return which steps are in one of the phases, shape (n,)."""
        return np.isin(self.phase, [PHASES.index(phase) for phase in phases])


def collect(
    steps: Iterable[PilotStep], body: str, planned: Sequence[PlannedTrajectory] = ()
) -> FlightSeries:
    """Return the arrays of a flight.

    Args:
        steps: in order.
        body: name of the drone among the tracked bodies.
        planned: trajectories that were planned in space, in any order.
    """
    rows: list[tuple[float, ...]] = []
    seen: list[tuple[float, ...]] = []
    paths: list[Path] = []
    events: list[Event] = []
    goals: list[str] = []
    missing, last, form = 0, None, SetpointForm.TILT_AND_CLIMB
    for index, step in enumerate(steps):
        if last is not None:
            missing += max(0, step.sequence - last - 1)
        last = step.sequence
        if step.outputs.path is not None and (not paths or paths[-1] != step.outputs.path):
            paths.append(step.outputs.path)
        rows.append(_row(step, len(paths) - 1 if step.outputs.path is not None else -1))
        for sighting in step.inputs.sightings:
            if sighting.body == body:
                seen.append((index, sighting.captured_at, *sighting.pose.position))
        events.extend(step.outputs.events)
        goals.append(step.outputs.goal_name)
        if step.outputs.command.action is Action.FLY:
            form = step.outputs.command.form
    in_space = {tuple(point.position[:2] for point in one.points): one.points for one in planned}
    known = tuple(in_space.get(path.waypoints, ()) for path in paths)
    return replace(_series(rows, seen, paths, known, events, goals, missing), form=form)


def _row(step: PilotStep, path: int) -> tuple[float, ...]:
    outputs, telemetry = step.outputs, step.inputs.telemetry
    estimate, reference = outputs.estimate, outputs.reference
    return (
        step.now,
        *((*estimate.position, estimate.yaw) if estimate else (*_NOWHERE, nan)),
        *((*reference.position, reference.yaw) if reference else (*_NOWHERE, nan)),
        *numbers_of(outputs.command.asked),
        PHASES.index(outputs.phase),
        BEHAVIORS.index(outputs.behavior),
        SAFETY_MODES.index(outputs.safety),
        STATUSES.index(telemetry.status if telemetry else DroneStatus.UNKNOWN),
        telemetry.battery if telemetry else nan,
        estimate.pose_age if estimate else nan,
        step.now - telemetry.received_at if telemetry else nan,
        path,
        hypot(*estimate.velocity) if estimate else nan,
        estimate.position_std if estimate else nan,
    )


def _series(
    rows: list[tuple[float, ...]],
    seen: list[tuple[float, ...]],
    paths: list[Path],
    planned: tuple[tuple[TrajectoryPoint, ...], ...],
    events: list[Event],
    goals: list[str],
    missing: int,
) -> FlightSeries:
    table = np.array(rows, dtype=np.float64).reshape(-1, 23)
    sightings = np.array(seen, dtype=np.float64).reshape(-1, 5)
    states = table[:, 13:17].astype(np.int64)
    return FlightSeries(
        time=table[:, 0],
        estimate=table[:, 1:5],
        reference=table[:, 5:9],
        setpoint=table[:, 9:13],
        phase=states[:, 0],
        behavior=states[:, 1],
        safety=states[:, 2],
        status=states[:, 3],
        battery=table[:, 17],
        pose_age=table[:, 18],
        telemetry_age=table[:, 19],
        path=table[:, 20].astype(np.int64),
        paths=tuple(paths),
        planned=planned,
        sighting_step=sightings[:, 0].astype(np.int64),
        sighting_time=sightings[:, 1],
        sighting=sightings[:, 2:5],
        goal_name=tuple(goals),
        events=tuple(events),
        missing_steps=missing,
        speed=table[:, 21],
        position_std=table[:, 22],
    )
