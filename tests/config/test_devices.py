"""The part of a site file about devices: ranges, and no MQTT by default."""

from __future__ import annotations

from typing import Any

import pytest

from housefly.config.site import Site, site_from_tree
from housefly.errors import ConfigError


def test_a_site_has_no_broker_and_no_scene_unless_it_names_them() -> None:
    assert Site().mqtt.broker == ""
    assert Site().twin.scene == ""


@pytest.mark.parametrize(
    ("mqtt", "key", "words"),
    [
        ({"port": -1}, "mqtt.port", "allowed: a number from 0 to 65535"),
        ({"rate_max_hz": 5000}, "mqtt.rate_max_hz", "allowed: a number from 0.1 to 1000 Hz"),
        ({"site": "My Home"}, "mqtt.site", "'My Home'"),
        (
            {"devices": [{"id": "f", "yaw": 9.0}]},
            "mqtt.devices.0.yaw",
            "allowed: a number from -6.3 to 6.3 rad",
        ),
        ({"devices": [{"yaw": 1.0}]}, "mqtt.devices.0.id", "is missing"),
        ({"tags": [{"tag": "a b", "thing": "cup"}]}, "mqtt.tags.0.tag", "'a b'"),
        ({"brokr": "x"}, "mqtt.brokr", "is not a known key"),
    ],
)
def test_a_bad_value_is_named_with_its_range(mqtt: dict[str, Any], key: str, words: str) -> None:
    with pytest.raises(ConfigError) as raised:
        site_from_tree({"mqtt": mqtt})
    assert raised.value.key == key
    assert words in raised.value.problem
