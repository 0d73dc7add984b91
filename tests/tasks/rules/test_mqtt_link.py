"""The tasks on a real broker: triggers, requests, answers."""

from __future__ import annotations

import asyncio
import json
import threading
import time
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest
from mqtt_broker import Broker, running_broker, until
from rule_bench import make_rule

from housefly.config.devices import MqttConfig
from housefly.config.tasks import TasksConfig
from housefly.sensors.mqtt import MqttSensors
from housefly.tasks.rules.mqtt_link import MqttLink
from housefly.tasks.rules.trigger import MqttTrigger

pytestmark = pytest.mark.wire
REQUEST, ANSWER = "housefly/home/task/request", "housefly/home/task/answer"


@pytest.fixture
async def broker(tmp_path: Path) -> AsyncIterator[Broker]:
    async with running_broker(tmp_path) as started:
        yield started


class Asked:
    """Stands for the tasks: keeps what it was asked."""

    def __init__(self) -> None:
        self.questions: list[dict[str, Any]] = []
        self.free = threading.Event()
        self.free.set()

    def __call__(self, text: str) -> str:
        assert self.free.wait(20.0)
        self.questions.append(json.loads(text))
        return json.dumps({"number": len(self.questions)})


@asynccontextmanager
async def linked(
    port: int,
    asked: Callable[[str], str],
    heard: list[MqttTrigger],
    tasks: TasksConfig | None = None,
) -> AsyncIterator[MqttLink]:
    config = MqttConfig(broker="127.0.0.1", port=port, site="home")
    rules = [make_rule(when="{mqtt: house/+/button}")]
    link = MqttLink(config, tasks or TasksConfig(), rules, asked, time.time)
    running = asyncio.create_task(link.run(heard.append))
    try:
        await until(lambda: not link.problem or "silent" in link.problem)
        yield link
    finally:
        running.cancel()
        await asyncio.gather(running, return_exceptions=True)


async def test_triggers_are_heard_but_not_what_we_publish_ourselves(broker: Any) -> None:
    heard: list[MqttTrigger] = []
    async with broker.client() as other:
        await other.publish("house/old/button", b"kept", retain=True, qos=1)
        async with linked(broker.port, Asked(), heard) as link:
            link.publish("house/own/button", "echo")
            await other.publish("house/hall/lamp", b"on", qos=1)
            await other.publish("house/hall/button", b"pressed", qos=1)
            await until(lambda: len(heard) >= 2)
            await other.subscribe("house/own/button")
            link.publish("house/own/button", "second")
            message = await asyncio.wait_for(anext(aiter(other.messages)), 15.0)
            assert message.payload == b"second"
    assert {(one.topic, one.payload, one.retained) for one in heard} == {
        ("house/old/button", b"kept", True),
        ("house/hall/button", b"pressed", False),
    }


async def test_a_request_is_answered_and_a_kept_one_is_not_even_read(broker: Any) -> None:
    asked = Asked()
    async with broker.client() as panel:
        await panel.publish(REQUEST, b'{"service": "land"}', retain=True, qos=1)
        await panel.subscribe(f"{ANSWER}/#", qos=1)
        async with linked(broker.port, asked, []):
            answers = aiter(panel.messages)
            for text in (b'{"service": "look"}', b"fly now", b'{"ask": "mode", "mode": "home"}'):
                await panel.publish(REQUEST, text, qos=1)
            found = [
                json.loads((await asyncio.wait_for(anext(answers), 15.0)).payload) for _ in "123"
            ]
    assert [one["service"] for one in asked.questions] == ["look"]
    assert asked.questions[0]["confirm"] == "ask"
    assert {"number": 1} in found
    assert {one.get("code") for one in found if "error" in one} == {"bad_parameter", "not_allowed"}


async def test_a_flood_of_requests_is_cut_and_triggers_go_on(broker: Any) -> None:
    asked, heard = Asked(), list[MqttTrigger]()
    async with broker.client() as panel, linked(broker.port, asked, heard):
        asked.free.clear()
        for _ in range(200):
            await panel.publish(REQUEST, b'{"service": "look"}', qos=1)
        await panel.publish("house/hall/button", b"pressed", qos=1)
        await until(lambda: heard)  # while answers are still being worked on
        asked.free.set()
        for _ in range(40):
            await panel.publish(REQUEST, b'{"service": "look"}', qos=1)
        await panel.publish("house/hall/button", b"again", qos=1)
        await until(lambda: len(heard) == 2)
    assert 1 <= len(asked.questions) <= 20


