"""Topics and keys of Home Assistant's tree."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.homeassistant.topics import HomeTopics, topic_key
from housefly.wires.devices import site_subscription

TOPICS = HomeTopics("home")
NAMES = st.text(min_size=1, max_size=20)


@given(NAMES, NAMES)
def test_two_names_never_share_a_key(one: str, other: str) -> None:
    assert (topic_key(one) == topic_key(other)) == (one == other)


@given(NAMES)
def test_a_key_is_a_level_of_a_topic_and_an_id_of_home_assistant(name: str) -> None:
    assert set(topic_key(name)) <= set(
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-"
    )


@given(NAMES)
def test_what_is_announced_is_known_again_in_both_forms(name: str) -> None:
    key = topic_key(name)
    for topic in (TOPICS.entity_config("button", key), TOPICS.device_config(key)):
        assert TOPICS.announced_key(topic) == key
        assert HomeTopics("other").announced_key(topic) == ""


@given(st.text(max_size=60))
def test_no_topic_of_others_is_taken_for_ours(topic: str) -> None:
    assert TOPICS.announced_key(topic) == ""


def test_no_topic_lies_where_devices_speak() -> None:
    devices = site_subscription("home").removesuffix("#")
    ours = (TOPICS.availability, TOPICS.state("x"), TOPICS.commands, TOPICS.picture("x"))
    assert not any(topic.startswith(devices) for topic in ours)
