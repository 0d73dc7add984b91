"""The pilot's steps of one flight as columns, for the figures."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from housefly.geometry import Vec2, euler_from_quaternion
from housefly.messages import Action, Phase, PilotStep
from housefly.numeric import FloatArray
from housefly.record.truth import TrueFlight


@dataclass(frozen=True, slots=True, eq=False)
class FlightTracks:
    """The steps of one flight and its columns; times count from the first step [s].

    Attributes:
        steps: of the pilot.
        at: of each step [s].
        estimate: x, y, vx, vy by the filter, shape (n, 4); nan before the first sighting.
        reference: x, y wanted, shape (n, 2); nan where nothing was.
        asked: pitch and roll that left the gate [rad], shape (n, 2); 0 where the drone hovers by
            itself.
        reached: pitch and roll that the drone reports [rad], shape (n, 2).
        seen_at: when frames were taken [s].
        seen: x, y, z that tracking saw, shape (m, 3).
        seen_tilt: pitch and roll that tracking saw [rad], shape (m, 2).
        true_at: when the truth was sampled, shape (k,); empty where it is not known.
        true: x, y, z where the drone really was, shape (k, 3).
    """

    steps: tuple[PilotStep, ...]
    at: FloatArray
    estimate: FloatArray
    reference: FloatArray
    asked: FloatArray
    reached: FloatArray
    seen_at: FloatArray
    seen: FloatArray
    seen_tilt: FloatArray
    true_at: FloatArray
    true: FloatArray

    @property
    def path(self) -> tuple[Vec2, ...]:
        """The planned path to the goal."""
        return next(
            (
                s.outputs.path.waypoints
                for s in self.steps
                if s.outputs.path and s.outputs.phase is Phase.OUTBOUND
            ),
            (),
        )

    def during(self, *phases: Phase) -> NDArray[np.bool_]:
        """Return which steps belong to these phases."""
        return np.array([step.outputs.phase in phases for step in self.steps])

    def true_during(self, *phases: Phase) -> NDArray[np.bool_]:
        """Return which samples of the truth belong to these phases."""
        inside = self.during(*phases)
        places = np.clip(np.searchsorted(self.at, self.true_at), 0, len(self.at) - 1)
        return np.asarray(inside[places])


def flight_tracks(
    steps: Sequence[PilotStep], body: str, truth: TrueFlight | None = None
) -> FlightTracks:
    """Return the columns of a flight.

    Args:
        steps: of the pilot.
        body: the drone's name in the tracking.
        truth: where the drone really was, on the clock of the steps.
    """
    start = steps[0].now
    sightings = [s for step in steps for s in step.inputs.sightings if s.body == body]
    tilts = np.array([euler_from_quaternion(s.pose.orientation) for s in sightings]).reshape(-1, 3)
    return FlightTracks(
        tuple(steps),
        np.array([step.now - start for step in steps]),
        np.array([_estimate(step) for step in steps]),
        np.array(
            [
                step.outputs.reference.position[:2] if step.outputs.reference else (np.nan, np.nan)
                for step in steps
            ]
        ),
        np.array([_asked(step) for step in steps]),
        np.array(
            [
                (t.theta, t.phi) if (t := step.inputs.telemetry) else (np.nan, np.nan)
                for step in steps
            ]
        ),
        np.array([s.captured_at - start for s in sightings]),
        np.array([s.pose.position for s in sightings]).reshape(-1, 3),
        tilts[:, [1, 0]],
        truth.time - start if truth else np.empty(0),
        truth.position if truth else np.empty((0, 3)),
    )


def _estimate(step: PilotStep) -> tuple[float, float, float, float]:
    found = step.outputs.estimate
    if found is None:
        return (np.nan, np.nan, np.nan, np.nan)
    return (*found.position[:2], *found.velocity[:2])


def _asked(step: PilotStep) -> tuple[float, float]:
    command = step.outputs.command
    return (
        (command.setpoint.theta, command.setpoint.phi)
        if command.action is Action.FLY
        else (0.0, 0.0)
    )
