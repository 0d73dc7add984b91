"""What a device's last report is in Home Assistant."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.homeassistant.device_entities import bell_message, device_states, is_device
from housefly.homeassistant.topics import HomeTopics
from housefly.hub.api.answers import EventAnswer, SensorAnswer, SourceAnswer
from housefly.messages.world import Fact
from housefly.wires.devices import KINDS

TOPICS = HomeTopics("home")
FACTS = ("open", "on", "occupied", "motion", "power", "temperature_c", "battery", "people", "load")
VALUES = st.booleans() | st.floats(-1e6, 1e6) | st.text(max_size=300)


def sensor(kind: str, *, connected: bool = True) -> SensorAnswer:
    return SensorAnswer("one", kind, "One", connected, 1.0, 0.1, "", {})


def source(**facts: Fact) -> SourceAnswer:
    return SourceAnswer("one", 0.1, None, "", True, facts)


def state(kind: str, told: SourceAnswer | None, fact: str) -> str:
    return device_states(sensor(kind), told, TOPICS)[TOPICS.state(f"device-one-{fact}")].decode()


@given(st.sampled_from(sorted(KINDS)), st.dictionaries(st.sampled_from(FACTS), VALUES))
def test_whatever_a_device_says_its_states_are_states(kind: str, facts: dict[str, Fact]) -> None:
    found = device_states(sensor(kind), source(**facts), TOPICS)
    assert all(0 < len(payload.decode()) <= 255 for payload in found.values())


@pytest.mark.parametrize(
    ("kind", "facts", "fact", "shown"),
    [
        ("door", {"open": True}, "open", "ON"),
        ("contact", {"open": False}, "open", "OFF"),
        ("power", {"power": 1420.0}, "power", "1420"),
        ("temperature", {"temperature_c": 21.5}, "temperature__c", "21.5"),
        ("bed", {"occupied": True}, "occupied", "ON"),
        ("floor", {"people": 2.0}, "people", "2"),
        ("cabinet", {"contents": "cup,plate"}, "contents", "cup,plate"),
        ("cabinet", {"contents": ""}, "contents", "empty"),
        ("door", {"open": True, "battery": 0.93}, "battery", "93"),
    ],
)
def test_a_fact_is_shown_as_home_assistant_wants_it(
    kind: str, facts: dict[str, Fact], fact: str, shown: str
) -> None:
    assert state(kind, source(**facts), fact) == shown


def test_what_is_not_known_now_is_unknown_and_not_the_old_value() -> None:
    old = source(open=True)
    kept = source(open=True, retained=True)
    for told in (None, replace(old, valid=False), kept, source()):
        assert state("door", told, "open") == "None"


def test_who_is_silent_is_not_there_and_a_scanner_is_only_heard_or_not() -> None:
    quiet = device_states(sensor("door", connected=False), source(open=True), TOPICS)
    assert quiet[TOPICS.part_availability("device-one")] == b"offline"
    assert not is_device(sensor("laser scanner"))
    assert device_states(sensor("laser scanner"), None, TOPICS) == {
        TOPICS.state("device-one"): b"ON"
    }


def test_only_a_bell_rings() -> None:
    rung = EventAnswer("bell pressed", "doorbell", 7.0, "doorbell", "", 1.0, {})
    topic, payload = bell_message(rung, TOPICS) or ("", b"")
    assert (topic, payload) == (
        "housefly-home/home/event/device-doorbell",
        b'{"event_type": "press", "at": 7.0}',
    )
    assert bell_message(replace(rung, kind="door opened"), TOPICS) is None
