"""A console with a hub and tasks behind it, on a thread of its own; it may go and come back."""

from __future__ import annotations

import asyncio
import socket
import threading
import time
from pathlib import Path

import uvicorn
from stand_in_tasks import StandInTasks

from housefly.bus.local import LocalBus
from housefly.bus.topics import HUB_QUERY
from housefly.errors import HouseflyError
from housefly.hub.api.json import answer_to_json, question_from_json, refusal_to_json
from housefly.hub.api.topics import ROOM_NEWS_TOPIC
from housefly.hub.change_feed import ChangeFeed
from housefly.hub.memory import RoomMemory
from housefly.hub.query_handler import QueryHandler
from housefly.hub.room_status import RoomStatus
from housefly.hub.store.open import open_store
from housefly.hub.things.thing import Thing, ThingKind
from housefly.messages import Observation
from housefly.web.access.session_auth import api_key
from housefly.web.process import make_server
from housefly.web.server import create_app

SECRET = "a-secret-for-tests-only"
KEY = api_key(SECRET)
HOOK_KEY = "a-key-of-webhooks-for-tests"


class ServedRoom:
    """Serves until closed.

    Args:
        host: loopback address.
        folder: for the memory.

    Attributes:
        stops: when STOP went its own path [s].
    """

    def __init__(self, host: str, folder: Path) -> None:
        self.host, self.port, self.stops = host, 0, list[float]()
        self.bus = LocalBus()
        things = (
            Thing("cabinet", "the cabinet", ThingKind.FURNITURE, position=(1.0, 2.0, 0.5)),
            Thing("cup", "cup", inside="cabinet"),
        )
        self.memory = RoomMemory(things, lambda: open_store(folder / "room.db"))
        self.status = RoomStatus(self.memory.writer.report)
        self.change_feed = ChangeFeed(self.memory, self.status, time.time)
        answers = QueryHandler(self.memory, self.status, time.time)

        def answer(text: str) -> str:
            try:
                return answer_to_json(answers.answer(question_from_json(text)))
            except HouseflyError as error:
                return refusal_to_json(error)

        self.answering = self.bus.join().answer(HUB_QUERY, answer)
        self.tasks = StandInTasks(self.bus.join())
        self.come()

    @property
    def address(self) -> str:
        """Of the console."""
        return f"http://{self.host}:{self.port}"

    def come(self) -> None:
        """Serve, at the port that there was before."""
        member = self.bus.join()
        app = create_app(
            member,
            "token",
            lambda: self.stops.append(time.monotonic()),
            hosts=frozenset({self.host}),
            secret=SECRET,
            hook_key=HOOK_KEY,
        )
        self.server: uvicorn.Server = make_server(app)
        listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.bind((self.host, self.port))
        self.port = int(listener.getsockname()[1])
        self.thread = threading.Thread(target=lambda: asyncio.run(self.server.serve([listener])))
        self.thread.start()
        while not self.server.started:
            time.sleep(0.01)

    def go(self) -> None:
        """Serve no more."""
        self.server.should_exit = True
        self.thread.join()

    def move_cup(self, x: float) -> None:
        """Let the cup be somewhere, and tell it."""
        now = time.time()
        self.memory.add(Observation("cup", "floor", now, now, (x, 1.0, 0.0)))
        if (news := self.change_feed.changes()) is not None:
            self.bus.publish(ROOM_NEWS_TOPIC, news)

    def close(self) -> None:
        """Serve no more, and forget."""
        self.go()
        self.memory.close()
