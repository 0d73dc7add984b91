"""The flights of a reproduction: services on a stepped clock, steps of the angles, and one service
over real wires.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import inf
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from housefly.app.console_camera import ConsoleCamera
from housefly.app.headless import fly_over_wires
from housefly.app.identify_flight import Errand, fly_in_lock_step
from housefly.app.lockstep import fly_lockstep
from housefly.app.premises import Premises, open_premises
from housefly.app.runtime import new_runtime
from housefly.config.site import Site, changed
from housefly.errors import LinkError
from housefly.lab.identification.box import find_box
from housefly.lab.identification.maneuver import Maneuver
from housefly.lab.identification.pattern import Axis, blocks, largest_excursion
from housefly.lab.identification.result import Identified, Limits, identify
from housefly.lab.identification.samples import samples_of
from housefly.lab.reproduction.angular_step import AngularStep, fit_step
from housefly.lab.reproduction.fig11_angles import ALPHA
from housefly.lab.reproduction.fig17_service import Picture
from housefly.lab.reproduction.flight import Flight, flight_of
from housefly.messages import Order, OrderKind, Phase, PilotStep
from housefly.record.recorder import FlightRecorder
from housefly.record.summary import Summary
from housefly.twin.world import SimulatedWorld

GOAL = "entrance"
LOOK = 4.0
"""How long the drone looks [s]."""
MARGIN = 0.3
Numbers = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Service:
    """One service with its record."""

    premises: Premises
    flight: Flight
    summary: Summary


def fly_service(site: Site, mode: str, folder: Path) -> Service:
    """Fly one service on a stepped clock and keep its record in a folder.

    Raises:
        LinkError: it was not completed; the message says why.
    """
    premises = open_premises(changed(site, mode=mode))
    recorder = FlightRecorder(folder, premises.site, premises.room, premises.grid)
    steps: list[PilotStep] = []

    def on_step(step: PilotStep) -> None:
        steps.append(step)
        recorder.step(step)

    outcome = "failed"
    try:
        outcome = fly_lockstep(premises, Order(OrderKind.SERVICE, place=GOAL, look_s=LOOK), on_step)
    finally:
        summary = recorder.finish(outcome)
    if outcome != "completed":
        raise LinkError(f"the service in mode {mode} ended with: {outcome}")
    return Service(premises, flight_of(steps, site.tracking.body), summary)


@dataclass(frozen=True, slots=True, eq=False)
class Steps:
    """Steps in pitch and roll of one flight.

    Attributes:
        onboard: times since the command [s] and pitch [rad] of the first step, by the drone's own
            sensors.
        fit: of that step.
        identified: constants from all steps.
    """

    onboard: tuple[Numbers, Numbers]
    fit: AngularStep
    identified: Identified


def fly_steps(site: Site, repeats: int) -> Steps:
    """Fly the identification pattern on a stepped clock; raises LinkError when it is given up."""
    premises = open_premises(changed(site, mode="default"))
    drone, limits = premises.site.drone, premises.site.limits
    plan = blocks(repeats, limits.tilt_max)
    reach = MARGIN + largest_excursion(
        plan, drone.attitude_lag, drone.attitude_gain, drone.drag, drone.command_delay
    )
    box = find_box(premises.grid, premises.room.home, reach, premises.site.map.flight_height)
    maneuver, steps = Maneuver(plan, box), list[PilotStep]()
    world = SimulatedWorld(premises.site, premises.room)
    outcome = fly_in_lock_step(premises, world, Errand(box, maneuver, inf), steps.append)
    if outcome != "completed":
        raise LinkError(f"the steps of Fig. 11 were given up: {outcome}")
    found = identify(
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
    return Steps((at, angle - level), fit_step(at, angle - level, ALPHA * limits.tilt_max), found)


MOMENTS: tuple[tuple[str, Phase, float], ...] = (
    ("taking off", Phase.TAKING_OFF, 3.0),
    ("on the way", Phase.OUTBOUND, 8.0),
    ("at the entrance, looking at the visitor", Phase.LOOKING, 2.0),
    ("on the way back", Phase.RETURNING, 6.0),
    ("landing", Phase.LANDING, 2.0),
)
"""What the strip shows: words, phase, and how long the phase has lasted [s]."""


@dataclass(frozen=True, slots=True, eq=False)
class Shot:
    """The pilot's step of one moment, and the console at it where there is a browser."""

    title: str
    step: PilotStep
    console: Picture | None


