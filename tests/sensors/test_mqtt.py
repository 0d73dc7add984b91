"""Devices over a real broker, and everything that goes wrong with them."""

from __future__ import annotations

import asyncio
import json
import signal
import time

import aiomqtt
import pytest

from housefly.wires.devices import listener_topic

pytestmark = pytest.mark.wire

DOOR, BELL, FLOOR = (
    "housefly/bsen/door/entrance-door",
    "housefly/bsen/doorbell/bell",
    "housefly/bsen/floor/floor-1",
)


def door(is_open: bool = True, **more: object) -> str:
    return json.dumps({"open": is_open, **more})


async def test_a_door_contact_is_heard_as_an_observation(broker, listen, until):
    async with listen(broker.port) as heard, broker.client() as maker:
        await maker.publish(f"{DOOR}/state", door(time=time.time(), battery=0.8))
        await until(lambda: heard.told)
        (seen,) = heard.observations
        assert (seen.thing, seen.source, dict(seen.facts)) == (
            "entrance-door",
            "entrance-door",
            {"open": True, "battery": 0.8},
        )
        assert 0.0 <= seen.received_at - seen.captured_at < 2.0
        health = heard.health("entrance-door")
        assert (health.connected, health.problem, health.title) == (
            True,
            "",
            "Door contact entrance-door",
        )
        assert health.age < 2.0


async def test_the_bell_rings_once_and_a_ring_that_the_broker_kept_does_not_ring_again(
    broker, listen, until
):
    async with broker.client() as maker:
        await maker.publish(f"{BELL}/event", json.dumps({"event": "pressed"}), retain=True)
        async with listen(broker.port) as heard:
            await until(lambda: heard.knows("bell"))
            await maker.publish(f"{BELL}/event", json.dumps({"event": "pressed"}))
            await until(lambda: heard.events)
            assert [(told.kind, told.thing, told.source) for told in heard.events] == [
                ("bell pressed", "bell", "bell")
            ]
            assert heard.counts("bell") == {"heard": 1, "past events": 1}


async def test_a_state_that_the_broker_kept_is_told_as_such_and_is_no_sign_of_life(
    broker, listen, until
):
    async with broker.client() as maker:
        await maker.publish(f"{DOOR}/state", door(time=time.time() - 5000.0), retain=True)
        async with listen(broker.port) as heard:
            await until(lambda: heard.told)
            (seen,) = heard.observations
            assert seen.received_at - seen.captured_at == pytest.approx(5000.0, abs=2.0)
            assert dict(seen.facts)["retained"] is True
            health = heard.health("entrance-door")
            assert not health.connected
            assert health.problem == "not heard yet; it sends its state at least every 60 s"


async def test_a_broker_that_is_killed_and_comes_back_is_found_again(broker, listen, until):
    async with listen(broker.port) as heard:
        async with broker.client() as maker:
            await maker.publish(f"{DOOR}/state", door())
            await until(lambda: heard.told)
        await broker.kill()
        await until(lambda: not heard.sensors.connected)
        await until(lambda: heard.sensors.problem)
        assert f"127.0.0.1:{broker.port}" in heard.sensors.problem
        await until(lambda: "is it running (mosquitto)" in heard.sensors.problem)
        assert heard.health("entrance-door").problem == heard.sensors.problem
        await broker.start()
        await until(lambda: heard.sensors.connected)
        async with broker.client() as maker:
            await maker.publish(f"{DOOR}/state", door(False))
            await until(lambda: len(heard.told) == 2)
        assert heard.sensors.problem == ""
        assert heard.counts("mqtt")["connections"] == 2


@pytest.mark.slow
async def test_a_broker_that_hangs_without_a_word_is_noticed(broker, listen, until):
    async with listen(broker.port) as heard:
        broker.signal(signal.SIGSTOP)
        try:
            await until(lambda: not heard.sensors.connected, 40.0)
            assert heard.sensors.problem
        finally:
            broker.signal(signal.SIGCONT)
        await until(lambda: heard.sensors.connected, 20.0)


async def test_a_broker_that_is_not_there_yet_is_waited_for(broker, listen, until):
    await broker.kill()
    async with listen(broker.port, wait=False) as heard:
        await until(lambda: "no MQTT broker answers" in heard.sensors.problem)
        await broker.start()
        await until(lambda: heard.sensors.connected)


async def test_a_broker_that_asks_for_a_password_gets_it_from_its_file_or_a_word_is_said(
    broker, listen, until, tmp_path
):
    await broker.kill()
    await broker.protect("housefly", "secret")
    await broker.start()
    async with listen(broker.port, wait=False) as refused:
        await until(lambda: "refuses us; check mqtt.username" in refused.sensors.problem)
    secret = tmp_path / "secret"
    secret.write_text("secret\n")
    async with listen(broker.port, username="housefly", password_file=str(secret)) as heard:
        assert heard.sensors.connected
    async with listen(
        broker.port, wait=False, username="housefly", password_file=str(tmp_path / "none")
    ) as lost:
        await until(lambda: "mqtt.password_file: cannot be read" in lost.sensors.problem)


async def test_a_device_that_floods_is_held_to_its_rate_and_another_is_heard_all_the_same(
    broker, listen, until
):
    async with (
        listen(broker.port, rate_max_hz=20.0) as heard,
        broker.client() as flood,
        broker.client() as maker,
    ):
        for _ in range(2000):
            await flood.publish(f"{FLOOR}/state", json.dumps({"people": []}))
        await maker.publish(f"{DOOR}/state", door())
        await until(lambda: heard.knows("entrance-door"))
        counts = heard.counts("floor-1")
        assert counts["flooded"] > 1500
        assert counts["heard"] < 200
        assert "more than 20 messages a second" in heard.health("floor-1").problem
        assert heard.health("entrance-door").problem == ""
        assert [seen.thing for seen in heard.observations].count("entrance-door") == 1


