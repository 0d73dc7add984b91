"""The connection to Home Assistant's broker: announces, shows, and hears commands."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass, field
from functools import partial
from typing import NoReturn

import aiomqtt
from paho.mqtt.subscribeoptions import SubscribeOptions

from housefly.bus.mqtt import MQTT_ERRORS, mqtt_client, mqtt_problem
from housefly.bus.reconnect import ReconnectingClient, stop_if_cancelled
from housefly.clock import Clock
from housefly.config.process_log import log_traceback
from housefly.config.site import Site
from housefly.errors import ConfigError, LinkError
from housefly.homeassistant.commands import MAX_COMMAND
from housefly.homeassistant.entities import discovery_documents
from housefly.homeassistant.home_requests import HomeRequests
from housefly.homeassistant.home_view import HomeMessage, HomeView
from housefly.messages.words import UNSAID, Words

_SHOWN_PERIOD = 0.25
"""How often changed states are published [s]; events do not wait for it."""
_ANNOUNCED_PERIOD = 5.0
"""Everything is published anew at most so often [s], however often Home Assistant is born."""
_LARGEST = 64 * 1024
"""Longer messages are not handed over by the broker [bytes]."""
_MAX_WAITING = 64
"""Events and pictures that wait to be published; the oldest are dropped."""
_MAX_WORKING = 8
"""Commands that are worked on at once; what is more is dropped, but for STOP."""
_OWN = ("drone-", "room", "situation-")
"""How the keys begin of what is known from the start, so that a kept one is out of date."""


class HomeLink(ReconnectingClient[None]):
    """One connection; ``send`` is safe from any thread.

    Args:
        site: broker and form of discovery.
        view: what is shown.
        requests: does what is asked.
        clock: for ages.
        on_birth: called when the broker or Home Assistant is there anew, on the loop.
    """

    def __init__(
        self,
        site: Site,
        view: HomeView,
        requests: HomeRequests,
        clock: Clock | None = None,
        on_birth: Callable[[], None] = lambda: None,
    ) -> None:
        super().__init__(f"the MQTT broker at {site.mqtt.broker}:{site.mqtt.port}", clock)
        self._mqtt, self._discovery = site.mqtt, site.homeassistant.discovery
        self._by_device = self._discovery == "device"
        self._view, self._topics, self._requests = view, view.topics, requests
        self._on_birth = on_birth
        self._loop: asyncio.AbstractEventLoop | None = None
        self._outgoing: asyncio.Queue[HomeMessage] = asyncio.Queue(_MAX_WAITING)
        self._desks = {is_order: _Desk() for is_order in (False, True)}
        self._announced: set[str] = set()
        self._published: dict[str, bytes] = {}
        self._documents: dict[str, bytes] = {}
        self._entities: object = None
        self._due_at = -math.inf
        self._is_due = False

    @property
    def problem(self) -> Words:
        """Why there is no connection; UNSAID while there is one, however quiet."""
        return self._problem

    async def run_for_ever(self) -> NoReturn:
        """Connect, show and listen; ends only when cancelled."""
        self._loop = asyncio.get_running_loop()
        try:
            await self.run(lambda _: None)
        finally:
            for desk in self._desks.values():
                desk.thread.shutdown(wait=False, cancel_futures=True)

    def send(self, topic: str, payload: bytes) -> None:
        """Publish something once, not retained; returns at once."""
        if self._loop is not None and not self._loop.is_closed():
            with suppress(RuntimeError):  # it was closed just now
                self._loop.call_soon_threadsafe(self._enqueue, (topic, payload))

    def _enqueue(self, message: HomeMessage) -> None:
        if self._outgoing.full():
            self._outgoing.get_nowait()
        self._outgoing.put_nowait(message)

    async def _read_connection(self, sink: Callable[[None], None]) -> None:
        topics, was_connected = self._topics, False
        will = aiomqtt.Will(topics.availability, b"offline", qos=1, retain=True)
        try:
            async with mqtt_client(self._mqtt, will, _LARGEST) as link:
                self._published.clear()
                while not self._outgoing.empty():  # a bell that rang while the broker was away
                    self._outgoing.get_nowait()
                options = SubscribeOptions(qos=1, noLocal=True)
                for topic in (topics.commands, topics.birth, *topics.announcements):
                    await link.subscribe(topic, options=options)
                stop_if_cancelled()
                was_connected = True
                self._problem = UNSAID
                self._data_arrived(self._clock.now())
                self._on_birth()
                working = [
                    asyncio.create_task(self._show(link)),
                    asyncio.create_task(self._tell(link)),
                ]
                try:
                    async for message in link.messages:
                        self._take(message)
                finally:
                    for work in working:
                        work.cancel()
                    await asyncio.gather(*working, return_exceptions=True)
                    with suppress(*MQTT_ERRORS):  # a will is for those who leave without a word
                        await link.publish(topics.availability, b"offline", qos=1, retain=True)
        except MQTT_ERRORS as error:
            raise LinkError(await mqtt_problem(error, self._mqtt, was_connected)) from error
        except ConfigError as error:
            raise LinkError(str(error)) from error

    async def _show(self, link: aiomqtt.Client) -> None:
        """Publish what is not yet at the broker, again and again."""
        while True:
            now = self._clock.now()
            if self._is_due and now - self._due_at >= _ANNOUNCED_PERIOD:
                self._is_due, self._due_at = False, now
                self._published.clear()
                self._on_birth()
            try:
                await self._publish_changes(link)
            except aiomqtt.MqttError:  # who reads the connection says that it is gone
                pass
            except Exception:  # a defect in one look must not end all others in silence
                log_traceback()
            stop_if_cancelled()
            await asyncio.sleep(_SHOWN_PERIOD)

    async def _publish_changes(self, link: aiomqtt.Client) -> None:
        entities = self._view.entities()
        if entities is not self._entities:
            self._documents = discovery_documents(entities, self._topics, self._discovery)
            self._entities = entities
        gone = {topic: b"" for topic in self._announced if self._is_old(topic)}
        states = self._view.states()
        wanted = {**gone, **self._documents, **states, self._topics.availability: b"online"}
        for topic, payload in wanted.items():
            if self._published.get(topic) != payload:
                await link.publish(topic, payload, qos=1, retain=True)
                self._published[topic] = payload

    async def _tell(self, link: aiomqtt.Client) -> None:
        while True:
            topic, payload = await self._outgoing.get()
            with suppress(aiomqtt.MqttError):
                await link.publish(topic, payload)
            stop_if_cancelled()

    def _take(self, message: aiomqtt.Message) -> None:
        topic = message.topic.value
        payload = message.payload if isinstance(message.payload, bytes) else b""
        if topic == self._topics.birth:
            self._is_due |= payload == b"online" and not message.retain
        elif topic.endswith("/config"):
            if message.retain and payload and self._topics.announced_key(topic):
                self._announced.add(topic)
        elif payload and not message.retain:
            # What the broker kept would fly again at each start.
            self._command(topic, payload)

    def _is_old(self, topic: str) -> bool:
        """Return whether an earlier site announced something there, or this one in another form."""
        other_form = topic.startswith(f"{self._topics.prefix}/device/") != self._by_device
        is_own = self._topics.announced_key(topic).startswith(_OWN)
        return topic not in self._documents and (other_form or is_own)

    def _command(self, topic: str, payload: bytes) -> None:
        if self._requests.is_stop(topic, payload):
            self._requests.stop(topic)
            return
        desk = self._desks[self._requests.is_order(topic, payload)]
        if len(payload) <= MAX_COMMAND and desk.working < _MAX_WORKING and self._loop:
            desk.working += 1
            asked = self._loop.run_in_executor(desk.thread, self._requests.take, topic, payload)
            asked.add_done_callback(partial(self._done, desk))

    def _done(self, desk: _Desk, asked: asyncio.Future[str]) -> None:
        desk.working -= 1
        if not asked.cancelled() and asked.exception() is None:
            self._view.hear_reply(asked.result())


@dataclass(slots=True)
class _Desk:
    """Where commands are worked on one by one: orders wait for no answer of the tasks."""

    thread: ThreadPoolExecutor = field(default_factory=lambda: ThreadPoolExecutor(1, "home"))
    working: int = 0
