"""Fuzz targets: the bus, the questions to the room, and the console's HTTP and WebSocket."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Iterable
from contextlib import ExitStack
from functools import cache
from typing import Any, NamedTuple

from fake_pilot import FakePilot
from fake_room import example_room
from fuzz_asgi import HOST, SECRET, TOKEN, http_status, scope_of, session
from fuzz_target import DEEP, FuzzTarget, scratch
from stand_in_tasks import StandInTasks

from housefly.bus.codec import decoded, encoded
from housefly.bus.local import LocalBus
from housefly.bus.topics import (
    DEPTH_TOPIC,
    FRAME_TOPIC,
    HUB_QUERY,
    OBSTACLE_TOPIC,
    ROOM_EVENT_TOPIC,
    SENSOR_TOPIC,
    SIGHT_TOPIC,
    DroneTopics,
    Topic,
)
from housefly.clock import RealClock
from housefly.config.site import Site
from housefly.errors import LinkError, ThingError, WireError
from housefly.hub.api.answers import ANSWER_TYPES, EventAnswer, News
from housefly.hub.api.json import (
    answer_from_json,
    answer_to_json,
    question_from_json,
    question_to_json,
)
from housefly.hub.api.pilot_queries import PlanRequest, PreflightView, RoomView
from housefly.hub.api.pilot_queries_json import from_json
from housefly.hub.api.questions import WhereQuestion
from housefly.hub.api.topics import ROOM_NEWS_TOPIC
from housefly.hub.client.http import checked_answer
from housefly.hub.memory import RoomMemory
from housefly.hub.query_handler import QueryHandler
from housefly.hub.room_status import RoomStatus
from housefly.hub.store.open import open_store
from housefly.hub.things.thing import Thing, ThingKind
from housefly.messages import (
    Action,
    Command,
    Estimate,
    Inputs,
    Order,
    OrderKind,
    Outputs,
    PilotStep,
    PlanAnswer,
    Pose,
    Sighting,
    TrackedFrame,
    VideoFrame,
)
from housefly.room.edit_versions import EditVersions
from housefly.room.model import Place, Room
from housefly.ros2.ros_caller import RosCaller
from housefly.ros2.ros_room import RosRoom
from housefly.sites.loaded_site import load_site
from housefly.tasks.api.topics import TASK_NEWS_TOPIC
from housefly.web.api.edit_service import EditService
from housefly.web.rosbridge.bridge_room import BridgeRoom
from housefly.web.rosbridge.calls import Calls
from housefly.web.rosbridge.client import BridgeClient
from housefly.web.rosbridge.outbox import Outbox
from housefly.web.server import create_app

_OURS = DroneTopics()
_PILOT_QUERIES = (PlanRequest, RoomView, PlanAnswer, PreflightView)
_TOPICS: tuple[Topic[Any], ...] = (
    FRAME_TOPIC,
    _OURS.step,
    _OURS.trajectory,
    _OURS.link,
    _OURS.video,
    _OURS.order,
    OBSTACLE_TOPIC,
    DEPTH_TOPIC,
    SENSOR_TOPIC,
    SIGHT_TOPIC,
    ROOM_EVENT_TOPIC,
    _OURS.recording,
    ROOM_NEWS_TOPIC,
    TASK_NEWS_TOPIC,
)
"""In the order that the inputs under ``tests/fuzz`` were kept with."""
_STATUSES = (200, 401, 404, 503)
_QUESTIONS = tuple(ANSWER_TYPES)


def _bus(data: bytes) -> None:
    """The first byte chooses the topic."""
    topic = _TOPICS[data[0] % len(_TOPICS)] if data else _TOPICS[0]
    topic.check(decoded(topic, data[1:]))


def _bus_seeds() -> Iterable[bytes]:
    seen = Sighting("drone", Pose((1.0, 2.0, 3.0)), 1.0, 1.1)
    order = Order(OrderKind.GO, "entrance", (1.0, 2.0), None, 5.0, 1.0, "me")
    here = Estimate(2.0, (1.0, 2.0, 3.0), (0.1, 0.2, 0.3), 0.5, 0.02, 0.01)
    outputs = Outputs(Command(Action.IDLE), here)
    examples = (
        TrackedFrame((seen,)),
        PilotStep(1, 2.0, Inputs((seen,), None, (order,)), outputs),
        VideoFrame(b"\0\0\1\x65", True, 640, 360, 3, 1.0, 2.0),
        order,
        News(1.0, (), (EventAnswer("said", "a", 1.0, "b", "", 1.0, {"c": True}),), (), ()),
    )
    kinds = [topic.type for topic in _TOPICS]
    for example in examples:
        number = kinds.index(type(example))
        yield bytes([number]) + encoded(_TOPICS[number], example)


def _question(data: bytes) -> None:
    handler = _room().handler
    question = question_from_json(data.decode(errors="replace"))
    question_to_json(question)
    answer_to_json(handler.answer(question))


def _answer(data: bytes) -> None:
    text = data[1:].decode(errors="surrogateescape")
    kind = _QUESTIONS[data[0] % len(_QUESTIONS)] if data else _QUESTIONS[0]
    answer_from_json(kind.__new__(kind), text)


def _http_answer(data: bytes) -> None:
    status = _STATUSES[data[0] % len(_STATUSES)] if data else 404
    checked_answer(status, data[1:].decode(errors="surrogateescape"))


def _answer_seeds() -> Iterable[bytes]:
    yield b'\0{"error":"a","unknown":true}'
    yield b'\2{"things": []}'
    yield b"\1" + DEEP


def _pilot_query(data: bytes) -> None:
    kind: Any = _PILOT_QUERIES[data[0] % len(_PILOT_QUERIES)] if data else PlanRequest
    from_json(kind, data[1:].decode(errors="surrogateescape"))


class _Room(NamedTuple):
    handler: QueryHandler
    app: Any
    loop: asyncio.AbstractEventLoop
    edits: EditVersions
    tasks: StandInTasks


@cache
def _room() -> _Room:
    """A console with a session, a hub, tasks and a room that can be edited."""
    thing = Thing("cup", "the red cup", ThingKind.OBJECT, ("mug",), position=(1.0, 1.0, 1.0))
    memory = RoomMemory((thing,), lambda: open_store(scratch() / "room.db"))
    handler = QueryHandler(memory, RoomStatus(memory.writer.report), lambda: 1.7e9)
    bus = LocalBus()
    bus.answer(HUB_QUERY, lambda text: answer_to_json(handler.answer(question_from_json(text))))
    FakePilot(bus.join(), example_room())
    versions = EditVersions(scratch() / "saved")
    tasks = StandInTasks(bus.join())
    app = create_app(
        bus, TOKEN, lambda: None, secret=SECRET, edits=EditService(_small_room, Site(), versions)
    )
    return _Room(handler, app, asyncio.new_event_loop(), versions, tasks)


def _small_room() -> Room:
    places = (Place("home", (2.0, 2.0), (4.0, 1.0, 1.0)),)
    return Room("hall", (0.0, 0.0, 5.0, 5.0), 2.6, (), places, (), (2.0, 2.0))


def _http(data: bytes) -> None:
    """A request as it stands on the wire; what its head leaves out a page of ours would say."""
    room = _room()
    assert http_status(room.app, room.loop, data) != 500
    for path in room.edits.folder.glob("*") if room.edits.folder.is_dir() else ():
        path.unlink()
    room.tasks.asked.clear()
    room.tasks.tasks.clear()


def _http_seeds() -> Iterable[bytes]:
    for path in ("/", "/?token=a", "/static/app.js", "/coverage", "/edits", "/api/v1/things"):
        yield f"GET {path}\nhost: {HOST}\n\n".encode()
    yield b"GET /api/v1/things/cup?at=1\nauthorization: Bearer a\naccept: text/html\n\n"
    yield b"GET /?a=\xff\n\n"
    yield b"GET /\nhost: 127.0.0.1:abc\n\n"
    yield b"GET /\nhost: [::1]:99999\n\n"
    for path in ("/tasks", "/services", "/rules", "/clips?task=5", "/tasks/history?since=0"):
        yield f"GET /api/v1{path}\n\n".encode()
    yield b"GET /api/v1/rules/dry-run?since=1e9&until=1e999\n\n"
    asked = {"service": "look", "parameters": {"subject": "sofa"}}
    for where in ("/tasks", "/tasks/rehearse"):
        yield f"POST /api/v1{where}\n\n{json.dumps(asked)}".encode()
    yield b'POST /api/v1/tasks\n\n{"service": "look", "parameters": {"a": ' + DEEP[:500]
    yield b'POST /api/v1/tasks/1/reply\n\n{"question": "confirm", "choice": "look"}'
    yield b"POST /api/v1/tasks/0/cancel\n\n"
    yield b"POST /api/v1/tasks/-1/pause\n\n{}"
    yield b'POST /api/v1/sentence\n\n{"text": "halt", "language": "de", "fly": false}'
    yield b'POST /api/v1/sentence\n\n{"text": "\\ud800"}'
    yield b'POST /api/v1/mode\n\n{"mode": "away"}'
    yield b'POST /api/v1/clips/a/keep\n\n{"keep": false}'
    yield b"POST /api/v1/webhook/bell\nauthorization: Bearer a\n\n"
    yield b"GET /api/v1/near?x=1&y=2&radius=3\n\n"
    yield b"GET /api/v1/events?since=0&limit=5\nsec-fetch-site: same-origin\n\n"
    yield b"POST /stop\n\n"
    yield b"POST /edits\n\n" + DEEP
    yield b'POST /edits\n\n{"based_on": 0, "tab": "\\ud800", "edits": {"removed": ["\\ud800"]}}'
    edits = {"zones": [{"rectangle": [1, 1, 2, 2], "reason": "mine"}], "places": []}
    body = {"based_on": 0, "tab": "tab-number-one", "edits": edits}
    yield b"POST /edits\ncontent-type: application/json\n\n" + json.dumps(body).encode()
    yield b"POST /edits/undo\n\n" + json.dumps(body).encode()


def _websocket(data: bytes) -> None:
    """One message a line; a tab says hello first."""
    room = _room()
    lines = [b'{"type":"hello","tab":"tab-number-one"}', *data.split(b"\n")[:6]]
    waiting = [{"type": "websocket.connect"}]
    waiting += [
        {"type": "websocket.receive", "text": line.decode(errors="replace")} for line in lines
    ]
    waiting += [{"type": "websocket.disconnect", "code": 1000}]
    answers: list[dict[str, Any]] = []

    async def receive() -> dict[str, Any]:
        return waiting.pop(0)

    async def send(message: dict[str, Any]) -> None:
        answers.append(message)

    scope = scope_of("websocket", b"/socket", session())
    room.loop.run_until_complete(asyncio.wait_for(room.app(scope, receive, send), 60.0))
    assert answers[0]["type"] == "websocket.accept"


def _rosbridge(data: bytes) -> None:
    """One message a line, of a program that may fly where a person says yes."""
    loop = _room().loop
    loop.run_until_complete(_rosbridge_heard(data.split(b"\n")[:6]))


async def _rosbridge_heard(lines: list[bytes]) -> None:
    outbox, said = Outbox(asyncio.get_running_loop()), list[str]()
    client = BridgeClient(
        _bridge(), _calls(), outbox, lambda: _CALLER, said.append, said.append, RealClock()
    )
    for line in lines:
        client.receive(line.decode(errors="surrogateescape"))
    outbox.reply("end")
    while (text := await asyncio.wait_for(outbox.next(), 60.0)) != "end":
        assert json.loads(text)["op"] in ("status", "service_response", "publish")
    client.close()


_CALLER = RosCaller("somebody", "somebody", "off")


@cache
def _calls() -> Calls:
    return Calls()


@cache
def _bridge() -> BridgeRoom:
    bridge = BridgeRoom(LocalBus(), lambda: load_site("bsen"))
    bridge.room = RosRoom(load_site("bsen", hub__enabled=False), LocalBus(), bridge.topics)
    bridge.room.begin(ExitStack())
    return bridge


def _rosbridge_seeds() -> Iterable[bytes]:
    drone = b"/b_sen/drone"
    yield b'{"op":"subscribe","topic":"/b_sen/map","throttle_rate":100,"queue_length":1}'
    yield b'{"op":"subscribe","topic":"%b/pose","type":"geometry_msgs/PoseStamped"}' % drone
    yield b'{"op":"unsubscribe","topic":"/b_sen/map"}\n{"op":"set_level","level":"none"}'
    yield b'{"op":"call_service","id":"1","service":"%b/home","args":{}}' % drone
    yield b'{"op":"call_service","service":"/rosapi/topic_type","args":["/b_sen/map"]}'
    yield b'{"op":"publish","topic":"%b/goal_pose","msg":{"pose":{"position":{"x":1}}}}' % drone
    yield b'{"op":"publish","topic":"/b_sen/ask","msg":{"data":"where is the cup"}}'
    yield b'{"op":"advertise","topic":"%b/goal_pose","type":"geometry_msgs/PoseStamped"}' % drone
    yield b'{"op":"publish","topic":"%b/goal_pose","msg":%b' % (drone, DEEP)


def _websocket_seeds() -> Iterable[bytes]:
    yield b'{"type":"ping","sent":1.0}\n{"type":"stop","id":1}\n{"type":"invite","id":2}'
    yield b'{"type":"lease","id":1,"action":"take"}\n{"type":"order","id":2,"order":"take_off"}'
    yield (
        b'{"type":"lease","id":1,"action":"take","held":true}\n'
        b'{"type":"order","id":2,"order":"go","place":"entrance"}'
    )
    yield b'{"type":"plan","id":3,"goal":[1.0,2.0]}\n{"type":"lease","id":4,"action":"give","to":1}'


def _question_seeds() -> Iterable[bytes]:
    yield question_to_json(WhereQuestion("cup", 1.6e9)).encode()
    yield b'{"ask":"near","radius":1.0,"thing":"cup"}'
    yield b'{"ask":"trajectory","thing":"cup","since":0,"until":5,"every":1}'
    yield b'{"ask":"events","since":0,"limit":5}\n'
    yield b'{"ask":"contents","thing":"cup"}'
    yield b'{"ask":"picture","at":5}'


WEB: dict[str, FuzzTarget] = {
    "bus": FuzzTarget(_bus, _bus_seeds, (WireError,), 4096),
    "room_question": FuzzTarget(_question, _question_seeds, (WireError, ThingError), 512),
    "room_answer": FuzzTarget(_answer, _answer_seeds, (WireError, ThingError)),
    "http_answer": FuzzTarget(
        _http_answer, lambda: (b'\2{"error":"a"}', b"\1[]", b"\1" + DEEP), (LinkError,), 1024
    ),
    "pilot_query": FuzzTarget(
        _pilot_query, lambda: (b'\0{"goal":[1,2],"place":""}',), (WireError,), 1024
    ),
    "http": FuzzTarget(
        _http,
        _http_seeds,
        (),
        1024,
        (b"host:", b"origin:", b"cookie:", b"%00", b"..", b"/api/v1/", b"/tasks"),
    ),
    "rosbridge": FuzzTarget(
        _rosbridge,
        _rosbridge_seeds,
        (),
        1024,
        (b'"op"', b'"msg"', b'"topic"', b"NaN", b"1e999", b"/b_sen/"),
    ),
    "websocket": FuzzTarget(
        _websocket, _websocket_seeds, (), 1024, (b'"order"', b'"goal"', b"NaN", b"1e999")
    ),
}
