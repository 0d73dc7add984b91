"""The channels of a site: each once, with a schema that a reader of ROS 2 takes."""

from __future__ import annotations

import json
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st
from mcap.records import Schema
from mcap_ros2.decoder import DecoderFactory

from housefly.config.site import Site, changed
from housefly.foxglove.channels import Encoding, channels_of

NAMES = st.lists(st.text(min_size=1, max_size=8), max_size=5)
DRONES = [{"name": "red"}, {"name": "blue", "address": "127.0.0.2", "pad": (4.0, 4.0, 0.0)}]


@given(NAMES)
def test_each_topic_is_there_once_and_is_one_that_ros_2_allows(bodies: list[str]) -> None:
    people = Site().people.model_copy(update={"bodies": tuple(bodies)})
    topics = [one.topic for one in channels_of(Site().model_copy(update={"people": people}))]
    assert len(topics) == len(set(topics))
    assert all(re.fullmatch(r"(?:/[A-Za-z][A-Za-z0-9_]*)+", topic) for topic in topics)


def test_each_drone_has_its_own_channels_and_the_room_has_one_of_each() -> None:
    topics = [one.topic for one in channels_of(changed(Site(), drones=DRONES))]
    assert {"/red/odom", "/blue/odom", "/red/camera", "/blue/map"} <= set(topics)
    assert topics.count("/tasks") == topics.count("/tf") == 1


@pytest.mark.parametrize("channel", channels_of(Site()), ids=lambda channel: channel.topic)
def test_a_schema_is_complete(channel: object) -> None:
    (one,) = (known for known in channels_of(Site()) if known == channel)
    if one.encoding is Encoding.JSON:
        assert json.loads(one.schema)["type"] == "object"
    else:
        schema = Schema(1, one.schema.encode(), "ros2msg", one.schema_name)
        assert DecoderFactory().decoder_for("cdr", schema) is not None


@pytest.mark.parametrize(
    ("change", "gone"),
    [
        ({"tasks__enabled": False}, "/tasks"),
        ({"hub__enabled": False}, "/room/events"),
        ({"drone__has_video": False}, "/drone/camera"),
    ],
)
def test_what_a_site_does_not_have_is_not_offered(change: dict[str, bool], gone: str) -> None:
    assert gone in {one.topic for one in channels_of(Site())}
    assert gone not in {one.topic for one in channels_of(changed(Site(), **change))}
