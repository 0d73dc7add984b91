"""Fly the whole service on a stepped clock.

Learns: the pilot is one pure step; the simulated room moves only when it is told to, so a minute of
    flight takes seconds.
Prints: each phase of the errand with the world's time and the drone's place, then the outcome.
"""

import time

from housefly.app.loaded_site import open_site, read_site
from housefly.app.lockstep import fly_lockstep
from housefly.messages import Order, OrderKind, Phase, PilotStep

phase = Phase.IDLE
flown = 0.0


def on_step(step: PilotStep) -> None:
    """Print a line when the errand comes to another phase."""
    global phase, flown
    flown = step.now
    if step.outputs.phase is not phase and step.outputs.estimate is not None:
        phase = step.outputs.phase
        x, y, z = step.outputs.estimate.position
        print(f"{step.now:6.2f} s  {phase.value:<15} at ({x:.2f}, {y:.2f}, {z:.2f}) m")


started = time.perf_counter()
loaded = open_site(read_site("bsen", twin__seed=7))
outcome = fly_lockstep(loaded, Order(OrderKind.SERVICE, place="entrance", look_s=2.0), on_step)
print(f"{outcome}: {flown:.0f} s of flight in {time.perf_counter() - started:.0f} s")
