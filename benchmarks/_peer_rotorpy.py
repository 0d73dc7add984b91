"""One drone of rotorpy under its own SE(3) controller; runs in rotorpy's environment and prints
drone-seconds per core-second.
"""

import sys
import time

from rotorpy.controllers.quadrotor_control import SE3Control
from rotorpy.environments import Environment
from rotorpy.trajectories.lissajous_traj import TwoDLissajous
from rotorpy.vehicles.crazyflie_params import quad_params
from rotorpy.vehicles.multirotor import Multirotor

seconds = float(sys.argv[2])
world = Environment(
    Multirotor(quad_params),
    SE3Control(quad_params),
    TwoDLissajous(A=1, B=1, a=2, b=1),
    sim_rate=100,
)
world.run(t_final=0.5, use_mocap=True, plot=False)
start = time.process_time()
flown = world.run(t_final=seconds, use_mocap=True, plot=False)
print(float(flown["time"][-1]) / (time.process_time() - start))
