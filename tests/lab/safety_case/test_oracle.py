from __future__ import annotations

import pytest

from housefly.lab.lockstep.simulation import Simulation
from housefly.lab.safety_case.oracle import Oracle
from housefly.messages import Order, OrderKind, Phase
from housefly.sites.loaded_site import load_site


@pytest.mark.safety
def test_a_drone_that_takes_off_again_without_an_order_is_unsafe_and_with_one_it_is_not() -> None:
    loaded = load_site("bsen", hub__enabled=False)
    simulation = Simulation(loaded)
    asked = Oracle(simulation.world, loaded.site, loaded.room, faulty_since=0.0, orders=2)
    unasked = Oracle(simulation.world, loaded.site, loaded.room, faulty_since=0.0)
    orders = [(0.5, OrderKind.TAKE_OFF), (6.0, OrderKind.LAND), (14.0, OrderKind.TAKE_OFF)]
    while simulation.now < 16.0:
        simulation.advance()
        due = [Order(kind, sender="test") for at, kind in orders if simulation.now >= at]
        orders = [(at, kind) for at, kind in orders if simulation.now < at]
        step = simulation.step(simulation.inputs(*due))
        asked.watch(step)
        unasked.watch(step)
    assert step.outputs.phase is Phase.TAKING_OFF
    assert not asked.violations
    assert list(unasked.violations) == ["I8"]
