"""ArduCopter and PX4 fly the visitor service in lock step, and their recordings replay."""

from __future__ import annotations

from math import dist, hypot
from pathlib import Path

import pytest

from housefly.lab.lockstep.service import fly_lockstep
from housefly.lab.lockstep.simulation import Simulation
from housefly.messages import Order, OrderKind, Phase, PilotStep
from housefly.pilot.assembly import make_pilot
from housefly.record.recorder import FlightRecorder
from housefly.record.replay import verify
from housefly.sites.loaded_site import load_site
from housefly.twin.contracts import FlightState
from housefly.twin.world import SimulatedWorld


@pytest.mark.usefixtures("no_report")
@pytest.mark.parametrize("kind", ["px4", pytest.param("arducopter", marks=pytest.mark.interop)])
def test_it_completes_the_service_near_its_path_and_is_replayed_bit_for_bit(
    kind: str, tmp_path: Path
) -> None:
    loaded = load_site("bsen", drone__kind=kind)
    worlds: list[SimulatedWorld] = []
    errors: list[float] = []
    recorder = FlightRecorder(tmp_path / "flight", loaded.site, loaded.room, loaded.grid)

    def on_step(step: PilotStep) -> None:
        recorder.add_step(step)
        reference = step.outputs.reference
        if worlds and reference and step.outputs.phase is Phase.OUTBOUND:
            place = worlds[0].truth().pose.position
            errors.append(dist(place[:2], reference.position[:2]))

    def on_world(world: SimulatedWorld) -> None:
        worlds[:] = [world]

    order = Order(OrderKind.SERVICE, "entrance")
    assert fly_lockstep(loaded, order, on_step, on_world=on_world) == "completed"
    assert recorder.finish("completed").problems == ()
    assert max(errors) < 0.05 and not worlds[0].contact_log
    result = verify(tmp_path / "flight", lambda: make_pilot(loaded.site, loaded.room, loaded.grid))
    assert (result.missing, result.difference) == (0, None)


@pytest.mark.parametrize(
    ("kind", "stops", "lands"),
    [pytest.param("arducopter", 3.0, 5.0, marks=pytest.mark.interop), ("px4", 1.0, 1.0)],
)
def test_over_a_lost_link_it_comes_to_rest_and_lands_by_its_own_rules(
    kind: str, stops: float, lands: float
) -> None:
    simulation = Simulation(load_site("bsen", drone__kind=kind))
    simulation.inject("commands:off@9s+60s")
    order: tuple[Order, ...] = (Order(OrderKind.GO, "entrance"),)
    speeds: dict[float, float] = {}
    landing: float | None = None
    while simulation.now < 18.0:
        simulation.advance()
        given, order = (order, ()) if simulation.now > 0.5 else ((), order)
        simulation.step(simulation.inputs(*given))
        speeds[simulation.now - 9.0] = hypot(*simulation.world.truth().velocity[:2])
        is_landing = simulation.world.onboard().flight is FlightState.LANDING
        landing = simulation.now - 9.0 if is_landing and landing is None else landing
    assert landing is not None and lands - 0.1 < landing < lands + 0.2
    assert all(speed > 0.3 for at, speed in speeds.items() if 0.0 < at < stops - 0.1)
    assert max(speed for at, speed in speeds.items() if at > stops + 1.7) < 0.05
    assert simulation.world.truth().pose.position[2] < 0.3 and not simulation.contacts()
