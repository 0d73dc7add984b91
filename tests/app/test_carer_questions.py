"""A carer's ten questions on every surface: one room, one memory, one service of the tasks."""

from __future__ import annotations

import asyncio
import contextlib
import http.client
import json
import os
import threading
from collections.abc import Callable, Coroutine, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import aiomqtt
import pytest
from mcp import Client
from mqtt_broker import Broker, mosquitto_or_skip, until
from remembered_room import a_day_with_grandma
from task_stage import TaskStage

import housefly
from housefly.bus.topics import TASKS_QUERY
from housefly.cli import main
from housefly.config.devices import MqttConfig
from housefly.config.tasks import TasksConfig
from housefly.errors import LinkError, TaskError
from housefly.hub.client.discovery import RoomAddress, announced
from housefly.hub.query_server import QueryServer
from housefly.tasks.api.questions import CancelTask, RequestTask, Sentence
from housefly.tasks.api.values import RequestSurface
from housefly.tasks.api.values import TaskStage as Stage
from housefly.tasks.assistants.assistant_reply import MARKED
from housefly.tasks.assistants.assistant_room import FoundRoom
from housefly.tasks.assistants.mcp_server import room_server
from housefly.tasks.rules.mqtt_link import MqttLink
from housefly.web.access.session_auth import api_key
from housefly.web.console_port import listening
from housefly.web.process import make_server
from housefly.web.server import create_app

pytestmark = [pytest.mark.wire]

SECRET = "a-secret-for-tests-only"
KEY = api_key(SECRET)
REQUEST, ANSWER = "housefly/home/task/request", "housefly/home/task/answer"
QUESTIONS = {
    "where is grandma's cup?": ("where", ("cup", "in the cabinet", "2 minutes ago")),
    "who came at three?": ("came_at", ("visitor", "15:02", "rang")),
    "has she got up?": ("got_up", ("Yes, grandma", "7:05")),
    "is the fridge empty?": ("contents", ("I know of nothing in the refrigerator",)),
    "who is at the door?": ("who", ("Somebody is at the door",)),
    "go and see": ("visitor", ()),
    "what happened last night?": ("what_happened", ("22:10", "the stove", "1:10")),
    "where did I leave the book?": ("where", ("near the sofa", "2 hours ago")),
    "is anybody in the room?": ("who", ("Grandma is sitting",)),
    "call me when the bell rings": ("call_me", ("I tell you",)),
}
GO = "go and see"


@dataclass
class House:
    """The room, and how each surface asks it: a sentence in, intent and words out.

    A surface that shows no intent gives "" for it.
    """

    stage: TaskStage
    address: str
    mqtt: int
    loop: asyncio.AbstractEventLoop
    surfaces: dict[str, Callable[[str], tuple[str, str]]] = field(default_factory=dict)

    def awaited(self, work: Coroutine[Any, Any, Any]) -> Any:
        return asyncio.run_coroutine_threadsafe(work, self.loop).result(20.0)

    def over_http(self, text: str) -> tuple[str, str]:
        body = json.dumps({"text": text})
        status, answer = post(self.address, "/api/v1/sentence", body)
        assert status == 200, answer
        return answer["intent"], answer["words"]

    def over_mqtt(self, text: str) -> tuple[str, str]:
        answer = self.awaited(self._over_mqtt({"ask": "sentence", "text": text}))
        return answer["intent"], answer["words"]

    async def _over_mqtt(self, question: dict[str, Any]) -> Any:
        async with aiomqtt.Client("127.0.0.1", self.mqtt) as panel:
            await panel.subscribe(ANSWER, qos=1)
            await panel.publish(REQUEST, json.dumps(question).encode(), qos=1)
            message = await asyncio.wait_for(anext(aiter(panel.messages)), 15.0)
            return json.loads(message.payload)

    def by_assistant(self, text: str) -> tuple[str, str]:
        answer = self.awaited(self._by_assistant(text))[MARKED]
        return answer["intent"], answer["words"]

    async def _by_assistant(self, text: str) -> Any:
        async with Client(room_server(FoundRoom())) as client:
            found = await client.call_tool("say", {"text": text})
            return found.structured_content or json.loads(found.content[0].text)

    def in_python(self, text: str) -> tuple[str, str]:
        with housefly.connect() as room:
            answer = room.say(text)
        return answer.intent, answer.words

    def in_python_from_afar(self, text: str) -> tuple[str, str]:
        with housefly.connect(address=self.address, key=KEY) as room:
            answer = room.say(text)
        return answer.intent, answer.words


