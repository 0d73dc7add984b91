"""What is asked is possible in the room, and is asked in words of the room."""

from __future__ import annotations

from dataclasses import replace
from math import dist, pi

import numpy as np
import pytest

from housefly.lab.frames.plan import STEPS, CarryPlan, CarryStep, carry_plan
from housefly.room.distance import clearance_field, footprints
from housefly.sites.loaded_site import load_site


def test_ways_lie_between_the_solids_and_the_walls() -> None:
    room = load_site("bsen").room
    rows = footprints(room.solids, 0.02, 0.6)
    for yaw in (pi, 3.0):
        plan = carry_plan(replace(room, home_yaw=yaw))
        for step in STEPS:
            x, y, _ = plan.place(step)
            clear = clearance_field(rows, np.array([x]), np.array([y]), 5.0)[0, 0]
            assert clear > 0.39, (yaw, step)


def test_where_nothing_is_free_the_freest_ways_are_asked() -> None:
    room = replace(load_site("bsen").room, home_yaw=pi / 2)
    assert {abs(carry_plan(room).forward), abs(carry_plan(room).left)} <= {0.6, 0.7, 0.8, 1.0, 1.5}


def test_the_room_is_what_people_are_told_about() -> None:
    plan = carry_plan(load_site("bsen").room)
    assert "towards Meeting table" in plan.instruction(CarryStep.PAD)
    assert "0.6 m to its right" in plan.instruction(CarryStep.SIDE)


@pytest.mark.parametrize("forward", [1.0, -1.5])
def test_steps_end_where_they_began(forward: float) -> None:
    plan = CarryPlan((3.0, 2.0), 0.7, forward, -0.8)
    assert plan.place(CarryStep.BACK) == plan.place(CarryStep.PAD) == (3.0, 2.0, 0.0)
    corner = plan.place(CarryStep.AHEAD)
    assert dist(plan.place(CarryStep.PAD), corner) == pytest.approx(abs(forward))
    assert dist(corner, plan.place(CarryStep.SIDE)) == pytest.approx(0.8)
    ways = [plan.displacement(step) for step in STEPS]
    assert [sum(values) for values in zip(*ways, strict=True)] == pytest.approx([0.0, 0.0, 0.0])
