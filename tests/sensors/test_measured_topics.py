"""Measuring devices at a real broker: on our own topics and on those of other makers."""

from __future__ import annotations

import json

import pytest

pytestmark = pytest.mark.wire

PLUG = {
    "id": "stove-plug", "kind": "power", "thing": "stove", "state_topic": "zigbee2mqtt/plug",
    "availability_topic": "zigbee2mqtt/plug/availability", "max": 4000.0, "heartbeat": 600.0,
}  # fmt: skip
SWITCH = {"id": "stove-switch", "kind": "switch", "state_topic": "zigbee2mqtt/plug"}
PROBE = {"id": "probe", "kind": "temperature", "max": 300.0, "heartbeat": 1.0}


async def test_one_message_of_a_plug_is_a_power_and_a_switch(broker, listen, until):
    async with listen(broker.port, sensors=[PLUG, SWITCH]) as heard, broker.client() as maker:
        message = {"power": 1420.0, "state": "ON", "linkquality": 90}
        await maker.publish("zigbee2mqtt/plug", json.dumps(message))
        await until(lambda: len(heard.told) == 2)
        assert {row.source: dict(row.facts) for row in heard.observations} == {
            "stove-plug": {"power": 1420.0},
            "stove-switch": {"on": True},
        }
        assert heard.health("stove-plug").connected


async def test_a_device_of_the_site_file_is_listed_before_it_speaks(broker, listen):
    async with listen(broker.port, sensors=[PLUG]) as heard:
        health = heard.health("stove-plug")
        assert (health.connected, health.title) == (False, "Power meter stove-plug")
        assert health.problem == "not heard yet; it sends its state at least every 600 s"


async def test_garbage_and_what_is_out_of_range_is_counted_and_named_with_its_unit(
    broker, listen, until
):
    async with listen(broker.port, sensors=[PLUG, PROBE]) as heard, broker.client() as maker:
        await maker.publish("zigbee2mqtt/plug", json.dumps({"power": 99_999}))
        await until(lambda: heard.counts("stove-plug").get("malformed") == 1)
        assert heard.health("stove-plug").problem == (
            "zigbee2mqtt/plug.power is 99999; allowed: a number from -100000 to 4000 W"
        )
        await maker.publish("housefly/bsen/temperature/probe/state", '{"temperature": 301}')
        await until(lambda: heard.counts("probe").get("malformed") == 1)
        assert "a number from -100 to 300 °C" in heard.health("probe").problem
        await maker.publish("zigbee2mqtt/plug", json.dumps({"power": 3.0}))
        await maker.publish("housefly/bsen/temperature/probe/state", '{"temperature": 21.5}')
        await until(lambda: len(heard.told) == 2)
        assert dict(heard.observations[-1].facts) == {"temperature_c": 21.5}


async def test_a_device_that_says_offline_is_and_its_heartbeat_is_that_of_the_site_file(
    broker, listen, until
):
    async with listen(broker.port, sensors=[PLUG, PROBE]) as heard, broker.client() as maker:
        await maker.publish("zigbee2mqtt/plug", '{"power": 3.0}')
        await maker.publish("housefly/bsen/temperature/probe/state", '{"temperature": 21.5}')
        await until(lambda: len(heard.told) == 2)
        await maker.publish("zigbee2mqtt/plug/availability", '{"state": "offline"}')
        await until(lambda: not heard.health("stove-plug").connected)
        assert heard.health("stove-plug").problem.startswith("offline")
        assert heard.health("stove-plug").is_offline
        assert not heard.health("probe").is_offline
        await until(lambda: heard.health("probe").problem.startswith("silent for 2 s"))


async def test_nobody_takes_a_device_of_the_site_files_place(broker, listen, until):
    allowed = ("door/entrance-door",)
    async with (
        listen(broker.port, sensors=[PLUG, PROBE], allow=allowed) as heard,
        broker.client() as maker,
    ):
        await maker.publish("housefly/bsen/power/stove-plug/state", '{"power": 3.0}')
        await until(lambda: "speaks on zigbee2mqtt/plug by the site file" in heard.sensors.problem)
        await maker.publish("housefly/bsen/door/probe/state", '{"open": true}')
        await until(lambda: "probe is a temperature already" in heard.sensors.problem)
        await maker.publish("housefly/bsen/temperature/probe/state", '{"temperature": 21.5}')
        await until(lambda: heard.told)
        assert [row.source for row in heard.told] == ["probe"]


async def test_a_state_that_the_broker_kept_is_told_as_such_and_is_no_sign_of_life(
    broker, listen, until
):
    async with broker.client() as maker:
        await maker.publish("zigbee2mqtt/plug", '{"power": 1420.0}', retain=True)
        async with listen(broker.port, sensors=[PLUG]) as heard:
            await until(lambda: heard.told)
            assert dict(heard.observations[0].facts) == {"power": 1420.0, "retained": True}
            assert not heard.health("stove-plug").connected


async def test_what_shares_the_state_topic_of_a_device_is_offline_with_it(broker, listen, until):
    async with listen(broker.port, sensors=[PLUG, SWITCH]) as heard, broker.client() as maker:
        await maker.publish("zigbee2mqtt/plug", '{"power": 3.0, "state": "ON"}')
        await until(lambda: len(heard.told) == 2)
        await maker.publish("zigbee2mqtt/plug/availability", "offline")
        await until(lambda: heard.health("stove-switch").is_offline)


async def test_what_the_broker_kept_of_what_was_heard_is_nothing_new_after_a_break(
    broker, listen, until
):
    async with listen(broker.port, sensors=[PLUG, PROBE]) as heard:
        async with broker.client() as maker:
            await maker.publish("zigbee2mqtt/plug", '{"power": 1420.0}', retain=True)
            await until(lambda: heard.told)
        await broker.kill()
        await until(lambda: not heard.sensors.connected)
        await broker.start()
        async with broker.client() as maker:
            await maker.publish("zigbee2mqtt/plug", '{"power": 1420.0}', retain=True)
            await until(lambda: heard.sensors.connected)
            await maker.publish("housefly/bsen/temperature/probe/state", '{"temperature": 21.5}')
            await until(lambda: heard.told[-1].source == "probe")
            assert not [row for row in heard.observations if dict(row.facts).get("retained")]
            await maker.publish("zigbee2mqtt/plug", '{"power": 2.0}')
            await until(lambda: dict(heard.told[-1].facts) == {"power": 2.0})