@dataclass(frozen=True, slots=True, eq=False)
class WireService:
    """A service over real wires.

    Attributes:
        service: the flight with its record.
        shots: one for each moment.
        folder: of the record.
    """

    service: Service
    shots: tuple[Shot, ...]
    folder: Path


def fly_wires(site: Site, folder: Path, on_word: Callable[[str], None]) -> WireService:
    """Fly one service over real wires with console and video; a browser photographs the console
    where there is one.
    """
    premises = open_premises(changed(site, mode="default", web__port=0))
    logs = folder / "logs"
    logs.mkdir(parents=True, exist_ok=True)
    runtime = new_runtime(premises.site, logs)
    web = runtime.site().web
    recorder = FlightRecorder(folder, premises.site, premises.room, premises.grid)
    steps: list[PilotStep] = []
    order = Order(OrderKind.SERVICE, place=GOAL, look_s=LOOK, sender="reproduction")
    outcome = "failed"
    with ConsoleCamera(f"http://{web.host}:{web.port}/?token={runtime.token}") as camera:
        watch = _Moments(camera)

        def on_step(step: PilotStep) -> None:
            steps.append(step)
            watch.step(step)

        try:
            outcome = fly_over_wires(
                runtime,
                logs,
                premises.room.home,
                order,
                recorder,
                on_step,
                on_word,
                web=camera.available,
            )
        finally:
            summary = recorder.finish(outcome)
        shots = watch.shots()
    if outcome != "completed":
        raise LinkError(
            f"the service over real wires ended with: {outcome} (its record is in {folder})"
        )
    return WireService(
        Service(premises, flight_of(steps, site.tracking.body), summary), shots, folder
    )


class _Moments:
    """Notes the step of each moment and asks for a photograph."""

    def __init__(self, camera: ConsoleCamera) -> None:
        self._camera = camera
        self._phase, self._since = Phase.IDLE, -inf
        self._steps: dict[str, PilotStep] = {}

    def step(self, step: PilotStep) -> None:
        """Look at one step."""
        if step.outputs.phase is not self._phase:
            self._phase, self._since = step.outputs.phase, step.now
        for title, phase, after in MOMENTS:
            if (
                title not in self._steps
                and phase is self._phase
                and step.now - self._since >= after
            ):
                self._steps[title] = step
                self._camera.shoot(title)

    def shots(self) -> tuple[Shot, ...]:
        """Return the moments that came."""
        pictures = self._camera.pictures()
        return tuple(Shot(title, step, pictures.get(title)) for title, step in self._steps.items())


def camera_pictures(folder: Path, ages: tuple[float, ...]) -> tuple[Picture | None, ...]:
    """Return the pictures of ``video.mp4`` that were shown at these times [s since its last
    picture, backwards].
    """
    import av

    path = folder / "video.mp4"
    found: list[Picture | None] = [None] * len(ages)
    if not path.is_file():
        return tuple(found)
    with av.open(str(path)) as movie:
        times = [
            float(packet.pts * packet.time_base)
            for packet in movie.demux(video=0)
            if packet.pts is not None
        ]
    if not times:
        return tuple(found)
    wanted = [times[-1] - age for age in ages]
    with av.open(str(path)) as movie:
        for frame in movie.decode(video=0):
            for index, at in enumerate(wanted):
                if frame.time is not None and frame.time <= at + 0.02 and frame.time > at - 0.5:
                    found[index] = np.asarray(frame.to_ndarray(format="rgb24"), dtype=np.uint8)
    return tuple(found)
