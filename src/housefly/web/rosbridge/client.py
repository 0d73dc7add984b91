"""One client of rosbridge: what each of its messages does."""

from __future__ import annotations

import asyncio
from collections import Counter
from collections.abc import Callable
from functools import partial
from typing import Any

from housefly.clock import Clock
from housefly.config.text import shortened
from housefly.errors import WireError
from housefly.ros2.flight_desk import FlightDesk
from housefly.ros2.order_line import RosReply
from housefly.ros2.ros_caller import RosCaller
from housefly.ros2.ros_json import full_type, json_tree, message_of
from housefly.ros2.ros_room import RosRoom
from housefly.ros2.topic_table import RosTopic
from housefly.ros2.wishes import TRIGGER, RosInput, RosService
from housefly.web.http.rate_limit import CommandLimiter
from housefly.web.rosbridge.bridge_room import BridgeRoom
from housefly.web.rosbridge.calls import WAITING_MAX, Calls
from housefly.web.rosbridge.operations import (
    Advertise,
    CallService,
    Operation,
    Publish,
    SetLevel,
    Subscribe,
    Unadvertise,
    Unsubscribe,
    operation_of,
    shape_objection,
)
from housefly.web.rosbridge.outbox import Outbox
from housefly.web.rosbridge.rosapi import ROSAPI, Directory, rosapi_answer
from housefly.web.rosbridge.subscription import pace_of
from housefly.web.rosbridge.texts import (
    StatusLevel,
    level_named,
    message_text,
    response_text,
    status_text,
)

_RATE, _BURST = 50.0, 200.0
"""Messages a second of one client, and at once after a pause; STOP and LAND are not counted."""
_TOO_MUCH = "too many messages at once: wait a moment"
_NAME_SHOWN = 80
_Ident = str | int | None