def post(address: str, path: str, body: str) -> tuple[int, Any]:
    connection = http.client.HTTPConnection(address.removeprefix("http://"), timeout=15)
    try:
        connection.request("POST", path, body, {"Authorization": f"Bearer {KEY}"})
        answer = connection.getresponse()
        return answer.status, json.loads(answer.read())
    finally:
        connection.close()


@contextlib.contextmanager
def served(stage: TaskStage) -> Iterator[str]:
    """Serve the console of a room on a thread of its own."""
    with listening("127.0.0.1", 0) as listener:
        app = create_app(stage.bus, "a-token", lambda: None, secret=SECRET)
        server = make_server(app)
        thread = threading.Thread(target=lambda: asyncio.run(server.serve([listener])))
        thread.start()
        try:
            yield f"http://127.0.0.1:{listener.getsockname()[1]}"
        finally:
            server.should_exit = True
            thread.join(15.0)


@contextlib.contextmanager
def looping() -> Iterator[asyncio.AbstractEventLoop]:
    """Run an event loop on a thread of its own."""
    loop = asyncio.new_event_loop()
    thread = threading.Thread(target=loop.run_forever)
    thread.start()
    try:
        yield loop
    finally:
        loop.call_soon_threadsafe(loop.stop)
        thread.join(15.0)
        loop.close()


@contextlib.contextmanager
def on_mqtt(stage: TaskStage, loop: asyncio.AbstractEventLoop, folder: Path) -> Iterator[int]:
    """Have the tasks answer at a broker of their own."""
    mosquitto_or_skip()
    made = Broker(folder)

    def awaited(work: Coroutine[Any, Any, Any]) -> Any:
        return asyncio.run_coroutine_threadsafe(work, loop).result(20.0)

    async def begun() -> tuple[Any, asyncio.Task[None]]:
        await made.start()
        config = MqttConfig(broker="127.0.0.1", port=made.port, site="home")
        link = MqttLink(config, TasksConfig(), (), stage.service.answer, stage.wall)
        running = asyncio.create_task(link.run(lambda _: None))
        await until(lambda: not link.problem or "silent" in link.problem)
        return link, running

    _, running = awaited(begun())
    try:
        yield made.port
    finally:
        loop.call_soon_threadsafe(running.cancel)
        awaited(made.kill())


@pytest.fixture(scope="module")
def house(tmp_path_factory: pytest.TempPathFactory) -> Iterator[House]:
    folder = tmp_path_factory.mktemp("house")
    memory = a_day_with_grandma(folder / "memory.db")
    stage = TaskStage(folder, memory=memory)
    stage.bus.answer(TASKS_QUERY, stage.service.answer)
    stage.stand()
    with contextlib.ExitStack() as open_until_the_end:
        enter = open_until_the_end.enter_context
        patch = enter(pytest.MonkeyPatch.context())
        patch.setenv("XDG_RUNTIME_DIR", str(folder))
        address, loop = enter(served(stage)), enter(looping())
        port = enter(on_mqtt(stage, loop, folder))
        tasks = QueryServer(stage.service.answer, KEY, private(folder) / "tasks")
        open_until_the_end.callback(tasks.close)
        place = RoomAddress("bsen", address, KEY, os.getpid(), str(folder / "sockets" / "hub"))
        enter(announced(place))
        house = House(stage, address, port, loop)
        house.surfaces = {
            "the page and HTTP": house.over_http,
            "MQTT": house.over_mqtt,
            "an assistant": house.by_assistant,
            "Python": house.in_python,
            "Python from afar": house.in_python_from_afar,
        }
        yield house
    stage.close()
    memory.memory.close()


def private(folder: Path) -> Path:
    made = folder / "sockets"
    made.mkdir(mode=0o700)
    return made


@pytest.fixture(autouse=True)
def clean(house: House) -> None:
    house.stage.ask(CancelTask())
    house.stage.new_orders()
    house.stage.clock.advance(120.0)  # nobody is too many
    house.stage._unix -= 120.0


