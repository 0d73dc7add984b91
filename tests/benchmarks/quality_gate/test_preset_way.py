"""The figure eight that is handed to pilots is one that can be flown."""

from __future__ import annotations

import numpy as np
import pytest

from quality_gate.preset_way import at_steps, figure_eight, timed_rows
from quality_gate.rooms import DOOR_WIDTH, DOOR_X, GateRoom, gate_site

TICK, SPEED = 0.02, 0.5
EIGHT = figure_eight((5.0, 3.0), 3.0, 1)


def test_it_begins_and_ends_in_its_middle_and_is_as_wide_as_it_is_said_to_be() -> None:
    assert EIGHT[0] == pytest.approx([5.0, 3.0]) and EIGHT[-1] == pytest.approx([5.0, 3.0])
    assert np.ptp(EIGHT, axis=0) == pytest.approx([3.0, 1.5], abs=1e-3)
    assert np.hypot(*np.diff(at_steps(EIGHT, 0.1), axis=0).T) == pytest.approx(0.1, abs=0.003)


def test_its_speeds_are_those_of_its_places_and_its_accelerations_those_of_its_speeds() -> None:
    rows = timed_rows(EIGHT, 1.1, SPEED, TICK)
    middle = slice(5, -5)
    speeds = np.gradient(rows[:, :2], TICK, axis=0)[middle]
    pushes = np.gradient(rows[:, 3:5], TICK, axis=0)[middle]
    assert np.abs(speeds - rows[middle, 3:5]).max() < 0.02
    assert np.abs(pushes - rows[middle, 6:8]).max() < 0.05
    assert np.hypot(*rows[:, 3:5].T).max() < 1.02 * SPEED
    assert np.abs(rows[[0, -1], 3:]).max() < 0.02
    assert rows[-1, :3] == pytest.approx([5.0, 3.0, 1.1])


@pytest.mark.parametrize("number", [0, 7, 19])
def test_a_numbered_hall_has_its_door_and_no_other_way(number: int) -> None:
    room = gate_site(GateRoom.DOOR, number).room
    walls = sorted(
        (s.position[1] - s.size[1] / 2, s.position[1] + s.size[1] / 2)
        for s in room.solids
        if s.position[0] == DOOR_X and s.name.startswith("door")
    )
    (south, below), (above, north) = walls
    assert above - below == pytest.approx(DOOR_WIDTH)
    assert (south, north) == (room.bounds[1], room.bounds[3])