async def test_garbage_is_counted_and_named_and_others_are_unaffected(broker, listen, until):
    async with listen(broker.port) as heard, broker.client() as maker:
        for payload in (b"\xff\xfe", b"open", door() + "}", '{"open": 3}'):
            await maker.publish(f"{DOOR}/state", payload)
        await maker.publish("housefly/bsen/toaster/t/state", "{}")
        await maker.publish("housefly/bsen/door/state", door())
        await maker.publish(f"{BELL}/event", json.dumps({"event": "pressed"}))
        await until(lambda: heard.events)
        assert heard.counts("entrance-door") == {"malformed": 3, "not understood": 1}
        assert (
            heard.health("entrance-door").problem
            == f"{DOOR}/state.open is 3; allowed: true or false"
        )
        assert heard.counts("mqtt")["strange"] == 2
        assert "housefly/bsen/door/state is not of the form" in heard.sensors.problem
        assert heard.health("bell").problem == ""
        assert [(seen.thing, seen.valid) for seen in heard.observations] == [
            ("entrance-door", False)
        ]


async def test_a_message_larger_than_any_devices_never_reaches_us(broker, listen, until):
    async with listen(broker.port) as heard, broker.client() as maker:
        await maker.publish(f"{FLOOR}/state", b" " * 5_000_000)
        await maker.publish(f"{DOOR}/state", door())
        await until(lambda: heard.told)
        assert not heard.knows("floor-1")


@pytest.mark.parametrize(("offset", "side"), [(3600.0, "3600 s ahead"), (-7200.0, "7200 s behind")])
async def test_a_time_from_the_future_or_the_far_past_is_refused_and_counted(
    broker, listen, until, offset, side
):
    async with listen(broker.port) as heard, broker.client() as maker:
        await maker.publish(f"{DOOR}/state", door(time=time.time() + offset))
        await until(lambda: heard.told)
        (seen,) = heard.observations
        assert seen.captured_at == seen.received_at
        assert dict(seen.facts)["clock_error"] == pytest.approx(offset, abs=2.0)
        assert heard.counts("entrance-door")["clock refused"] == 1
        assert f"its clock is {side};" in heard.health("entrance-door").problem


async def test_a_device_that_freezes_grows_old_and_its_health_says_so(broker, listen, until):
    async with listen(broker.port) as heard, broker.client() as maker:
        for _ in range(5):
            await maker.publish(f"{FLOOR}/state", json.dumps({"people": []}))
            await asyncio.sleep(0.1)
        await until(lambda: heard.counts("floor-1")["heard"] == 5)
        assert heard.health("floor-1").connected
        assert 2.0 < heard.health("floor-1").rate_hz < 20.0
        await until(lambda: not heard.health("floor-1").connected)
        health = heard.health("floor-1")
        assert health.age > 2.0
        assert health.problem.startswith("silent for 2 s; it sends its state at least every 1 s")


async def test_a_device_that_vanishes_leaves_its_last_will_and_is_back_when_it_speaks(
    broker, listen, until
):
    will = aiomqtt.Will(f"{DOOR}/availability", b"offline", retain=True)
    async with listen(broker.port) as heard:
        maker = await asyncio.create_subprocess_exec(*broker.doomed(f"{DOOR}", will))
        await until(
            lambda: heard.knows("entrance-door") and heard.health("entrance-door").connected
        )
        maker.kill()
        await maker.wait()
        await until(lambda: not heard.health("entrance-door").connected)
        assert heard.health("entrance-door").problem.startswith("offline: its last will says so")
        async with broker.client() as again:
            await again.publish(f"{DOOR}/availability", b"online", retain=True)
            await again.publish(f"{DOOR}/state", door())
            await until(lambda: heard.health("entrance-door").connected)


async def test_two_kinds_of_device_cannot_share_an_id(broker, listen, until):
    async with listen(broker.port) as heard, broker.client() as maker:
        await maker.publish(f"{DOOR}/state", door())
        await maker.publish(
            "housefly/bsen/motion/entrance-door/state", json.dumps({"motion": True})
        )
        await until(lambda: heard.sensors.problem)
        assert heard.sensors.problem == "entrance-door is a door already; a motion needs another id"
        assert len(heard.observations) == 1


async def test_tags_and_places_of_the_site_file_are_used(broker, listen, until):
    devices = ({"id": "cabinet", "position": (10.0, 5.0, 0.0)},)
    async with (
        listen(broker.port, devices=devices, tags=({"tag": "E2-01", "thing": "cup"},)) as heard,
        broker.client() as maker,
    ):
        item = {"tag": "E2-01", "weight": 0.21, "x": 0.1, "y": 0.0, "z": 0.5}
        await maker.publish("housefly/bsen/cabinet/cabinet/state", json.dumps({"items": [item]}))
        await until(lambda: len(heard.observations) == 2)
        assert (heard.observations[1].thing, heard.observations[1].position) == (
            "cup",
            (10.1, 5.0, 0.5),
        )


async def test_another_sites_devices_are_not_ours(broker, listen, until):
    async with listen(broker.port) as heard, broker.client() as maker:
        await maker.publish("housefly/elsewhere/door/d/state", door())
        await maker.publish(f"{DOOR}/state", door())
        await until(lambda: heard.told)
        assert not heard.knows("d")


async def test_the_broker_knows_whether_we_listen(broker, listen, until):
    async with broker.client() as watcher:
        await watcher.subscribe(listener_topic("bsen"))
        async with listen(broker.port):
            message = await asyncio.wait_for(anext(aiter(watcher.messages)), 5.0)
            assert message.payload == b"online"
