"""Measuring devices in the site file: what is refused is named with its range and unit."""

from __future__ import annotations

from typing import Any

import pytest

from housefly.config.measured_devices import UNITS, MeasuredDeviceConfig
from housefly.config.site import site_from_tree
from housefly.errors import ConfigError

PLUG = {"id": "stove-plug", "kind": "power", "thing": "stove", "state_topic": "zigbee2mqtt/plug"}


def test_a_device_with_the_least_that_must_be_said_has_the_defaults_of_its_kind() -> None:
    (row,) = site_from_tree({"mqtt": {"sensors": [{"id": "lamp", "kind": "switch"}]}}).mqtt.sensors
    assert (row.value_unit, row.thing, row.state_topic) == ("", "", "")
    assert MeasuredDeviceConfig(id="t", kind="temperature").value_range == (-100.0, 1000.0)


@pytest.mark.parametrize(
    ("unit", "kind", "theirs", "ours"),
    [
        ("kW", "power", 1.42, 1420.0),
        ("°F", "temperature", 212.0, 100.0),
        ("K", "temperature", 273.15, 0.0),
        ("1", "level", 0.35, 35.0),
        ("", "power", 5.0, 5.0),
    ],
)
def test_values_are_told_in_our_units(unit: str, kind: Any, theirs: float, ours: float) -> None:
    row = MeasuredDeviceConfig(id="a", kind=kind, unit=unit, state_topic="a/b")
    assert row.ours(theirs) == pytest.approx(ours)
    low, high = row.value_range
    assert low <= theirs <= high


def test_every_unit_has_a_range() -> None:
    for kind, units in UNITS.items():
        for unit in units:
            row = MeasuredDeviceConfig(id="a", kind=kind, unit=unit, state_topic="a/b")  # type: ignore[arg-type]
            assert row.value_range[0] < row.value_range[1]


@pytest.mark.parametrize(
    ("change", "key", "words"),
    [
        ({"kind": "humidity"}, "kind", "'switch', 'power', 'temperature', 'contact' or 'level'"),
        ({"unit": "V"}, "", "unit is 'V'; allowed for power: W, kW, mW"),
        ({"kind": "contact", "unit": "W"}, "", 'allowed for contact: "": it has no unit'),
        ({"kind": "switch", "above": 5.0}, "", "min, max, above and below are not for a switch"),
        ({"min": 100.0, "max": 0.0}, "", "min 100 and max 0; allowed: min below max"),
        ({"max": 1e9}, "", "from -100000 to 100000 W"),
        ({"max": 4000.0, "above": 5000.0}, "", "above is 5000; allowed: -100000 to 4000 W"),
        ({"above": 10.0, "below": 20.0}, "", "below (20) is more than above (10) W"),
        ({"state_topic": "zigbee2mqtt/#"}, "state_topic", "zigbee2mqtt/#"),
        ({"state_topic": "", "field": "power"}, "", "field is given without state_topic"),
        (
            {"field": "a..b"},
            "",
            "field: 'a..b' is no path to a value; allowed: up to 8",
        ),
        ({"heartbeat": -1.0}, "heartbeat", "allowed: a number from 0 to 86400 s"),
        ({"thing": "The Stove"}, "thing", "The Stove"),
        ({"above": float("nan")}, "above", "nan"),
    ],
)
def test_a_bad_value_is_named_with_what_is_allowed(
    change: dict[str, Any], key: str, words: str
) -> None:
    with pytest.raises(ConfigError) as raised:
        site_from_tree({"mqtt": {"sensors": [PLUG | change]}})
    assert raised.value.key.startswith("mqtt.sensors.0" + (f".{key}" if key else ""))
    assert words in raised.value.problem


def test_two_devices_of_one_id_are_refused() -> None:
    with pytest.raises(ConfigError, match="two of them have the id 'stove-plug'"):
        site_from_tree({"mqtt": {"sensors": [PLUG, PLUG]}})
