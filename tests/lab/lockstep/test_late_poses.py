"""A drone that is told where it is, by tracking that is late: it is told where it is by now."""

from __future__ import annotations

import pytest

from housefly.lab.lockstep.simulation import Simulation
from housefly.messages import Order, OrderKind
from housefly.sites.loaded_site import load_site
from housefly.twin.faults.catalogue import row_of


def told_while_it_climbs(model: str) -> list[tuple[float, float]]:
    """Return how fast it climbed [m/s], and how far below its place it was told to be [m]."""
    loaded = load_site("bsen", drone__kind=model, hub__enabled=False, twin__video=False)
    simulation = Simulation(loaded)
    simulation.inject(*row_of("F12").faults_of("0.2s"))
    orders, found = [Order(OrderKind.SERVICE, "sofa")], []
    while simulation.now < 4.0:
        simulation.advance()
        given = orders.pop() if orders and simulation.now > 0.5 else None
        simulation.step(simulation.inputs(*filter(None, (given,))))
        truth, told = simulation.world.truth(), simulation.pilot.external_pose
        if told is not None and simulation.now > 1.0:
            found.append((truth.velocity[2], truth.pose.position[2] - told.pose.position[2]))
    return found


@pytest.mark.slow
def test_one_that_does_not_hear_when_it_was_seen_is_told_where_it_is_by_now() -> None:
    found = told_while_it_climbs("crazyflie")
    assert max(climb for climb, _ in found) > 0.6
    assert max(abs(off) for _, off in found) < 0.1


@pytest.mark.slow
def test_one_that_hears_it_is_told_where_it_was() -> None:
    found = told_while_it_climbs("px4")
    fast = [(climb, off) for climb, off in found if climb > 0.3]
    assert fast and all(off > 0.5 * 0.2 * climb for climb, off in fast)
