"""A console that serves rosbridge, with a pilot that answers and tasks that fly nothing."""

from __future__ import annotations

import asyncio
import contextlib
import http.client
import json
import socket
import threading
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal, Self

from ros_stage import AnsweringPilot
from stand_in_tasks import StandInTasks
from websockets.sync.client import ClientConnection, connect

from housefly.bus.local import LocalBus
from housefly.bus.topics import HUB_QUERY
from housefly.clock import RealClock
from housefly.sites.loaded_site import load_site
from housefly.web.access.audit_log import AuditLog
from housefly.web.access.invitations import Invitations
from housefly.web.access.roles import Role
from housefly.web.access.session_auth import api_key
from housefly.web.process import make_server
from housefly.web.rosbridge.bridge_room import BridgeRoom
from housefly.web.server import create_app

SECRET, TOKEN = "a-secret-for-tests-only", "a-token-for-tests-only"
KEY = api_key(SECRET)
ROOM, DRONE = "/b_sen", "/b_sen/drone"
PATIENCE = 30.0


@dataclass
class BridgeTalk:
    """A client of rosbridge, message by message."""

    socket: ClientConnection
    heard: list[dict[str, Any]] = field(default_factory=list)
    _number: int = 0

    def say(self, op: str, **rest: Any) -> None:
        """Send one message."""
        self.socket.send(json.dumps({"op": op, **rest}))

    def hear(self, op: str, **expected: Any) -> dict[str, Any]:
        """Return the first message, not returned before, that has the expected values."""
        wanted, deadline = {"op": op, **expected}.items(), time.monotonic() + PATIENCE
        while True:
            for message in self.heard:
                if all(message.get(key) == value for key, value in wanted):
                    self.heard.remove(message)
                    return message
            told: dict[str, Any] = json.loads(self.socket.recv(deadline - time.monotonic()))
            self.heard.append(told)

    def message(self, topic: str, **rest: Any) -> Any:
        """Subscribe to a topic and return a message of it."""
        self.say("subscribe", topic=topic, **rest)
        return self.hear("publish", topic=topic)["msg"]

    def call(self, service: str, args: Any = None) -> dict[str, Any]:
        """Return the response of a service."""
        self._number += 1
        ident = f"call:{service}:{self._number}"
        self.say("call_service", service=service, id=ident, args=args or {})
        return self.hear("service_response", id=ident)

    def refusal(self, op: str, **rest: Any) -> str:
        """Send a message that is refused; return why."""
        self.say(op, **rest)
        return str(self.hear("status", level="error")["msg"])


class RosbridgeStage:
    """Serves until closed.

    Args:
        host: loopback address.
        folder: for the log of commands.
        requests: of the site.
        origins: of the site.
        changes: of the rest of the site.
    """

    def __init__(
        self,
        host: str,
        folder: Path,
        requests: Literal["off", "ask", "auto"],
        origins: tuple[str, ...] = (),
        **changes: Any,
    ) -> None:
        self.host, self.stops = host, list[float]()
        self.bus = LocalBus()
        self.tasks = StandInTasks(self.bus.join())
        self.bus.answer(HUB_QUERY, lambda text: json.dumps({"asked": json.loads(text)}))
        loaded = load_site("bsen", hub__enabled=False, **changes)
        self.audit_file = folder / "commands.jsonl"
        self.edition = 0
        self.bridge = BridgeRoom(self.bus, lambda: loaded, lambda: self.edition, requests, origins)
        app = create_app(
            self.bus,
            TOKEN,
            lambda: self.stops.append(time.monotonic()),
            hosts=frozenset({host}),
            secret=SECRET,
            rosbridge=self.bridge,
            audit=AuditLog(self.audit_file),
        )
        self._server: Any = make_server(app)
        listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)
        listener.bind((host, 0))
        self.port = int(listener.getsockname()[1])
        self._thread = threading.Thread(
            target=lambda: asyncio.run(self._server.serve([listener])), daemon=True
        )

    def __enter__(self) -> Self:
        self.pilot = AnsweringPilot(self.bus).__enter__()
        self._thread.start()
        self.until(lambda: self._server.started)
        self.until(lambda: self.bridge.room is not None and self.bridge.room.errands)
        return self

    def __exit__(self, *_: object) -> None:
        self._server.should_exit = True
        self._thread.join()
        self.pilot.__exit__()
        self.tasks.close()

    @property
    def origin(self) -> str:
        """Of the console's own page."""
        return f"http://{self.host}:{self.port}"

    def until(self, condition: Any) -> None:
        """Wait for something to hold."""
        deadline = time.monotonic() + PATIENCE
        while not condition():
            assert time.monotonic() < deadline, "it did not come to hold"
            time.sleep(0.01)

    @contextlib.contextmanager
    def program(self, **options: Any) -> Iterator[BridgeTalk]:
        """Connect as a program with the key of the run."""
        headers = {"Authorization": f"Bearer {KEY}"}
        with self._connected(additional_headers=headers, **options) as talk:
            yield talk

    @contextlib.contextmanager
    def page(self, role: str) -> Iterator[BridgeTalk]:
        """Connect as a page of the console, in a session of a role."""
        cookie, proof = self.session(role)
        headers = {"Cookie": cookie, "X-Housefly-Proof": proof}
        with self._connected(additional_headers=headers, origin=self.origin) as talk:
            yield talk

    @contextlib.contextmanager
    def _connected(self, path: str = "/rosbridge", **options: Any) -> Iterator[BridgeTalk]:
        address = f"ws://{self.host}:{self.port}{path}"
        with connect(address, close_timeout=0.2, max_size=2**24, **options) as one:
            yield BridgeTalk(one)

    def session(self, role: str) -> tuple[str, str]:
        """Return cookie and proof of a new session."""
        invitation = Invitations(SECRET, RealClock()).new(Role(role))
        connection = http.client.HTTPConnection(self.host, self.port, timeout=PATIENCE)
        connection.request("GET", f"/?token={invitation.token}")
        answer = connection.getresponse()
        answer.read()
        connection.close()
        cookie = (answer.getheader("set-cookie") or "").partition(";")[0]
        return cookie, (answer.getheader("location") or "").partition("?proof=")[2]
