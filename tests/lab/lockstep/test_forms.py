"""Drones of other forms fly the visitor service, and stand still when nobody steers them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from math import dist, hypot, isfinite
from pathlib import Path

import pytest
from made_up_drones import POSITION, VELOCITY, known_made_up_drones

from housefly.lab.lockstep.service import fly_lockstep
from housefly.lab.lockstep.simulation import Simulation
from housefly.messages import (
    Action,
    AnySetpoint,
    Order,
    OrderKind,
    Phase,
    PilotStep,
    PositionSetpoint,
    VelocitySetpoint,
)
from housefly.messages.steering import numbers_of
from housefly.pilot.assembly import make_pilot
from housefly.pilot.safety.motion_rules import speed_bound
from housefly.record.recorder import FlightRecorder
from housefly.record.replay import verify
from housefly.room.grid import extent_of
from housefly.sites.loaded_site import LoadedSite, load_site
from housefly.twin.world import SimulatedWorld

FORMS: dict[str, type[AnySetpoint]] = {VELOCITY: VelocitySetpoint, POSITION: PositionSetpoint}
SERVICE = Order(OrderKind.SERVICE, "entrance")


@pytest.fixture(scope="module", autouse=True)
def made_up() -> Iterator[None]:
    with known_made_up_drones():
        yield


@dataclass
class Flown:
    """One service: its steps, its recording, and how far it truly was from where it should be."""

    loaded: LoadedSite
    folder: Path
    outcome: str = ""
    problems: tuple[str, ...] = ()
    steps: list[PilotStep] = field(default_factory=list)
    errors: list[float] = field(default_factory=list)
    _world: SimulatedWorld | None = None

    def step(self, step: PilotStep) -> None:
        self.steps.append(step)
        reference = step.outputs.reference
        if self._world and reference and step.outputs.phase is Phase.OUTBOUND:
            place = self._world.truth().pose.position
            self.errors.append(dist(place[:2], reference.position[:2]))

    def world(self, world: SimulatedWorld) -> None:
        self._world = world

    @property
    def asked(self) -> list[AnySetpoint]:
        commands = (step.outputs.command for step in self.steps)
        return [command.asked for command in commands if command.action is Action.FLY]


@pytest.fixture(scope="module", params=FORMS)
def flown(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Flown:
    loaded = load_site("bsen", drone__kind=request.param)
    flight = Flown(loaded, tmp_path_factory.mktemp(request.param))
    recorder = FlightRecorder(flight.folder / "flight", loaded.site, loaded.room, loaded.grid)

    def on_step(step: PilotStep) -> None:
        flight.step(step)
        recorder.add_step(step)

    flight.outcome = fly_lockstep(loaded, SERVICE, on_step, on_world=flight.world)
    flight.problems = recorder.finish(flight.outcome).problems
    return flight


@pytest.mark.interop
def test_it_completes_the_service_near_its_path_and_touches_nothing(flown: Flown) -> None:
    assert flown.outcome == "completed"
    assert (sum(error * error for error in flown.errors) / len(flown.errors)) ** 0.5 < 0.05


@pytest.mark.interop
def test_it_is_steered_in_its_own_form_within_its_limits_and_the_room(flown: Flown) -> None:
    site = flown.loaded.site
    form = FORMS[site.drone.kind]
    x_min, y_min, x_max, y_max = extent_of(flown.loaded.grid)
    for asked in flown.asked:
        assert type(asked) is form and all(map(isfinite, numbers_of(asked)))
        if isinstance(asked, VelocitySetpoint):
            assert hypot(asked.forward, asked.left) <= speed_bound(site.limits) + 1e-9
        if isinstance(asked, PositionSetpoint):
            assert x_min <= asked.x <= x_max and y_min <= asked.y <= y_max
    assert len(flown.asked) > 2000


@pytest.mark.interop
def test_its_recording_is_replayed_bit_for_bit_and_has_its_report(flown: Flown) -> None:
    loaded = flown.loaded
    assert flown.problems == () and (flown.folder / "flight" / "report.html").is_file()
    result = verify(
        flown.folder / "flight", lambda: make_pilot(loaded.site, loaded.room, loaded.grid)
    )
    assert (result.steps, result.missing, result.difference) == (len(flown.steps), 0, None)


@pytest.mark.parametrize("kind", FORMS)
def test_when_its_pilot_is_silent_it_comes_to_rest_and_lands(kind: str) -> None:
    loaded = load_site("bsen", drone__kind=kind)
    simulation = Simulation(loaded)
    order = Order(OrderKind.GO, "entrance")
    while simulation.now < 8.5:
        simulation.advance()
        simulation.step(simulation.inputs(*((order,) if abs(simulation.now - 0.5) < 1e-6 else ())))
    before = simulation.world.truth()
    assert hypot(*before.velocity[:2]) > 0.3, "nothing to brake"
    while simulation.now < 10.4:
        simulation.advance()
    at_rest = simulation.world.truth()
    assert hypot(*at_rest.velocity[:2]) < 0.1
    assert dist(at_rest.pose.position[:2], before.pose.position[:2]) < 0.6
    while simulation.now < 16.0:
        simulation.advance()
    assert simulation.world.truth().pose.position[2] < 0.1
    assert not simulation.contacts()
