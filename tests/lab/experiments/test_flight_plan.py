from __future__ import annotations

from dataclasses import replace

import numpy as np

from housefly.lab.experiments.flight_plan import FlightPlan, Task
from housefly.pilot.behavior.trajectory_profile import trajectory_profile


def test_plans_that_differ_in_one_bit_of_a_trajectory_have_another_mark() -> None:
    rows = np.zeros((200, 9))
    rows[:, 0] = np.linspace(0.0, 1.0, 200)
    bent = rows.copy()
    bent[100, 4] = np.nextafter(0.0, 1.0)
    corners = FlightPlan(Task.PATH, ((0.0, 0.0), (1.0, 0.0)), 9.0)
    plans = [
        replace(corners, trajectory=trajectory_profile(motion, 0.0, 0.0)) for motion in (rows, bent)
    ]
    again = replace(corners, trajectory=trajectory_profile(rows.copy(), 0.0, 0.0))
    assert len({plan.digest for plan in (corners, *plans)}) == 3
    assert again.digest == plans[0].digest
    assert replace(corners, yaw=0.1).digest != corners.digest
