"""One value on a topic of any maker: where it is found, in which unit, and what is refused."""

from __future__ import annotations

import json
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.measured_devices import MeasuredDeviceConfig
from housefly.errors import WireError
from housefly.wires.devices import Channel, Delivered, MeasuredTopic

NOW = 1_800_000_000.0


def read(payload: bytes | object, channel: Channel = Channel.STATE, **config: Any) -> Any:
    """Return the facts of the one observation, or whether the device is online."""
    given_config = {"id": "dev", "kind": "power", "state_topic": "zigbee2mqtt/plug"} | config
    topic = MeasuredTopic(MeasuredDeviceConfig(**given_config), "bsen")
    data = payload if isinstance(payload, bytes) else json.dumps(payload).encode()
    reading = topic.decode(Delivered(topic.address, channel, data, NOW))
    if channel is Channel.AVAILABILITY:
        return reading.online
    if reading.absent:
        return reading.absent
    (seen,) = reading.observations
    if not seen.valid:
        return reading.refused[0]
    assert (seen.thing, seen.source, seen.captured_at) == ("dev", "dev", NOW)
    return dict(seen.facts)


@pytest.mark.parametrize(
    ("payload", "config", "facts"),
    [
        ({"power": 1420, "linkquality": 90, "state": "ON"}, {}, {"power": 1420.0}),
        ({"ENERGY": {"Power": 1.42}}, {"field": "ENERGY.Power", "unit": "kW"}, {"power": 1420.0}),
        (b"12.5", {}, {"power": 12.5}),
        ({"state": "ON"}, {"kind": "switch"}, {"on": True}),
        (b"off", {"kind": "switch"}, {"on": False}),
        (b"heat", {"kind": "switch", "payload_on": "heat", "payload_off": "idle"}, {"on": True}),
        ({"contact": True}, {"kind": "contact"}, {"open": False, "kind": "contact"}),
        (b"ON", {"kind": "contact"}, {"open": True, "kind": "contact"}),
        ({"temperature": 68}, {"kind": "temperature", "unit": "°F"}, {"temperature_c": 20.0}),
        ({"fill": 0.35}, {"kind": "level", "unit": "1", "field": "fill"}, {"level_percent": 35.0}),
    ],
)
def test_a_value_is_found_where_the_site_file_says(
    payload: object, config: dict[str, Any], facts: dict[str, object]
) -> None:
    assert read(payload, **config) == pytest.approx(facts)


@pytest.mark.parametrize(
    ("payload", "config", "words"),
    [
        ({"power": 9999}, {"max": 4000.0},
         "zigbee2mqtt/plug.power is 9999; allowed: a number from -100000 to 4000 W"),
        ({"power": 9.0}, {"max": 4.0, "unit": "kW"}, "allowed: a number from -100 to 4 kW"),
        ({"power": "much"}, {}, "zigbee2mqtt/plug.power is 'much'"),
        ({"power": {"now": 3}}, {}, "mqtt.sensors, dev: field names the value in it"),
        (b"{broken", {}, "zigbee2mqtt/plug: not JSON"),
        ({"temperature": 5000}, {"kind": "temperature"}, "from -100 to 1000 °C"),
        (b"x" * 20_000, {}, "allowed: up to 16384 bytes"),
    ],
)  # fmt: skip
def test_what_is_refused_names_topic_value_range_and_unit(
    payload: object, config: dict[str, Any], words: str
) -> None:
    with pytest.raises(WireError) as raised:
        read(payload, **config)
    assert words in str(raised.value)


