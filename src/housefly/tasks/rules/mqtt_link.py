"""The tasks on the room's MQTT broker: hears triggers and requests, answers, tells devices."""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Callable, Iterable
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from typing import NoReturn

import aiomqtt
from paho.mqtt.packettypes import PacketTypes
from paho.mqtt.properties import Properties
from paho.mqtt.subscribeoptions import SubscribeOptions

from housefly.bus.mqtt import MQTT_ERRORS, mqtt_client, mqtt_problem
from housefly.bus.reconnect import ReconnectingClient, stop_if_cancelled
from housefly.clock import Clock
from housefly.config.devices import MqttConfig
from housefly.config.tasks import TasksConfig
from housefly.errors import ConfigError, LinkError, TaskError, WireError
from housefly.messages.words import UNSAID
from housefly.tasks.api.json import task_question_to_json, task_refusal_to_json
from housefly.tasks.api.questions import RehearseTask, Sentence, TaskQuestion
from housefly.tasks.api.values import ReasonCode
from housefly.tasks.intents.stop_words import says_stop
from housefly.tasks.rules.mqtt_requests import ANSWER, client_of, mqtt_question, request_topics
from housefly.tasks.rules.rule import MqttPattern, Rule
from housefly.tasks.rules.trigger import MAX_MQTT_PAYLOAD, MqttTrigger
from housefly.wires.devices import task_topic

_ENVELOPE = 1024
"""Room for topic and properties beside the longest payload [bytes]."""
_REQUESTS_PER_MINUTE = 20
"""Of one client, where they are told apart by their topics; else of all together."""
_MAX_REPLIES = 8
"""Requests that are worked on at once; what is more is dropped, but for as many STOPs."""
_THREADS = 2
"""One for what takes seconds, and one for what does not."""
_PAUSE = 0.1
"""After a message that could not be published [s]."""
_MAX_WAITING = 256
"""Messages for devices that wait while the broker is away; the oldest are dropped."""

MqttSink = Callable[[MqttTrigger], None]


