"""The flights of a reproduction: services in lock step and over real wires, and angle steps."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import inf
from pathlib import Path

import numpy as np

from housefly.app.console_camera import ConsoleCamera
from housefly.app.headless import fly_over_wires
from housefly.app.identification_flight import (
    IdentificationFlight,
    box_reach,
    fly_identification_lockstep,
)
from housefly.app.loaded_site import LoadedSite, open_site
from housefly.app.lockstep import fly_lockstep
from housefly.app.reproduction_moments import MomentShot, MomentShots
from housefly.app.runtime import new_runtime
from housefly.config.site import Site, changed
from housefly.errors import LinkError
from housefly.lab.identification.box import find_box
from housefly.lab.identification.maneuver import IdentificationManeuver
from housefly.lab.identification.pattern import Axis, blocks
from housefly.lab.identification.result import Identified, Limits, fit_constants
from housefly.lab.identification.samples import samples_of
from housefly.lab.reproduction.angular_step import AngularStep, fit_step
from housefly.lab.reproduction.fig11_angles import ALPHA
from housefly.lab.reproduction.flight import FlightTracks, flight_tracks
from housefly.messages import Order, OrderKind, PilotStep
from housefly.numeric import FloatArray
from housefly.record.recorder import FlightRecorder
from housefly.record.summary import Summary
from housefly.twin.world import SimulatedWorld
from housefly.web.exposure import console_address

_GOAL = "entrance"
_LOOK = 4.0
"""How long the drone looks [s]."""


@dataclass(frozen=True, slots=True, eq=False)
class RecordedService:
    """One service with its record."""

    loaded: LoadedSite
    flight: FlightTracks
    summary: Summary


def fly_recorded_service(site: Site, mode: str, folder: Path) -> RecordedService:
    """Fly one service on a stepped clock and keep its record in a folder.

    Raises:
        LinkError: it was not completed; the message says why.
    """
    loaded = open_site(changed(site, mode=mode))
    recorder = FlightRecorder(folder, loaded.site, loaded.room, loaded.grid)
    steps: list[PilotStep] = []

    def on_step(step: PilotStep) -> None:
        steps.append(step)
        recorder.add_step(step)

    outcome = "failed"
    try:
        outcome = fly_lockstep(loaded, Order(OrderKind.SERVICE, place=_GOAL, look_s=_LOOK), on_step)
    finally:
        summary = recorder.finish(outcome)
    if outcome != "completed":
        raise LinkError(f"the service in mode {mode} ended with: {outcome}")
    return RecordedService(loaded, flight_tracks(steps, site.tracking.body), summary)


@dataclass(frozen=True, slots=True, eq=False)
class StepFlight:
    """Steps in pitch and roll of one flight.

    Attributes:
        onboard: time since the command [s] and pitch [rad] of the first step, by onboard sensors.
        fit: of that step.
        identified: constants from all steps.
    """

    onboard: tuple[FloatArray, FloatArray]
    fit: AngularStep
    identified: Identified


def fly_steps(site: Site, repeats: int) -> StepFlight:
    """Fly the identification pattern on a stepped clock; raises LinkError when it is given up."""
    loaded = open_site(changed(site, mode="default"))
    limits = loaded.site.limits
    plan = blocks(repeats, limits.tilt_max)
    reach = box_reach(plan, loaded.site.drone)
    box = find_box(loaded.grid, loaded.room.home, reach, loaded.site.map.flight_height)
    maneuver, steps = IdentificationManeuver(plan, box), list[PilotStep]()
    world = SimulatedWorld(loaded.site, loaded.room)
    outcome = fly_identification_lockstep(
        loaded, world, IdentificationFlight(box, maneuver, inf), steps.append
    )
    if outcome != "completed":
        raise LinkError(f"the steps of Fig. 11 were given up: {outcome}")
    found = fit_constants(
        samples_of(steps, tuple(maneuver.flown), site.tracking.body),
        Limits(limits.tilt_max, limits.vertical_speed_max, limits.yaw_rate_max),
    )
    first = next(own for own in maneuver.flown if own.block.axis is Axis.PITCH)
    rows = [
        (step.inputs.telemetry.received_at - first.began, step.inputs.telemetry.theta)
        for step in steps
        if step.inputs.telemetry is not None and 0.0 <= step.now - first.began < first.block.part
    ]
    at, angle = np.array(rows).T
    level = float(angle[at < 0.03].mean())
    return StepFlight(
        (at, angle - level), fit_step(at, angle - level, ALPHA * limits.tilt_max), found
    )


@dataclass(frozen=True, slots=True, eq=False)
class WireService:
    """A service over real wires.

    Attributes:
        service: the flight with its record.
        shots: one for each moment.
        folder: of the record.
    """

    service: RecordedService
    shots: tuple[MomentShot, ...]
    folder: Path


def fly_recorded_over_wires(
    site: Site, folder: Path, on_word: Callable[[str], None]
) -> WireService:
    """Fly one service over real wires, with video, and pictures of the console if possible."""
    loaded = open_site(changed(site, mode="default", web__port=0))
    logs = folder / "logs"
    logs.mkdir(parents=True, exist_ok=True)
    runtime = new_runtime(loaded.site, logs)
    recorder = FlightRecorder(folder, loaded.site, loaded.room, loaded.grid)
    steps: list[PilotStep] = []
    order = Order(OrderKind.SERVICE, place=_GOAL, look_s=_LOOK, sender="reproduction")
    outcome = "failed"
    with ConsoleCamera(f"{console_address(runtime.site())}/?token={runtime.token}") as camera:
        moments = MomentShots(camera)

        def on_step(step: PilotStep) -> None:
            steps.append(step)
            moments.update(step)

        try:
            outcome = fly_over_wires(
                runtime,
                logs,
                loaded.room.home,
                order,
                recorder,
                on_step,
                on_word,
                web=camera.available,
            )
        finally:
            summary = recorder.finish(outcome)
        shots = moments.shots()
    if outcome != "completed":
        raise LinkError(
            f"the service over real wires ended with: {outcome} (its record is in {folder})"
        )
    return WireService(
        RecordedService(loaded, flight_tracks(steps, site.tracking.body), summary), shots, folder
    )