@pytest.mark.parametrize(
    ("payload", "config", "words"),
    [
        ({"state": "on", "current": 2}, {},
         "plug.power is missing; there is state, current; mqtt.sensors, dev: field names the"),
        ({"ENERGY": 3}, {"field": "ENERGY.Power"},
         "plug.ENERGY.Power is missing; what stands there holds no other value"),
        ({"params": []}, {"field": "params[0].value"},
         "plug.params.0 is missing; the array has 0 elements, from 0 on"),
        (b"NaN", {}, "zigbee2mqtt/plug is 'NaN': the device does not know it"),
        ({"power": None}, {}, "zigbee2mqtt/plug.power is null: the device does not know it"),
        (b"perhaps", {"kind": "switch"}, '"ON" or "OFF", true or false'),
        (b"perhaps", {"kind": "switch", "payload_on": "heat"}, '"heat" or a word for off'),
        (b"ajar", {"kind": "contact"}, 'true or "closed", false or "open"'),
        (b"1", {"kind": "contact"}, "payload_on and payload_off name others"),
    ],
)  # fmt: skip
def test_what_says_nothing_of_its_state_is_no_state_and_says_why(
    payload: object, config: dict[str, Any], words: str
) -> None:
    assert words in read(payload, **config)


@pytest.mark.parametrize(
    ("maker", "said", "is_open"),
    [
        ("Shelly", b"close", False), ("Shelly", b"open", True), ("FHEM", b"tilted", True),
        ("openHAB", b"CLOSED", False), ("Home Assistant", b"off", False),
        ("Z-Wave JS UI", {"contact": "Window/door is open"}, True),
        ("Zigbee2MQTT", {"contact": False}, True), ("covers", b"closing", True),
    ],
)  # fmt: skip
def test_contacts_of_many_makers_are_understood_and_can_be_turned_round(
    maker: str, said: object, is_open: bool
) -> None:
    assert read(said, kind="contact")["open"] is is_open, maker
    assert read(said, kind="contact", invert=True)["open"] is not is_open


def test_own_words_of_a_contact_are_those_of_the_site_file() -> None:
    handle = {"kind": "contact", "field": "val", "payload_on": "1, 2", "payload_off": "0"}
    assert [read({"val": n}, **handle)["open"] for n in (0, 1, 2)] == [False, True, True]
    assert "allowed" in read({"val": 3}, **handle)


@pytest.mark.parametrize(
    ("payload", "field"),
    [
        ({"ENERGY": {"Power": [7, 8]}}, "ENERGY.Power.1"),
        ({"params": [{"value": "8 W"}]}, "params[0].value"),
        ({"params": {"switch:0": {"apower": "8,0"}}}, "params.switch:0.apower"),
        ([3, [7, 8]], "[1][1]"),
    ],
)
def test_an_element_of_an_array_can_be_named(payload: object, field: str) -> None:
    assert read(payload, field=field) == {"power": 8.0}


@pytest.mark.parametrize(
    ("config", "words"),
    [
        ({"field": "params[x]"}, "is no path to a value; allowed: up to 8 keys"),
        ({"field": "a..b"}, "is no path to a value"),
        ({"invert": True}, "invert are for a switch or a contact, not for power"),
        ({"kind": "contact", "payload_on": "0,1", "payload_off": "0"}, "'0' is in payload_on and"),
    ],
)
def test_a_row_of_the_site_file_that_makes_no_sense_is_refused(
    config: dict[str, Any], words: str
) -> None:
    with pytest.raises(ValueError, match=words):
        read(b"1", **config)


@pytest.mark.parametrize("payload", [b"online", {"state": "online"}, b"ONLINE", b"true",
                                     {"online": True}, b"ready"])  # fmt: skip
def test_availability_is_a_word_bare_or_in_json(payload: object) -> None:
    assert read(payload, Channel.AVAILABILITY) is True
    with pytest.raises(WireError, match="online or offline"):
        read(b"perhaps", Channel.AVAILABILITY)


@given(
    st.binary(max_size=100) | st.floats().map(lambda x: str(x).encode()),
    st.sampled_from(["switch", "power", "temperature", "contact", "level"]),
)
def test_any_payload_is_understood_or_refused_by_its_topic(payload: bytes, kind: str) -> None:
    try:
        read(payload, kind=kind)
    except WireError as error:
        assert "zigbee2mqtt/plug" in str(error)
