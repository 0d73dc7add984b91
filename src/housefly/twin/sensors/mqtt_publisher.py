"""Publishes what the simulated devices send, each over its own connection to the MQTT broker."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable

import aiomqtt

from housefly.bus.mqtt import MQTT_ERRORS, mqtt_client, mqtt_problem, read_password
from housefly.bus.rate import Rate
from housefly.bus.reconnect import stop_if_cancelled
from housefly.config.devices import MqttConfig
from housefly.twin.sensors.devices import DeviceMessage, SimulatedDevices
from housefly.wires.devices import Channel, DeviceAddress

_RATE_HZ = 20.0
"""How often the devices are polled."""
_MAX_QUEUED = 64
"""Messages kept per device while the broker is away; the oldest are dropped."""
_END_AGAIN = 1.0
"""A task that has not ended is told again after this [s]."""
_FIRST_RETRY_DELAY, _MAX_RETRY_DELAY = 0.1, 2.0


class MqttPublisher:
    """Publishes the devices of a scene.

    Args:
        config: broker and site.
        devices: the source of the messages.
        scene_time: reads the time of the scene [s].
        report: takes a line whenever the broker goes or comes back.

    Raises:
        ConfigError: the password file cannot be read.

    Attributes:
        sent: messages handed to the broker.
        problem: why the broker is not there, in words, or "".
    """

    def __init__(
        self,
        config: MqttConfig,
        devices: SimulatedDevices,
        scene_time: Callable[[], float],
        report: Callable[[str], None] = lambda line: None,
    ) -> None:
        self.sent = 0
        self.problem = ""
        self._config, self._devices, self._time = config, devices, scene_time
        self._report = report
        read_password(config)
        self._connected = 0
        self._queues: dict[DeviceAddress, asyncio.Queue[DeviceMessage]] = {
            address: asyncio.Queue(_MAX_QUEUED) for address in devices.addresses()
        }

    def press(self, device: str) -> None:
        """Press the button of a device, whatever the scene says."""
        self._devices.press(device)

    def trouble(self) -> str:
        """Return why nobody would hear a device now, in words, or ""."""
        broker = f"the MQTT broker at {self._config.broker}:{self._config.port}"
        return self.problem or ("" if self._connected else f"{broker} is not there yet")

    async def run(self) -> None:
        """Publish until cancelled."""
        tasks = [asyncio.create_task(self._publish_forever(one)) for one in self._queues]
        tasks.append(asyncio.create_task(self._poll_devices()))
        try:
            await asyncio.gather(*tasks)
        finally:
            await _end(tasks)

    async def _poll_devices(self) -> None:
        rate = Rate(_RATE_HZ)
        while True:
            for message in self._devices.messages(self._time(), time.time()):
                queue = self._queues[message.address]
                if queue.full():
                    queue.get_nowait()
                queue.put_nowait(message)
            await rate.sleep()

    async def _publish_forever(self, address: DeviceAddress) -> None:
        pause = _FIRST_RETRY_DELAY
        while True:
            before = self.sent
            try:
                await self._publish_once_connected(address)
            except* MQTT_ERRORS as group:
                self._set_problem(
                    await mqtt_problem(group.exceptions[0], self._config, self.sent > before)
                )
            pause = _FIRST_RETRY_DELAY if self.sent > before else min(2 * pause, _MAX_RETRY_DELAY)
            await asyncio.sleep(pause)

    async def _publish_once_connected(self, address: DeviceAddress) -> None:
        """Publish a device's messages over one connection, until it is lost."""
        presence, queue = address.topic(Channel.AVAILABILITY), self._queues[address]
        async with mqtt_client(
            self._config, aiomqtt.Will(presence, b"offline", qos=1, retain=True)
        ) as link:
            await link.publish(presence, b"online", qos=1, retain=True)
            self._set_problem("")
            self._connected += 1
            try:
                async with asyncio.TaskGroup() as group:
                    group.create_task(_notice_loss(link))
                    group.create_task(self._deliver(link, queue))
            finally:
                self._connected -= 1

    async def _deliver(self, link: aiomqtt.Client, queue: asyncio.Queue[DeviceMessage]) -> None:
        while True:
            message = await queue.get()
            await link.publish(
                message.address.topic(message.channel),
                message.payload,
                qos=1,
                retain=message.retain,
            )
            self.sent += 1
            stop_if_cancelled()  # the group tells its tasks once only

    def _set_problem(self, problem: str) -> None:
        """Report a broker that went or came back, once for all devices."""
        if bool(problem) is not bool(self.problem):
            self._report(
                problem
                or f"the MQTT broker at {self._config.broker}:{self._config.port} is there again"
            )
        self.problem = problem


async def _end(tasks: list[asyncio.Task[None]]) -> None:
    """End tasks, however often: a connection that is lost just then may take a cancellation."""
    while tasks := [task for task in tasks if not task.done()]:
        for task in tasks:
            task.cancel()
        await asyncio.wait(tasks, timeout=_END_AGAIN)


async def _notice_loss(link: aiomqtt.Client) -> None:
    """Wait until the connection is lost, which raises; nothing is ever received."""
    async for _ in link.messages:
        pass