class MqttLink(ReconnectingClient[MqttTrigger]):
    """One connection for all; what we publish ourselves is not heard as a trigger.

    Args:
        broker: where it is, who we are, the name of the site.
        tasks: who may ask.
        rules: whose topics are heard.
        answer: answers a question to the tasks, JSON in and out; called on threads of our own.
        wall: Unix time [s].
        clock: for the rate of requests.
    """

    def __init__(
        self,
        broker: MqttConfig,
        tasks: TasksConfig,
        rules: Iterable[Rule],
        answer: Callable[[str], str],
        wall: Callable[[], float],
        clock: Clock | None = None,
    ) -> None:
        super().__init__(f"the MQTT broker at {broker.broker}:{broker.port}", clock)
        self._broker, self._tasks, self._answer, self._wall = broker, tasks, answer, wall
        self._triggers = sorted({topic for rule in rules if (topic := _topic_of(rule))})
        self._requests = request_topics(broker.site, tasks)
        self._asked = {topic: deque[float](maxlen=_REQUESTS_PER_MINUTE) for topic in self._requests}
        self._outgoing: asyncio.Queue[tuple[str, str]] = asyncio.Queue(_MAX_WAITING)
        self._loop: asyncio.AbstractEventLoop | None = None
        self._threads = ThreadPoolExecutor(_THREADS, "mqtt-requests")
        self._stop_thread = ThreadPoolExecutor(1, "mqtt-stop")
        self._rehearsal: Future[str] | None = None

    async def run(self, sink: MqttSink) -> NoReturn:
        """Listen, answer and publish for ever; ends only when cancelled."""
        self._loop = asyncio.get_running_loop()
        try:
            await super().run(sink)
        finally:
            for threads in (self._threads, self._stop_thread):
                threads.shutdown(wait=False, cancel_futures=True)

    def publish(self, topic: str, payload: str) -> None:
        """Publish to a device; returns at once, from any thread."""
        if self._loop is not None and not self._loop.is_closed():
            self._loop.call_soon_threadsafe(self._enqueue, topic, payload)

    def _enqueue(self, topic: str, payload: str) -> None:
        if self._outgoing.full():
            self._outgoing.get_nowait()
        self._outgoing.put_nowait((topic, payload))

    async def _read_connection(self, sink: MqttSink) -> None:
        was_connected = False
        try:
            async with mqtt_client(self._broker, None, MAX_MQTT_PAYLOAD + _ENVELOPE) as link:
                options = SubscribeOptions(qos=1, noLocal=True)
                for topic in (*self._triggers, *self._requests):
                    await link.subscribe(topic, options=options)
                stop_if_cancelled()
                was_connected, self._problem = True, UNSAID
                self._data_arrived(self._clock.now())
                working = {asyncio.create_task(self._send(link))}
                try:
                    async for message in link.messages:
                        self._take(link, message, sink, working)
                finally:
                    for work in working:
                        work.cancel()
        except MQTT_ERRORS as error:
            raise LinkError(await mqtt_problem(error, self._broker, was_connected)) from error
        except ConfigError as error:
            raise LinkError(str(error)) from error

    async def _send(self, link: aiomqtt.Client) -> None:
        while True:
            stop_if_cancelled()
            topic, payload = await self._outgoing.get()
            try:
                await link.publish(topic, payload, qos=1)
            except ValueError:  # a topic with a wildcard: the document was not checked for it
                continue
            except aiomqtt.MqttError:  # when the connection is gone, who reads it says so
                await asyncio.sleep(_PAUSE)

    def _take(
        self,
        link: aiomqtt.Client,
        message: aiomqtt.Message,
        sink: MqttSink,
        working: set[asyncio.Task[None]],
    ) -> None:
        payload = message.payload if isinstance(message.payload, bytes) else b""
        topic = message.topic.value
        if topic not in self._requests:
            if payload:
                sink(MqttTrigger(topic, payload, self._wall(), bool(message.retain)))
        elif payload and not message.retain:
            # What the broker kept would fly again at each start.
            is_stop = self._is_stop(topic, payload)
            if len(working) <= (2 * _MAX_REPLIES if is_stop else _MAX_REPLIES):
                reply = asyncio.create_task(self._reply(link, message, payload, is_stop=is_stop))
                working.add(reply)
                reply.add_done_callback(working.discard)

    def _is_stop(self, topic: str, payload: bytes) -> bool:
        """Return whether somebody says STOP: that is never too much, and waits for nothing."""
        try:
            question = mqtt_question(topic, payload, self._tasks)
        except (TaskError, WireError):
            return False
        return isinstance(question, Sentence) and says_stop(question.text)

    async def _reply(
        self, link: aiomqtt.Client, message: aiomqtt.Message, payload: bytes, *, is_stop: bool
    ) -> None:
        topic = message.topic.value
        try:
            if not is_stop:
                self._admit(topic)
            question = mqtt_question(topic, payload, self._tasks)
            threads = self._stop_thread if is_stop else self._threads
            text = await asyncio.wrap_future(self._asked_of_tasks(question, threads))
        except (TaskError, WireError) as error:
            text = task_refusal_to_json(error)
        name = client_of(topic)
        where = task_topic(self._broker.site, f"{ANSWER}/{name}" if name else ANSWER)
        with suppress(*MQTT_ERRORS):  # the connection is gone: so is who asked
            await link.publish(where, text, qos=1, properties=_correlation(message))

    def _asked_of_tasks(self, question: TaskQuestion, threads: ThreadPoolExecutor) -> Future[str]:
        """Ask on a thread; raises TaskError for a rehearsal while another is under way."""
        rehearses = isinstance(question, RehearseTask)
        if rehearses and self._rehearsal is not None and not self._rehearsal.done():
            words = "a rehearsal is under way: ask again when it is answered"
            raise TaskError(words, ReasonCode.RATE_LIMIT.value)
        asked = threads.submit(self._answer, task_question_to_json(question))
        if rehearses:
            self._rehearsal = asked
        return asked

    def _admit(self, topic: str) -> None:
        """Count a request on its topic; raises TaskError when there were too many in a minute."""
        now, asked = self._clock.now(), self._asked[topic]
        if len(asked) == _REQUESTS_PER_MINUTE and now - asked[0] < 60.0:
            raise TaskError(
                f"more than {_REQUESTS_PER_MINUTE} requests in a minute",
                ReasonCode.RATE_LIMIT.value,
            )
        asked.append(now)


def _topic_of(rule: Rule) -> str:
    return rule.when.mqtt if rule.enabled and isinstance(rule.when, MqttPattern) else ""


def _correlation(message: aiomqtt.Message) -> Properties | None:
    """Return the asker's own mark, so that they know the answer to their question."""
    data = getattr(message.properties, "CorrelationData", None)
    if not data:
        return None
    properties = Properties(PacketTypes.PUBLISH)  # type: ignore[no-untyped-call]
    properties.CorrelationData = data
    return properties
