"""Devices over a real broker, and everything that goes wrong with them."""

from __future__ import annotations

import json
import time

import pytest

pytestmark = pytest.mark.wire

DOOR = "housefly/bsen/door/entrance-door"


async def test_a_door_contact_is_heard_as_an_observation(broker, listen, until):
    async with listen(broker.port) as heard, broker.client() as maker:
        await maker.publish(f"{DOOR}/state", json.dumps({"open": True, "time": time.time(), "battery": 0.8}))
        await until(lambda: heard.told)
        (door,) = heard.observations
        assert (door.thing, door.source, dict(door.facts)) == ("entrance-door", "entrance-door", {"open": True, "battery": 0.8})
        assert 0.0 <= door.received_at - door.captured_at < 2.0
        assert heard.health("entrance-door").connected
