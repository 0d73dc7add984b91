"""The JSON form of what queries carry."""

from __future__ import annotations

import json
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import WireError
from housefly.hub.api.pilot_queries import GridView, OutlineView, PlaceView, PlanRequest, RoomView
from housefly.hub.api.pilot_queries_json import from_json, to_json
from housefly.messages import Path, PlanAnswer

FINITE = st.floats(allow_nan=False, allow_infinity=False)
POINT = st.tuples(FINITE, FINITE)
TEXT = st.text(st.characters(exclude_categories=["Cs"]), max_size=20)
PATHS = st.builds(Path, st.lists(POINT, max_size=4).map(tuple), FINITE, FINITE)


@given(st.builds(PlanRequest, TEXT, st.none() | POINT, st.none() | POINT))
def test_every_request_comes_back(request: PlanRequest) -> None:
    assert from_json(PlanRequest, to_json(request)) == request


@given(st.builds(PlanAnswer, POINT, POINT, st.none() | PATHS, TEXT, st.none() | POINT, FINITE))
def test_every_answer_comes_back(answer: PlanAnswer) -> None:
    assert from_json(PlanAnswer, to_json(answer)) == answer


def test_a_room_comes_back() -> None:
    room = RoomView(
        site="B-sen",
        mode="default",
        bounds=(0.0, 0.0, 4.0, 3.0),
        grid=GridView((0.0, 0.0), 1.0, 4, 3, ("....", ".#v.", "xxxi")),
        outlines=(OutlineView("sofa", ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0)), 0.8, "#aabbcc"),),
        places=(PlaceView("home", "Home", (1.0, 1.0), (2.0, 1.0, 1.0)),),
        home=(1.0, 1.0),
        flight_height=1.1,
        visitor=None,
        limits={"speed": 0.5},
    )
    assert from_json(RoomView, to_json(room)) == room


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "required"),
        ("null", "PlanRequest|dictionary"),
        ("{},{}", "at most 1"),
        ('{"goal": [NaN, 1]}', "goal.0: .*finite"),
        ('{"goal": [1e999, 1]}', "goal.0: .*finite"),
        ('{"goal": ["1", 2]}', "goal.0: .*number"),
        ('{"goal": [1]}', "goal"),
        ('{"goal": [1, 2, 3]}', "goal"),
        ('{"place": 7}', "place: .*string"),
        ('{"gaol": [1, 2]}', "gaol: unexpected"),
        ('{"place": "\\ud800"}', "JSON"),
        ('{"place": "\ud800"}', "unicode"),
    ],
)
def test_a_bad_request_is_refused_in_words(text: str, words: str) -> None:
    with pytest.raises(WireError, match=f"(?i){words}"):
        from_json(PlanRequest, text)


def test_a_number_inside_a_nested_path_must_be_finite_too() -> None:
    tree = json.loads(to_json(PlanAnswer((0.0, 0.0), (1.0, 1.0), Path(((0.0, 0.0),), 1.0, 1.0))))
    tree["path"]["length"] = math.inf
    with pytest.raises(WireError, match="finite"):
        from_json(PlanAnswer, json.dumps(tree))
    with pytest.raises(WireError, match="no JSON form"):
        to_json(PlanAnswer((0.0, math.nan), (1.0, 1.0), None))


@given(st.text(max_size=60))
def test_garbage_is_a_wire_error_and_nothing_else(text: str) -> None:
    try:
        from_json(PlanRequest, text)
    except WireError as error:
        assert str(error)
