"""Fly the whole service on a stepped clock.

Needs: MuJoCo: the extra `twin`, which `make setup` brings.
Learns: the pilot is one pure step; the simulated room moves only when it is told to, so a minute of
    flight takes seconds. The same seed gives the same flight, bit for bit.
Prints: each phase of the service with the world's time and the drone's place, then the outcome.
"""

import time

import housefly

phase = housefly.Phase.IDLE


def on_step(step: housefly.PilotStep) -> None:
    """Print a line when the service comes to another phase."""
    global phase
    if step.outputs.phase is not phase and step.outputs.estimate is not None:
        phase = step.outputs.phase
        x, y, z = step.outputs.estimate.position
        print(f"{step.now:6.2f} s  {phase.value:<15} at ({x:.2f}, {y:.2f}, {z:.2f}) m")


started = time.perf_counter()
site = housefly.load_site("bsen", twin__seed=7)
flight = housefly.fly("table", site, look_s=2.0, on_step=on_step)
spent = time.perf_counter() - started
print(f"{flight.outcome}: {flight.summary.duration_s:.0f} s of flight in {spent:.0f} s")
