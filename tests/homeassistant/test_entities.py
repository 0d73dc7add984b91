"""What is announced: everything once, in either form."""

from __future__ import annotations

import json
from typing import Any

import pytest

from housefly.clock import SteppedClock
from housefly.config.site import Site, site_from_tree
from housefly.homeassistant.entities import discovery_documents
from housefly.homeassistant.home_view import HomeView
from housefly.hub.api.answers import SensorAnswer
from housefly.hub.situations.kinds import SituationKind
from housefly.room.files import load_room
from housefly.wires.devices import KINDS

SENSORS = tuple(
    SensorAnswer(f"{kind}-1", kind, f"The {kind}", True, 1.0, 0.1, "", {})
    for kind in (*KINDS, "vicon", "laser scanner")
)
TWO = [
    {"name": "red", "address": "127.0.0.1"},
    {"name": "blue", "address": "127.0.0.2", "pad": [4.0, 1.5, 0.0]},
]


def site(**home: Any) -> Site:
    tree = {"mqtt": {"broker": "127.0.0.1", "site": "home"}, "homeassistant": {"enabled": True}}
    tree["homeassistant"] |= home
    return site_from_tree({**tree, "drones": TWO})


def view_of(site: Site) -> HomeView:
    view = HomeView(site, load_room(site.room.model), SteppedClock())
    view.hear_sensors(SENSORS)
    return view


@pytest.fixture(scope="module")
def view() -> HomeView:
    return view_of(site(pictures=True))


def test_both_forms_announce_the_same(view: HomeView) -> None:
    entities = view.entities()
    one = discovery_documents(entities, view.topics, "entity")
    many = discovery_documents(entities, view.topics, "device")
    ids = {json.loads(payload)["unique_id"] for payload in one.values()}
    assert len(one) == len(entities) == len(ids)
    parts = [part for doc in many.values() for part in json.loads(doc)["components"].values()]
    assert {part["unique_id"] for part in parts} == ids
    assert len(parts) == len(ids) and all("platform" in part for part in parts)
    for document in (*one.values(), *many.values()):
        assert json.loads(document)["device"]["identifiers"] and len(document) < 60_000


def test_everything_is_away_with_housefly(view: HomeView) -> None:
    for payload in discovery_documents(view.entities(), view.topics).values():
        topics = [one["topic"] for one in json.loads(payload)["availability"]]
        assert topics[0] == view.topics.availability


def test_every_device_sensor_situation_and_place_is_there(view: HomeView) -> None:
    names = {(one.component, one.device.name, one.name) for one in view.entities()}
    for sensor in SENSORS:
        assert any(sensor.title in (device, name) for _, device, name in names)
    for kind in SituationKind:
        assert ("binary_sensor", "B-sen", kind.value.capitalize()) in names
    places = [place for place in view.places if place.name != "home"]
    for drone in ("red", "blue"):
        for place in places:
            assert ("button", drone, f"Go to {place.title or place.name}") in names
        for what in ("vacuum", "device_tracker", "camera", "image"):
            assert any((what, drone) == name[:2] for name in names)
        assert {("button", drone, "STOP"), ("button", drone, "Land")} <= names


def test_nothing_but_stop_can_be_pressed_where_nothing_may_be_asked_for() -> None:
    told = view_of(site(requests="off")).entities()
    assert {one.name for one in told if "command_topic" in one.settings} == {"STOP"}
    assert not any(one.component in ("camera", "image") for one in told)


def test_a_place_is_a_button_and_never_a_select(view: HomeView) -> None:
    """A select acts on change: one slip of the finger would fly."""
    assert {one.component for one in view.entities()} == {
        *("binary_sensor", "button", "camera", "device_tracker", "event", "image"),
        *("sensor", "vacuum"),
    }


def test_each_state_has_its_entity_and_each_entity_its_state(view: HomeView) -> None:
    read = {
        topic
        for one in view.entities()
        for key, topic in one.settings.items()
        if key in ("state_topic", "json_attributes_topic") and one.component != "event"
    }
    states = view.states()
    told = {topic for topic in states if "/availability" not in topic}
    assert told <= read
    silent = read - told
    assert all("/drone-" in topic for topic in silent), "a drone says nothing before its first step"
    assert {one for entity in view.entities() for one in entity.available_with} <= set(states)
