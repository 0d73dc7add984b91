"""Drones of crazyflow under its own position controller; runs in its environment, prints
drone-seconds per core-second.
"""

import sys
import time

import numpy as np
from crazyflow.control import Control
from crazyflow.sim import Sim

count, seconds = int(sys.argv[1]), float(sys.argv[2])
sim = Sim(n_worlds=count, n_drones=1, control=Control.state, freq=500, state_freq=100)
goal = np.zeros((count, 1, 16), np.float32)
goal[..., 2], goal[..., 12] = 1.1, 1.0


def fly(ticks: int) -> float:
    """Fly along x at 0.5 m/s for some ticks of 10 ms and return the time of the processor [s]."""
    start = time.process_time()
    for tick in range(ticks):
        goal[..., 0], goal[..., 3] = 0.005 * tick, 0.5
        sim.state_control(goal)
        sim.step(5)
    sim.data.states.pos.block_until_ready()
    return time.process_time() - start


fly(5)
sim.reset()
ticks = round(100 * seconds)
took = fly(ticks)
x = np.asarray(sim.data.states.pos)[:, 0, 0]
assert np.abs(x - 0.005 * ticks).max() < 0.5, f"it did not follow: {x}"
print(0.01 * ticks * count / took)
