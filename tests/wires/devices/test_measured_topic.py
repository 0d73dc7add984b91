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
    (seen,) = reading.observations
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
        ({"state": "on"}, {}, "zigbee2mqtt/plug.power is missing; mqtt.sensors, dev: field names"),
        ({"ENERGY": 3}, {"field": "ENERGY.Power"}, "plug.ENERGY.Power is missing"),
        (b"{broken", {}, "zigbee2mqtt/plug: not JSON"),
        (b"NaN", {}, "zigbee2mqtt/plug is 'NaN'; allowed: a number"),
        ({"temperature": 5000}, {"kind": "temperature"}, "from -100 to 1000 °C"),
        (b"perhaps", {"kind": "switch"}, '"ON" or "OFF", true or false'),
        (b"perhaps", {"kind": "switch", "payload_on": "heat"}, '"heat" or "OFF"'),
        (b"x" * 20_000, {}, "allowed: up to 16384 bytes"),
    ],
)  # fmt: skip
def test_what_is_refused_names_topic_value_range_and_unit(
    payload: object, config: dict[str, Any], words: str
) -> None:
    with pytest.raises(WireError) as raised:
        read(payload, **config)
    assert words in str(raised.value)


@pytest.mark.parametrize("payload", [b"online", {"state": "online"}, b"ONLINE"])
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
