"""A pilot that runs late on a busy machine, in the simulated room: no wind, and none is told."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from housefly.lab.lockstep.simulation import Simulation
from housefly.messages import Order, OrderKind, Phase
from housefly.sites.loaded_site import load_site

FAR = (2.45, 4.45)
LATE_FROM, END, LATEST = 6.0, 20.0, 24
"""Late since [s], until [s]; most periods of the pilot that are missed at once."""


def test_lateness_is_no_wind() -> None:
    loaded = load_site("bsen", hub__enabled=False, twin__video=False, limits__speed=1.0)
    simulation, random = Simulation(loaded), np.random.default_rng(1)
    period, codes, phase = 1.0 / loaded.site.control.rate_hz, set(), Phase.IDLE
    orders = [
        Order(OrderKind.TAKE_OFF, sender="test"),
        Order(OrderKind.GO, goal=FAR, sender="test"),
    ]
    missed = left = 0
    while simulation.now < END:
        simulation.advance()
        if left:
            left, missed = left - 1, missed + 1
            continue
        is_due = orders and simulation.now > 0.5 and phase in (Phase.IDLE, Phase.HOLDING)
        inputs = simulation.inputs(*((orders.pop(0),) if is_due else ()))
        outputs = simulation.step(replace(inputs, late=missed * period)).outputs
        codes |= {event.code for event in outputs.events}
        phase, missed = outputs.phase, 0
        if simulation.now > LATE_FROM and random.random() < 0.2:
            left = int(random.integers(1, LATEST + 1))
    assert "loop_slow" in codes
    assert not codes & {"blown_about", "forced_down", "grounded"}
