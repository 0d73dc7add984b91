"""No compiler runs in a flight: everything is compiled before."""

from __future__ import annotations

import subprocess
import sys

PROGRAM = """
import gc

from numba.core.dispatcher import Dispatcher

from housefly import Order, OrderKind, Simulation, load_site
from housefly.pilot.assembly import warm_up


def compiled():
    found = [each for each in gc.get_objects() if isinstance(each, Dispatcher)]
    return {f"{d.py_func.__module__}.{d.py_func.__name__}": len(d.signatures) for d in found}


loaded = load_site()
warm_up(loaded.site, loaded.room, loaded.grid)
simulation = Simulation(loaded)
before = compiled()
while simulation.now < 12.0:
    simulation.advance()
    orders = (Order(OrderKind.GO, "table"),) if 0.5 <= simulation.now < 0.505 else ()
    simulation.step(simulation.inputs(*orders))
print([name for name, count in compiled().items() if count != before.get(name, 0)])
"""


def test_after_warming_up_a_flight_compiles_nothing() -> None:
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM], capture_output=True, text=True, check=True, timeout=110
    )
    assert done.stdout.strip() == "[]"