class BridgeClient:
    """Everything happens on one loop, but what may block.

    Args:
        bridge: the room.
        calls: threads for wishes.
        outbox: what it is told.
        caller: tells who it is now; None where the session is over.
        stop: sends STOP to a drone at once, on every path there is.
        record: writes down what was asked, and what became of it.
        clock: of the console.
    """

    def __init__(
        self,
        bridge: BridgeRoom,
        calls: Calls,
        outbox: Outbox,
        caller: Callable[[], RosCaller | None],
        stop: Callable[[str], None],
        record: Callable[[str], None],
        clock: Clock,
    ) -> None:
        self._bridge, self._calls, self._outbox = bridge, calls, outbox
        self._caller, self._stop, self._record, self._clock = caller, stop, record, clock
        self.limiter = CommandLimiter(_BURST, clock.now(), 0, _RATE, _BURST)
        self._level = StatusLevel.ERROR
        self._waiting = Counter[bool]()
        self._tasks: set[asyncio.Task[None]] = set()
        self._desk: tuple[RosRoom, RosCaller, FlightDesk] | None = None
        self._handlers: dict[type, Callable[[Any], None]] = {
            Subscribe: self._subscribe,
            Unsubscribe: self._unsubscribe,
            Advertise: self._advertise,
            Unadvertise: lambda _: None,
            Publish: self._publish,
            CallService: self._call,
            SetLevel: self._set_level,
        }

    def receive(self, text: str) -> None:
        """Do what a message asks, or say why not."""
        ident: _Ident = None
        try:
            operation = operation_of(text)
            ident = operation.id
            if objection := shape_objection(operation):
                self._fail(operation, objection)
            else:
                self._handlers[type(operation)](operation)
        except WireError as error:
            self._spend()
            self._say(StatusLevel.ERROR, str(error), ident)

    def close(self) -> None:
        """Hear nothing more; what was asked is done all the same."""
        for topic in self._outbox.topics():
            self._bridge.topics.leave(topic, self._outbox)

    # --- topics

    def _subscribe(self, asked: Subscribe) -> None:
        topic = self._topic(asked.topic)
        self._check_type(asked.topic, topic, asked.type)
        if self._spend():
            pace = pace_of(asked.throttle_rate or 0.0, asked.queue_length or 0, topic.quality)
            self._bridge.topics.hear(asked.topic, self._outbox, asked.id, pace)

    def _unsubscribe(self, asked: Unsubscribe) -> None:
        if self._spend() and self._outbox.unsubscribe(asked.topic, asked.id):
            self._bridge.topics.leave(asked.topic, self._outbox)

    def _advertise(self, asked: Advertise) -> None:
        found = self._input(asked.topic)
        self._check_type(asked.topic, found.topic, asked.type)
        self._spend()

    def _publish(self, said: Publish) -> None:
        found = self._input(said.topic)
        message = message_of(said.msg, found.topic.type)
        if found.is_safer or self._spend():
            done = partial(self._published, said)
            self._begin(found.name, partial(found.wish, message), found.is_safer, done)

    def _published(self, said: Publish, reply: RosReply) -> None:
        if reply.message:
            level = StatusLevel.INFO if reply.success else StatusLevel.ERROR
            self._say(level, reply.message, said.id)

    # --- services

    def _call(self, asked: CallService) -> None:
        if asked.service in ROSAPI:
            self._look_up(asked)
            return
        found = self._service(asked.service)
        if found is None:
            self._spend()
            words = f"there is no service {shortened(asked.service, _NAME_SHOWN)!r}"
            self._respond(asked, words, result=False)
            return
        for drone in found.stops:
            self._stop(drone)  # at once, past everything that waits
        if found.is_safer or self._spend():
            done = partial(self._called, asked)
            self._begin(found.name, found.wish, found.is_safer, done)
        else:
            self._respond(asked, _TOO_MUCH, result=False)

    def _look_up(self, asked: CallService) -> None:
        if not self._spend():
            self._respond(asked, _TOO_MUCH, result=False)
            return
        try:
            values = rosapi_answer(ROSAPI[asked.service], self._directory(), asked.args)
        except WireError as error:
            self._respond(asked, str(error), result=False)
        else:
            self._respond(asked, values, result=True)

    def _called(self, asked: CallService, reply: RosReply) -> None:
        values = {"success": reply.success, "message": reply.message}
        self._respond(asked, values, result=True)

    def _respond(self, asked: CallService, values: dict[str, Any] | str, *, result: bool) -> None:
        self._outbox.reply(response_text(asked.service, asked.id, values, result=result))

    # --- what there is

    def _offered(self) -> list[RosService | RosInput]:
        """Return what this client may ask now; nothing while the room is not open."""
        room, caller = self._bridge.room, self._caller()
        if room is None or caller is None:
            return []
        if self._desk is None or self._desk[:2] != (room, caller):
            self._desk = room, caller, room.desk(caller)
        return list(room.offered(self._desk[2], self._tell))

    def _service(self, name: str) -> RosService | None:
        services = (one for one in self._offered() if isinstance(one, RosService))
        return next((one for one in services if one.name == name), None)

    def _input(self, name: str) -> RosInput:
        inputs = [one for one in self._offered() if isinstance(one, RosInput)]
        found = next((one for one in inputs if one.name == name), None)
        if found is None:
            there = ", ".join(one.name for one in inputs) or "none yet"
            shown = shortened(name, _NAME_SHOWN)
            raise WireError(f"nobody may publish to {shown!r}; allowed: {there}")
        return found

    def _topic(self, name: str) -> RosTopic:
        found = self._bridge.topics.offered().get(name)
        if found is None:
            shown = shortened(name, _NAME_SHOWN)
            raise WireError(f"there is no topic {shown!r}; /rosapi/topics lists them")
        return found

    def _directory(self) -> Directory:
        offered = self._offered()
        inputs = {one.name: one.topic.type for one in offered if isinstance(one, RosInput)}
        told = {name: one.type for name, one in self._bridge.topics.offered().items()}
        services = {one.name: TRIGGER for one in offered if isinstance(one, RosService)}
        services |= {name: one.type for name, one in ROSAPI.items()}
        return Directory(told | inputs, services, frozenset(inputs))

    # --- the rest

    def _begin(
        self,
        name: str,
        wish: Callable[[], RosReply],
        is_safer: bool,
        done: Callable[[RosReply], None],
    ) -> None:
        """Let a wish be done on a thread."""
        if self._waiting[is_safer] >= WAITING_MAX:
            done(RosReply(False, f"{WAITING_MAX} wishes of yours are being looked at already"))
            return
        self._waiting[is_safer] += 1
        task = asyncio.get_running_loop().create_task(self._done(name, wish, is_safer, done))
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def _done(
        self,
        name: str,
        wish: Callable[[], RosReply],
        is_safer: bool,
        done: Callable[[RosReply], None],
    ) -> None:
        try:
            reply = await self._calls.answered(wish, is_safer=is_safer)
        finally:
            self._waiting[is_safer] -= 1
        if reply.message:
            became = "" if reply.success else ": refused"
            self._record(f"rosbridge: {name}{became}: {reply.message}")
        done(reply)

    def _tell(self, topic: RosTopic, name: str, make: Callable[[], Any]) -> None:
        """Tell this client alone."""
        self._outbox.offer(name, message_text(name, json_tree(make())))

    def _set_level(self, asked: SetLevel) -> None:
        self._level = level_named(asked.level)
        self._spend()

    def _fail(self, operation: Operation, words: str) -> None:
        self._spend()
        if isinstance(operation, CallService):
            self._respond(operation, words, result=False)
        else:
            self._say(StatusLevel.ERROR, words, operation.id)

    def _check_type(self, name: str, topic: RosTopic, said: str | None) -> None:
        if said and full_type(said) != topic.type:
            shown = shortened(said, _NAME_SHOWN)
            raise WireError(f"{name} is {shown!r}; allowed: {topic.type!r}")

    def _spend(self) -> bool:
        if self.limiter.spend(self._clock.now()):
            return True
        if self.limiter.refused == 1:
            self._say(StatusLevel.ERROR, _TOO_MUCH, None)
        return False

    def _say(self, level: StatusLevel, words: str, ident: _Ident) -> None:
        if level >= self._level and self._level is not StatusLevel.NONE:
            self._outbox.reply(status_text(level, words, ident))
