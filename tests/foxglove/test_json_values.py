"""What is told as JSON fits its schema, whatever the numbers are."""

from __future__ import annotations

import json
from math import isfinite

import jsonschema
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.foxglove.json_values import (
    DroneNumbers,
    HouseTasks,
    LinkNumbers,
    RoomHappening,
    RoomSituations,
    json_schema,
    to_json,
)

KINDS = (DroneNumbers, LinkNumbers, HouseTasks, RoomHappening, RoomSituations)


@given(st.data(), st.sampled_from(KINDS))
def test_every_value_fits_the_schema_of_its_type_and_holds_finite_numbers_only(
    data: st.DataObject, kind: type
) -> None:
    told = json.loads(to_json(data.draw(st.from_type(kind))), parse_constant=pytest.fail)
    jsonschema.validate(told, json_schema(kind))


@given(st.floats())
def test_a_number_that_is_none_is_left_out(x: float) -> None:
    told = json.loads(to_json(DroneNumbers(1.0, "", "", "", "", "", 0.0, x=x)))
    assert ("x" in told) == isfinite(x)
    assert "y" not in told


@pytest.mark.parametrize("kind", KINDS)
def test_a_schema_is_one_object_that_refers_to_nothing(kind: type) -> None:
    schema = json_schema(kind)
    assert schema["type"] == "object"
    assert "$ref" not in json.dumps(schema)
