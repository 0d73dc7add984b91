"""A file without a unit is in the one that makes it a room."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.room.draft.imports.contracts import USUAL_UNITS
from housefly.room.draft.imports.units import likely_units

SIDES, HEIGHTS = (1.5, 80.0), (1.0, 20.0)


@pytest.mark.parametrize("unit", [1.0, 0.01, 0.001])
@given(length=st.floats(3.0, 12.0), width=st.floats(3.0, 12.0), height=st.floats(2.2, 3.5))
def test_a_usual_room_is_known_in_any_metric_unit(
    unit: float, length: float, width: float, height: float
) -> None:
    sides = length / unit, width / unit
    assert likely_units(USUAL_UNITS, sides, SIDES, height / unit, HEIGHTS)[0] == unit
    metric = (1.0, 0.01, 0.001)
    assert likely_units(metric, sides, SIDES)[0] == unit


@given(st.floats(1e-3, 1e6), st.floats(1e-3, 1e6))
def test_only_units_that_make_a_room_come_into_question(length: float, width: float) -> None:
    for unit in likely_units(USUAL_UNITS, (length, width), SIDES):
        assert SIDES[0] <= unit * length <= SIDES[1] and SIDES[0] <= unit * width <= SIDES[1]
