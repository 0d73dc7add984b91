"""``/rosbridge``: who may open it, and the two directions of one socket."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from contextlib import suppress
from functools import partial

from starlette.routing import BaseRoute, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from housefly.clock import Clock
from housefly.config.ros2 import RosRequests
from housefly.ros2.ros_caller import RosCaller
from housefly.web.access.audit_log import AuditLog
from housefly.web.access.bearer import bears, is_key
from housefly.web.access.roles import Role
from housefly.web.access.session import Session
from housefly.web.access.session_auth import SessionAuth, chosen_subprotocol, same_origin
from housefly.web.access.session_watch import while_logged_in
from housefly.web.http.seats import Seats
from housefly.web.rosbridge.bridge_room import BridgeRoom
from housefly.web.rosbridge.calls import Calls
from housefly.web.rosbridge.client import BridgeClient
from housefly.web.rosbridge.outbox import Outbox

ROSBRIDGE_PATHS = ("/rosbridge", "/")
"""Clients that take a host and a port alone ask for the second."""
_WHO_MAY = "open it with the session of the console, or with the key of this run"
_KEY = "key"
"""Parameter of the address: a page cannot set the headers of a WebSocket."""
_PROGRAM = "rosbridge"
_SEATS = 16
_READ_AT_ONCE, _FLOOD_PAUSE = 20, 0.02
"""After so many refused messages a socket is not read for a moment [s]."""
_REFUSED_MAX = 500
"""A socket that sends this many messages in a row above the limit is closed."""


class RosbridgeRoute:
    """Serves the clients of one room.

    Args:
        bridge: the room.
        auth: the console's sessions.
        key: bearer token of programs; "" lets none in.
        stop: sends STOP, in somebody's name and of a session, to a drone.
        name_of: the name that others see for a session's owner.
        audit: where every wish is written down.
        clock: of the console.
    """

    def __init__(
        self,
        bridge: BridgeRoom,
        auth: SessionAuth,
        key: str,
        stop: Callable[[str, str, str], None],
        name_of: Callable[[str], str],
        audit: AuditLog | None,
        clock: Clock,
    ) -> None:
        self._bridge, self._auth, self._key = bridge, auth, key
        self._stop, self._name_of, self._audit, self._clock = stop, name_of, audit, clock
        self._seats, self._calls = Seats(_SEATS), Calls()

    def routes(self) -> list[BaseRoute]:
        """Return the routes."""
        return [WebSocketRoute(path, self._socket) for path in ROSBRIDGE_PATHS]

    def close(self) -> None:
        """Let the room and the threads go."""
        self._bridge.close()
        self._calls.close()

    async def _socket(self, websocket: WebSocket) -> None:
        is_program = bears(websocket, self._key) or is_key(
            websocket.query_params.get(_KEY, ""), self._key
        )
        session = None if is_program else self._auth.session_of(websocket)
        if not (is_program or session) or not self._may_come_from(websocket, is_program):
            await websocket.close(1008, _WHO_MAY)
            return
        with self._seats.taken(session.owner if session else "") as seated:
            if not seated:
                await websocket.close(1013, "too many clients, in all or of this session")
                return
            await websocket.accept(chosen_subprotocol(websocket))
            async with while_logged_in(websocket, self._auth, session, Role.WATCH):
                await self._serve(websocket, session)

    def _may_come_from(self, websocket: WebSocket, is_program: bool) -> bool:
        """Return whether its page may: ours, no page at all, or one that the site names."""
        origin = websocket.headers.get("origin")
        if same_origin(websocket):
            return True
        return is_program and (not origin or origin in self._bridge.origins)

    def _caller(self, session: Session | None) -> RosCaller | None:
        if session is None:
            return _caller_of(None, "", self._bridge.requests)
        now = self._auth.renewed(session)
        if now is None:
            return None
        return _caller_of(now, self._shown(now), self._bridge.requests)

    def _shown(self, session: Session) -> str:
        return session.user or self._name_of(session.owner)

    def _client(self, session: Session | None, outbox: Outbox) -> BridgeClient:
        first = self._caller(session)
        name = first.name if first is not None else ""
        number = session.name if session else ""
        record = partial(self._audit.record, name, number) if self._audit else _forget
        return BridgeClient(
            self._bridge,
            self._calls,
            outbox,
            partial(self._caller, session),
            partial(self._stop, name, number),
            record,
            self._clock,
        )

    async def _serve(self, websocket: WebSocket, session: Session | None) -> None:
        """Carry messages both ways until either side leaves."""
        outbox = Outbox(asyncio.get_running_loop())
        client = self._client(session, outbox)
        writer = asyncio.create_task(_write(websocket, outbox))
        try:
            while not writer.done() and client.limiter.refused <= _REFUSED_MAX:
                message = await websocket.receive()
                if message["type"] == "websocket.disconnect":
                    break
                client.receive(message.get("text") or "")
                # Others must have their turn, and who sends too much is read slowly.
                slow = client.limiter.refused % _READ_AT_ONCE == _READ_AT_ONCE - 1
                await asyncio.sleep(_FLOOD_PAUSE if slow else 0.0)
            else:
                with suppress(RuntimeError):
                    await websocket.close(1008, "too many messages, or none is read")
        finally:
            client.close()
            writer.cancel()
            with suppress(asyncio.CancelledError, WebSocketDisconnect, RuntimeError, OSError):
                await writer


async def _write(websocket: WebSocket, outbox: Outbox) -> None:
    while True:
        await websocket.send_text(await outbox.next())


def _forget(words: str) -> None:
    pass


def _caller_of(session: Session | None, name: str, requests: RosRequests) -> RosCaller:
    """Return who calls; a session may what its role may, and no more than the site allows.

    Args:
        session: of a browser; None for a program with the key of the run.
        name: that others see for the session.
        requests: of the site.
    """
    if session is None:
        return RosCaller(_PROGRAM, _PROGRAM, requests)
    shown, role = f"{name} ({_PROGRAM})", session.role
    if role.includes(Role.FLY):
        return RosCaller(shown, session.owner, requests)
    if role.includes(Role.ASK):
        asks: RosRequests = "off" if requests == "off" else "ask"
        return RosCaller(shown, session.owner, asks, may_fly=False)
    return RosCaller(shown, session.owner, "off", may_ask=False, may_fly=False)
