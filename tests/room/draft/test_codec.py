"""A draft as JSON: the same draft comes back, and every value is checked."""

from __future__ import annotations

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import ConfigError
from housefly.room.draft.codec import draft_from_json, draft_to_json
from housefly.room.draft.model import (
    DraftBox,
    DraftDrone,
    DraftPlace,
    DraftTracking,
    DraftWall,
    DraftZone,
    FramePoint,
    SiteDraft,
)

metres = st.floats(-1000.0, 1000.0)
sizes = st.floats(0.01, 1000.0)
heights = st.floats(0.0, 100.0)
words = st.text(st.characters(exclude_categories=("C",)), min_size=1, max_size=60)
points = st.tuples(metres, metres)
spots = st.tuples(metres, metres, metres)
corners = st.tuples(metres, metres, metres, metres)
sides = st.floats(-100.0, 100.0)
floors = st.tuples(sides, sides, sides, sides)
drafts = st.builds(
    SiteDraft,
    name=words,
    bounds=st.none() | floors,
    height=st.floats(1.0, 100.0),
    walls=st.lists(st.builds(DraftWall, points, points, st.floats(0.01, 5.0)), max_size=2).map(
        tuple
    ),
    furniture=st.lists(
        st.builds(DraftBox, words, metres, metres, sizes, sizes, heights), max_size=2
    ).map(tuple),
    pad=st.none() | points,
    pad_yaw=st.floats(-6.3, 6.3),
    places=st.lists(
        st.builds(
            DraftPlace, st.from_regex(r"\A[a-z0-9][a-z0-9 _-]{0,39}\Z"), metres, metres, words
        ),
        max_size=2,
    ).map(tuple),
    zones=st.lists(st.builds(DraftZone, corners, words), max_size=2).map(tuple),
    tracking=st.none()
    | st.builds(
        DraftTracking,
        st.sampled_from(["vicon", "natnet", "vrpn", "bridge"]),
        words,
        st.none() | st.integers(1, 65535),
        words,
    ),
    frame_points=st.lists(st.builds(FramePoint, words, spots, spots), max_size=3).map(tuple),
    drone=st.none() | st.builds(DraftDrone, words),
    hardware=st.booleans(),
)


@given(drafts)
def test_any_draft_comes_back_as_it_was(draft: SiteDraft) -> None:
    assert draft_from_json(draft_to_json(draft)) == draft


@given(st.recursive(st.none() | st.floats() | st.text() | st.booleans(), st.lists))
def test_nonsense_is_refused_in_words(tree: object) -> None:
    with pytest.raises(ConfigError):
        draft_from_json(json.dumps(tree))


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ('{"bounds": [0, 0, 1e9, 1]}', "bounds.2"),
        ('{"size": 1}', "size: is not a known key"),
        ('{"height": NaN}', "height"),
        ('{"walls": [{"start": [0, 0]}]}', "walls.0.end: is missing"),
        ('{"tracking": {"kind": "wifi", "address": "x"}}', "tracking.kind"),
        ("{", "draft"),
    ],
)
def test_a_bad_value_is_named(text: str, words: str) -> None:
    with pytest.raises(ConfigError, match=words):
        draft_from_json(text)
