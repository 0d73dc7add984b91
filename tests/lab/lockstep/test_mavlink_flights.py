"""ArduCopter and PX4 fly the visitor service in lock step, and their recordings replay."""

from __future__ import annotations

from math import dist
from pathlib import Path

import pytest

from housefly.lab.lockstep.service import fly_lockstep
from housefly.messages import Order, OrderKind, Phase, PilotStep
from housefly.pilot.assembly import make_pilot
from housefly.record.recorder import FlightRecorder
from housefly.record.replay import verify
from housefly.sites.loaded_site import load_site
from housefly.twin.world import SimulatedWorld


@pytest.mark.usefixtures("no_report")
@pytest.mark.parametrize("kind", ["arducopter", "px4"])
def test_it_completes_the_service_near_its_path_and_is_replayed_bit_for_bit(
    kind: str, tmp_path: Path
) -> None:
    loaded, worlds, errors = load_site("bsen", drone__kind=kind), [], []
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