async def test_nothing_that_is_sent_ends_the_link(broker: Any) -> None:
    asked, heard = Asked(), list[MqttTrigger]()
    deep = b"[" * 2000 + b"]" * 2000
    async with broker.client() as attacker, linked(broker.port, asked, heard) as link:
        for payload in (
            b"x" * 2**20,  # more than the link takes: the broker keeps it
            deep,
            b'{"service": ' + deep + b"}",
            b'{"service": 7, "parameters": "all", "deadline": "never"}',
            b'{"ask": "cancel", "task": -1}',
            b'{"ask": "reply", "task": 1, "question": "confirm", "choice": "yes"}',
            b'{"service": "look", "parameters": {"time": NaN}}',
            b"\xff\xfe\x00",
            b"null",
        ):
            await attacker.publish(REQUEST, payload, qos=1)
        for _ in range(1000):
            await attacker.publish(REQUEST, b'{"service": "look"}', qos=0)
        await attacker.publish("house/hall/button", b"pressed", qos=1)
        await until(lambda: heard)
        assert "silent" in link.problem or not link.problem
    assert len(asked.questions) <= 20
    assert {one["ask"] for one in asked.questions} <= {"request"}


async def test_one_client_takes_no_turns_of_another(broker: Any) -> None:
    asked = Asked()
    config = TasksConfig(mqtt_clients=("panel", "gate"))
    async with broker.client() as both, linked(broker.port, asked, [], config):
        for _ in range(60):
            await both.publish(f"{REQUEST}/gate", b'{"service": "look"}', qos=1)
        await until(lambda: len(asked.questions) >= 8)
        await asyncio.sleep(0.2)  # those that are worked on at once are answered
        await both.publish(f"{REQUEST}/panel", b'{"service": "look"}', qos=1)
        await until(lambda: any(one["by"] == "MQTT client panel" for one in asked.questions))
    assert sum(one["by"] == "MQTT client gate" for one in asked.questions) <= 20


async def test_requests_and_the_rest_of_the_process_do_not_wait_for_each_other(
    broker: Any,
) -> None:
    asked, busy, loop = Asked(), threading.Event(), asyncio.get_running_loop()
    async with broker.client() as panel, linked(broker.port, asked, []):
        rest = [loop.run_in_executor(None, busy.wait, 20.0) for _ in range(40)]
        await panel.publish(REQUEST, b'{"service": "look"}', qos=1)
        await until(lambda: asked.questions)
        busy.set()
        await asyncio.gather(*rest)


async def test_one_rehearsal_at_a_time(broker: Any) -> None:
    asked, text = Asked(), b'{"ask": "rehearse", "service": "look"}'
    async with broker.client() as panel, linked(broker.port, asked, []):
        await panel.subscribe(f"{ANSWER}/#", qos=1)
        answers = aiter(panel.messages)

        async def heard() -> Any:
            return json.loads((await asyncio.wait_for(anext(answers), 15.0)).payload)

        asked.free.clear()
        try:
            for _ in range(2):
                await panel.publish(REQUEST, text, qos=1)
            assert (await heard())["code"] == "rate_limit"
        finally:
            asked.free.set()
        assert await heard() == {"number": 1}
        await panel.publish(REQUEST, text, qos=1)
        assert await heard() == {"number": 2}


async def test_stop_is_never_too_much_and_waits_for_nothing(broker: Any) -> None:
    asked, said = Asked(), list[str]()

    def answer(text: str) -> str:
        tree = json.loads(text)
        if tree["ask"] == "sentence":
            said.append(tree["text"])
            return "{}"
        return asked(text)

    async with broker.client() as panel, linked(broker.port, answer, []):
        asked.free.clear()
        try:
            for _ in range(60):  # more than is worked on at once, and than a minute has
                await panel.publish(REQUEST, b'{"service": "look"}', qos=1)
            await panel.publish(REQUEST, b'{"ask": "sentence", "text": "stop!"}', qos=1)
            await until(lambda: said)
        finally:
            asked.free.set()
    assert said == ["stop!"]


async def test_a_site_that_wants_none_takes_no_requests(broker: Any) -> None:
    asked, heard = Asked(), list[MqttTrigger]()
    config = TasksConfig(mqtt_requests="off")
    async with broker.client() as panel, linked(broker.port, asked, heard, config):
        await panel.publish(REQUEST, b'{"service": "look"}', qos=1)
        await panel.publish("house/hall/button", b"pressed", qos=1)
        await until(lambda: heard)
    assert asked.questions == []


async def test_the_driver_of_the_devices_takes_no_notice_of_requests(broker: Any) -> None:
    config = MqttConfig(broker="127.0.0.1", port=broker.port, site="home")
    sensors = MqttSensors(config)
    running = asyncio.create_task(sensors.run(lambda _: None))
    try:
        await until(lambda: sensors.connected)
        async with broker.client() as panel:
            await panel.publish(REQUEST, b'{"service": "look"}', qos=1)
            await panel.publish("housefly/home/strange", b"1", qos=1)
            await until(lambda: sensors.counts["strange"])
        assert sensors.counts["strange"] == 1
    finally:
        running.cancel()
        await asyncio.gather(running, return_exceptions=True)
