"""Devices on MQTT: an open broker, injected configuration, foreign devices, invented people."""

from __future__ import annotations

from typing import Any

import pytest

from housefly.config.site import Site, site_from_tree
from housefly.errors import ConfigError
from housefly.messages import Observation, RoomEvent
from housefly.sensors.device_monitor import MAX_THINGS, DeviceMonitor
from housefly.sensors.mqtt import MqttSensors
from housefly.wires.devices import DeviceAddress, device_kind


@pytest.mark.parametrize("broker", ["0.0.0.0", "::", "192.168.1.5", "broker.example", ""])
def test_a_broker_of_our_own_that_others_reach_is_refused(broker: str) -> None:
    with pytest.raises(ConfigError, match="loopback"):
        site_from_tree({"mqtt": {"broker": broker, "start": True}})


@pytest.mark.parametrize("broker", ["127.0.0.1", "127.3.2.1", "localhost", "::1"])
def test_a_broker_of_our_own_on_loopback_is_allowed(broker: str) -> None:
    assert site_from_tree({"mqtt": {"broker": broker, "start": True}}).mqtt.broker == broker


FLIES_BY_ITSELF = {"mqtt_requests": "auto", "mqtt_clients": ["panel"]}
ASKS_NOBODY = [{"start": True}, {"start": True, "username": "panel"}, {}]


@pytest.mark.parametrize("mqtt", ASKS_NOBODY, ids=["our own", "our own, with a name", "no name"])
def test_nobody_flies_without_a_yes_through_a_broker_that_asks_nobody_who_he_is(
    mqtt: dict[str, Any],
) -> None:
    """Whoever shares the machine could write to the topic of a client that flies by itself."""
    tree = {"mqtt": {"broker": "127.0.0.1", **mqtt}, "tasks": FLIES_BY_ITSELF}
    with pytest.raises(ConfigError, match=r'mqtt\.username.*tasks\.mqtt_requests = "ask"'):
        site_from_tree(tree)


def test_who_may_fly_by_itself_is_believed_of_a_broker_with_users() -> None:
    site = site_from_tree(
        {"mqtt": {"broker": "127.0.0.1", "username": "room"}, "tasks": FLIES_BY_ITSELF}
    )
    assert site.tasks.mqtt_requests == "auto"


@pytest.mark.parametrize(
    "broker",
    ["127.0.0.1\nlistener 1883 0.0.0.0", "127.0.0.1\n", "a b", "a\tb", "\0", "x\r\ny", "-c/etc/x"],
)
def test_a_broker_name_cannot_carry_lines_of_configuration(broker: str) -> None:
    with pytest.raises(ConfigError) as raised:
        site_from_tree({"mqtt": {"broker": broker}})
    assert raised.value.key == "mqtt.broker"


@pytest.mark.parametrize("entry", ["door", "door/", "/x", "door/a/b", "door/a b", "door/a\n"])
def test_an_entry_of_the_list_of_allowed_devices_is_checked(entry: str) -> None:
    with pytest.raises(ConfigError, match=r"mqtt\.allow"):
        site_from_tree({"mqtt": {"allow": [entry]}})


class _Message:
    """What the driver reads of a message of the broker."""

    def __init__(self, topic: str, payload: str) -> None:
        self.topic, self.payload, self.retain = _Topic(topic), payload.encode(), False


class _Topic:
    def __init__(self, value: str) -> None:
        self.value = value


def told(sensors: MqttSensors, *messages: tuple[str, str]) -> list[Observation | RoomEvent]:
    heard: list[Observation | RoomEvent] = []
    for topic, payload in messages:
        sensors._take(_Message(f"housefly/bsen/{topic}", payload), heard.append)  # type: ignore[arg-type]
    return heard


def sensors(**keys: Any) -> MqttSensors:
    return MqttSensors(site_from_tree({"mqtt": {"broker": "127.0.0.1", **keys}}).mqtt)


def test_only_allowed_devices_are_listened_to_and_none_locks_another_out() -> None:
    listed = sensors(allow=["door/entrance"])
    foreign = [("doorbell/entrance/state", "{}"), ("door/other/state", '{"open": true}')]
    assert told(listed, *foreign) == []
    assert listed.counts["strange"] == 2
    (seen,) = told(listed, ("door/entrance/state", '{"open": true}'))
    assert isinstance(seen, Observation) and seen.thing == "entrance"


def test_a_flood_of_foreign_devices_takes_no_place_of_the_allowed_ones() -> None:
    listed = sensors(allow=["door/entrance"])
    assert told(listed, *((f"door/d{n}/state", '{"open": true}') for n in range(1000))) == []
    assert told(listed, ("door/entrance/state", '{"open": true}'))


def test_a_device_cannot_invent_thousands_of_people() -> None:
    floor = sensors(rate_max_hz=1000.0)
    people = [
        ("floor/floor-1/state", f'{{"people": [{", ".join(rows)}]}}')
        for rows in (
            [f'{{"id": "p{64 * n + k}", "x": 1.0, "y": 1.0}}' for k in range(64)] for n in range(40)
        )
    ]
    seen = {value.thing for value in told(floor, *people)}
    assert len(seen) <= MAX_THINGS


def test_things_of_long_ago_make_room_for_new_ones() -> None:
    monitor = DeviceMonitor(
        DeviceAddress("bsen", "floor", "f"), device_kind(DeviceAddress("bsen", "floor", "f")), 50.0
    )
    assert all(monitor.admit_thing(f"a{n}", 0.0) for n in range(MAX_THINGS))
    assert not monitor.admit_thing("b", 10.0)
    assert monitor.admit_thing("a1", 20.0)
    assert monitor.counts["too many things"] == 1
    assert monitor.admit_thing("b", 4000.0)


def test_no_device_is_listened_to_unless_the_site_says_so() -> None:
    assert Site().mqtt.broker == "" and not Site().mqtt.start
