"""The flights of a reproduction on a stepped clock: services, and steps of the angle."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from math import inf, nan
from pathlib import Path

import numpy as np
from pydantic import TypeAdapter, ValidationError

from housefly.app.identification_flight import (
    IdentificationFlight,
    box_reach,
    fly_identification_lockstep,
)
from housefly.app.reproduction_store import ReproductionStore
from housefly.config.site import Mode, Site, changed
from housefly.errors import LinkError, RecordingError
from housefly.lab.identification.box import find_box
from housefly.lab.identification.maneuver import IdentificationManeuver
from housefly.lab.identification.pattern import Axis, blocks
from housefly.lab.identification.plots import step_response
from housefly.lab.identification.result import Limits, fit_constants
from housefly.lab.identification.samples import samples_of
from housefly.lab.lockstep.service import fly_lockstep
from housefly.lab.reproduction.angular_step import fit_step
from housefly.lab.reproduction.fig11_angles import ALPHA, StepFlight
from housefly.lab.reproduction.flight import FlightTracks, flight_tracks
from housefly.lab.reproduction.kept_steps import read_step_flight, write_step_flight
from housefly.messages import Order, OrderKind, OrderSource, PilotStep
from housefly.numeric import FloatArray
from housefly.pilot.assembly import make_pilot
from housefly.record.recorder import FlightRecorder
from housefly.record.replay import read_steps
from housefly.record.summary import Summary
from housefly.record.truth import TRUTH_FILE, read_truth
from housefly.sites.loaded_site import LoadedSite, open_site
from housefly.twin.world import SimulatedWorld

GOAL = "entrance"
LOOK_TIME = 4.0
"""How long the drone looks [s]."""

Tick = Callable[[], None]
"""Called at every step of a flight; raises when the run is to end."""


@dataclass(frozen=True, slots=True, eq=False)
class RecordedService:
    """One service with its record."""

    loaded: LoadedSite
    flight: FlightTracks
    summary: Summary


def fly_recorded_service(
    site: Site, mode: Mode, store: ReproductionStore, on_tick: Tick = lambda: None
) -> RecordedService:
    """Return one service on a stepped clock, flown now unless an earlier run has.

    Raises:
        LinkError: it was not completed; the message says why.
    """
    loaded = open_site(changed(site, mode=mode))
    if store.is_kept(mode):
        try:
            return read_service(loaded, store.flight_folder(mode))
        except RecordingError:
            pass  # damaged since: it is flown again
    folder = store.begin(mode)
    recorder = FlightRecorder(folder, loaded.site, loaded.room, loaded.grid)

    steps: list[PilotStep] = []

    def on_step(step: PilotStep) -> None:
        steps.append(step)
        recorder.add_step(step)
        on_tick()

    order = Order(OrderKind.SERVICE, place=GOAL, look_s=LOOK_TIME, source=OrderSource.PROGRAM)
    outcome = "interrupted"
    try:
        outcome = fly_lockstep(loaded, order, on_step, truth_file=recorder.truth_file)
    finally:
        summary = recorder.finish(outcome)
    if outcome != "completed":
        raise LinkError(f"the service in mode {mode} ended with: {outcome}")
    store.keep(mode)
    return _recorded(loaded, folder, steps, summary)


def read_service(loaded: LoadedSite, folder: Path) -> RecordedService:
    """Return a service from its record.

    Raises:
        RecordingError: the record is damaged or incomplete.
    """
    steps = tuple(read_steps(folder))
    if not steps:
        raise RecordingError(f"{folder} holds no step of a flight")
    try:
        text = (folder / "summary.json").read_text(encoding="utf-8")
        summary = TypeAdapter(Summary).validate_json(text)
    except (OSError, ValidationError) as error:
        raise RecordingError(f"{folder}/summary.json cannot be read: {error}") from error
    return _recorded(loaded, folder, steps, summary)


def _recorded(
    loaded: LoadedSite, folder: Path, steps: Sequence[PilotStep], summary: Summary
) -> RecordedService:
    body, truth = loaded.site.tracking.body, read_truth(folder / TRUTH_FILE)
    return RecordedService(loaded, flight_tracks(steps, body, truth), summary)


def demanded_accelerations(loaded: LoadedSite, steps: Iterable[PilotStep]) -> FloatArray:
    """Return what the control law demanded before any limit [m/s^2], shape (n, 2).

    A fresh pilot decides the recorded flight again; nan where nothing was tracked.
    """
    pilot, found = make_pilot(loaded.site, loaded.room, loaded.grid), []
    for step in steps:
        pilot.step(step.now, step.inputs)
        found.append(pilot.demanded_acceleration or (nan, nan))
    return np.array(found, dtype=np.float64).reshape(-1, 2)


def fly_steps(
    site: Site, repeats: int, store: ReproductionStore, on_tick: Tick = lambda: None
) -> StepFlight:
    """Return the identification pattern on a stepped clock, flown now unless an earlier run has.

    Raises:
        LinkError: it was given up.
    """
    settings = (repeats, ALPHA)
    kept = store.flight_folder("steps") / "steps.npz"
    found = read_step_flight(kept) if store.is_kept("steps", settings) else None
    if found is None:
        found = _flown_steps(site, repeats, on_tick)
        store.begin("steps").mkdir(parents=True, exist_ok=True)
        write_step_flight(kept, found)
        store.keep("steps", settings)
    return found


def _flown_steps(site: Site, repeats: int, on_tick: Tick) -> StepFlight:
    loaded = open_site(changed(site, mode="default"))
    limits = loaded.site.limits
    plan = blocks(repeats, limits.tilt_max)
    reach = box_reach(plan, loaded.site.drone)
    box = find_box(loaded.grid, loaded.room.home, reach, loaded.site.map.flight_height)
    maneuver, steps = IdentificationManeuver(plan, box), list[PilotStep]()

    def on_step(step: PilotStep) -> None:
        steps.append(step)
        on_tick()

    world = SimulatedWorld(loaded.site, loaded.room)
    outcome = fly_identification_lockstep(
        loaded, world, IdentificationFlight(box, maneuver, inf), on_step
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
    angle = angle - float(angle[at < 0.03].mean())
    asked, response = ALPHA * limits.tilt_max, step_response(found)
    return StepFlight(
        onboard=(at, angle),
        tracked=(response.at, response.share * asked),
        fit=fit_step(at, angle, asked),
        constants=dict(found.constants),
    )