SURFACES = ("the page and HTTP", "MQTT", "an assistant", "Python", "Python from afar")


@pytest.mark.parametrize("surface", SURFACES)
def test_a_carers_ten_questions_are_answered(house: House, surface: str) -> None:
    for text, (intent, parts) in QUESTIONS.items():
        found, words = house.surfaces[surface](text)
        assert found == intent, (text, found, words)
        assert words and all(part in words for part in parts), (text, words)


def test_the_terminal_answers_a_carers_ten_questions(
    house: House, capsys: pytest.CaptureFixture[str]
) -> None:
    for text, (_, parts) in QUESTIONS.items():
        code = main(["ask", "--language", "en", "--no-wait", text])
        said = capsys.readouterr().out
        assert code == 0 and said.strip(), (text, said)
        assert all(part in said for part in parts), (text, said)


@pytest.mark.parametrize(
    ("surface", "state"),
    [
        ("the page and HTTP", Stage.QUEUED),
        ("Python", Stage.QUEUED),
        ("Python from afar", Stage.QUEUED),
        ("MQTT", Stage.WAITING),
        ("an assistant", Stage.WAITING),
    ],
)
def test_only_people_begin_a_flight_by_a_sentence_others_ask_a_person(
    house: House, surface: str, state: Stage
) -> None:
    _, words = house.surfaces[surface](GO)
    (task,) = house.stage.service.board().tasks
    assert task.state is state
    assert ("somebody says yes" in words) is (state is Stage.WAITING), words
    assert house.stage.new_orders() == []


@pytest.mark.parametrize("surface", ["MQTT", "an assistant"])
@pytest.mark.parametrize("text", ["land", "come home", "go on", "set the house to away"])
def test_what_only_people_may_order_is_refused_in_words_and_not_done(
    house: House, surface: str, text: str
) -> None:
    before = house.stage.service.board().mode
    _, words = house.surfaces[surface](text)
    assert "Only a person may" in words or "who may fly" in words, words
    assert house.stage.new_orders() == []
    assert house.stage.service.board().mode is before


@pytest.mark.parametrize("surface", SURFACES)
def test_stop_is_ordered_from_everywhere_and_said_to_be_ordered(house: House, surface: str) -> None:
    _, words = house.surfaces[surface]("stop!")
    assert words.startswith("STOP is ordered.")
    assert [order.kind.value for order in house.stage.new_orders()] == ["stop"]


def test_from_afar_the_tasks_are_asked_with_the_same_calls(house: House) -> None:
    with housefly.connect(address=house.address, key=KEY) as room:
        room.by = "kim's script"
        task = room.request("look", subject="sofa")
        assert (task.asked_by, task.surface) == ("kim's script", RequestSurface.COMMAND_LINE)
        assert [one.id for one in room.tasks().tasks] == [task.id]
        assert room.rehearse("look", subject="sofa").may_fly
        assert {one.name for one in room.services()} >= {"look", "visitor"}
        assert room.task_history(limit=1)[0].id == task.id
        assert room.pause(task.id).state is Stage.PAUSED
        assert room.proceed(task.id).state is Stage.QUEUED
        assert [one.state for one in room.cancel(task.id)] == [Stage.CANCELLED]
        with pytest.raises(TaskError, match="did you mean look") as caught:
            room.request("loook")
        assert caught.value.code == "unknown_service"
        with pytest.raises(TaskError, match="owner is filled in"):
            room.ask_tasks(RequestTask("look", owner="somebody else"))
        with pytest.raises(TaskError, match="may_fly is filled in"):
            room.ask_tasks(Sentence("go and see", may_fly=False))


def test_from_afar_a_wrong_key_or_address_is_said(house: House) -> None:
    with (
        housefly.connect(address=house.address, key="wrong") as room,
        pytest.raises(LinkError, match="key of this run"),
    ):
        room.tasks()
    with (
        housefly.connect(address="http://127.0.0.1:9", key=KEY) as room,
        pytest.raises(LinkError, match="does not answer"),
    ):
        room.services()
    for address in ("nonsense", "ftp://somewhere", "http://here:port"):
        with pytest.raises(LinkError, match="is no address"):
            housefly.connect(address=address, key=KEY)
