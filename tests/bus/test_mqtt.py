"""Why a broker is not connected: nobody there, another version, or no broker at all."""

from __future__ import annotations

import asyncio

import aiomqtt
import pytest
from mqtt_broker import until

from housefly.bus.mqtt import mqtt_problem
from housefly.config.devices import MqttConfig
from housefly.sensors.mqtt import MqttSensors

pytestmark = pytest.mark.wire

_LEVEL_AT = 8
"""Where a greeting says its version: 5, 4 for 3.1.1; of 3.1 another byte stands there."""
OLDER = "speaks MQTT 3.1.1 and not MQTT 5, which Housefly speaks; update it"


class OldBroker:
    """Greets back in MQTT 3.1.1; to a newer greeting it says what the test wants, and hangs up."""

    def __init__(self, to_newer: bytes, accepts: bool = True) -> None:
        self._to_newer, self._accepts = to_newer, accepts
        self.port = 0

    async def __aenter__(self) -> OldBroker:
        self._server = await asyncio.start_server(self._serve, "127.0.0.1", 0)
        self.port = self._server.sockets[0].getsockname()[1]
        return self

    async def __aexit__(self, *_: object) -> None:
        self._server.close()

    async def _serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        greeting = await reader.read(200)
        is_known = self._accepts and greeting[_LEVEL_AT] == 4
        writer.write(b"\x20\x02\x00\x00" if is_known else self._to_newer)
        writer.close()


@pytest.mark.parametrize(
    ("to_newer", "accepts", "words"),
    [
        (b"\x20\x02\x00\x01", True, OLDER),
        (b"\x20\x03\x00\x84\x00", True, OLDER),
        (b"", True, OLDER),
        (b"HTTP/1.1 400 Bad Request\r\n", False, "but not as an MQTT broker without TLS does"),
    ],
)
async def test_an_older_broker_is_told_its_version_and_ours(
    to_newer: bytes, accepts: bool, words: str
) -> None:
    async with OldBroker(to_newer, accepts) as broker:
        config = MqttConfig(broker="127.0.0.1", port=broker.port)
        assert words in await mqtt_problem(aiomqtt.MqttError("gone"), config, False)


async def test_the_driver_of_devices_says_so_of_an_older_broker() -> None:
    async with OldBroker(b"\x20\x02\x00\x01") as broker:
        sensors = MqttSensors(MqttConfig(broker="127.0.0.1", port=broker.port))
        work = asyncio.create_task(sensors.run(lambda value: None))
        await until(lambda: OLDER in sensors.problem)
        work.cancel()
        await asyncio.gather(work, return_exceptions=True)


async def test_where_nothing_listens_nobody_answers() -> None:
    async with OldBroker(b"") as broker:
        config = MqttConfig(broker="127.0.0.1", port=broker.port)
    assert "no MQTT broker answers" in await mqtt_problem(OSError("refused"), config, False)
