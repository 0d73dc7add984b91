"""What the server sends to all browsers unasked: state at 20 Hz, events, checks, the room."""

from __future__ import annotations

import asyncio
import logging
import time

from housefly.errors import HouseflyError
from housefly.hub.api.pilot_queries import PlanRequest, PreflightView
from housefly.messages import Severity
from housefly.messages.words import Words
from housefly.web.access.session_watch import LOOK_PERIOD
from housefly.web.messages.server_messages import (
    LinkMessage,
    PreflightMessage,
    RoomMessage,
    TasksMessage,
    to_text,
)
from housefly.web.messages.verdict_message import ConsoleVerdict
from housefly.web.sockets.console import Console
from housefly.web.status.task_feed import BOARD_PERIOD, TaskFeed
from housefly.web.status.verdict import says_the_same

_LOG = logging.getLogger(__name__)

_STATE_RATE = 20.0
"""States a second."""
_VERDICT_PERIOD = 0.5
"""A verdict is sent at least so often [s]: a page that misses three of them says so."""
_ROOM_RETRY_PERIOD = 1.0
"""Pause between two requests for the room until the pilot answers [s]."""
_HOME_PLAN_PERIOD = 2.0
"""How often the way home is planned, for the battery bar [s]."""
_PREFLIGHT_PERIOD = 1.0
"""How often the pilot is asked, on the ground, what its pre-flight checks found last [s]."""
_PREFLIGHT_RETRY_PERIOD = 0.25
"""How soon it is asked again while nothing is known, and whether it has landed [s]."""
_SETTLED = 1.0
"""What the pilot found last may be of the flight for so long after a landing [s]."""


_MISSED_TRIES, _MISSED_PERIOD = 10, 1.0
"""So often, and so often apart [s], the memory is asked what an ended console has missed."""


class Broadcast:
    """The loops that run as long as the server."""

    def __init__(self, console: Console) -> None:
        self._console = console
        self._home_s = 0.0
        self._flew_at = -_SETTLED
        self._sequence = -1
        self._path = -1
        self._link: LinkMessage | None = None
        self._tasks: TasksMessage | None = None
        self._verdict: ConsoleVerdict | None = None

    async def run(self) -> None:
        """Run until cancelled."""
        async with asyncio.TaskGroup() as tasks:
            tasks.create_task(self._send_changes())
            tasks.create_task(self._watch_room())
            tasks.create_task(self._watch_return_time())
            tasks.create_task(self._watch_preflight())
            tasks.create_task(self._watch_sessions())
            tasks.create_task(self._learn_missed())
            if self._console.tasks is not None:
                tasks.create_task(self._watch_tasks(self._console.tasks))

    async def _send_changes(self) -> None:
        while True:
            await asyncio.sleep(1.0 / _STATE_RATE)
            self._console.control.expire()
            self._console.keep_stop()
            self._console.keep_control()
            self._send_link()
            self._send_path()
            self._send_tasks()
            self._send_state()
            self._send_verdict()
            self._console.viewers.send_events(self._console.feed)
            self._console.viewers.send_refusals(self._console.feed.refusals())

    def _send_state(self) -> None:
        step = self._console.feed.step
        if step is None or step.sequence == self._sequence:
            return
        self._sequence = step.sequence
        if (state := self._console.feed.state(self._home_s)) is not None:
            self._console.viewers.broadcast("state", to_text(state))

    def _send_verdict(self) -> None:
        """Send what changed at once; otherwise often enough to be missed when it stays away."""
        verdict, last = self._console.verdict(), self._verdict
        is_due = last is None or verdict.at - last.at >= _VERDICT_PERIOD
        if last is None or is_due or not says_the_same(verdict, last):
            self._verdict = verdict
            self._console.viewers.broadcast("verdict", to_text(verdict))

    def _send_link(self) -> None:
        link = self._console.feed.link()
        if link is not None and link is not self._link:
            self._link = link
            self._console.viewers.broadcast("link", to_text(link))

    def _send_path(self) -> None:
        path = self._console.feed.path()
        if path.number != self._path:
            self._path = path.number
            self._console.viewers.broadcast("path", to_text(path))

    def _send_tasks(self) -> None:
        told = self._console.tasks.message() if self._console.tasks else None
        if told is not None and told != self._tasks:
            self._tasks = told
            self._console.viewers.broadcast("tasks", to_text(told))

    async def _watch_tasks(self, feed: TaskFeed) -> None:
        while True:
            await feed.ask()
            await asyncio.sleep(BOARD_PERIOD)

    async def _watch_room(self) -> None:
        """Ask for the room until the pilot answers, and again when a pilot has restarted."""
        known_restarts = -1
        while True:
            restarts = self._console.feed.restarts
            if restarts != known_restarts:
                try:
                    self._console.room = await self._console.link.room()
                except HouseflyError as error:
                    _LOG.debug("the room is not known yet: %s", error)
                else:
                    known_restarts = restarts
                    self._console.viewers.broadcast(
                        "room", to_text(RoomMessage(self._console.room))
                    )
            await asyncio.sleep(_ROOM_RETRY_PERIOD)

    async def _learn_missed(self) -> None:
        """Complete the log after a restart; the memory may start again as well."""
        for _ in range(_MISSED_TRIES):
            try:
                return await self._console.learn_missed(time.time())
            except HouseflyError as error:
                _LOG.debug("what was missed is not known yet: %s", error)
            await asyncio.sleep(_MISSED_PERIOD)
        text = Words("nobody knows what happened while the console was away")
        self._console.feed.log_event(Severity.WARNING, "console", text)

    async def _watch_return_time(self) -> None:
        while True:
            await asyncio.sleep(_HOME_PLAN_PERIOD)
            self._home_s = await self._plan_home() if self._console.flying else 0.0

    async def _watch_preflight(self) -> None:
        while True:
            found = await self._preflight()
            if found != self._console.preflight:
                self._console.preflight = found
                self._console.viewers.broadcast("preflight", to_text(PreflightMessage(found)))
            await asyncio.sleep(_PREFLIGHT_PERIOD if found.checks else _PREFLIGHT_RETRY_PERIOD)

    async def _watch_sessions(self) -> None:
        while True:
            await asyncio.sleep(LOOK_PERIOD)
            self._console.check_sessions()
            self._console.refusals.write_counted()

    async def _preflight(self) -> PreflightView:
        """Return what the checks found; nothing in flight, so that nobody reads old ones later."""
        now = asyncio.get_running_loop().time()
        if self._console.flying:
            self._flew_at = now
        if now - self._flew_at < _SETTLED or not self._console.pilot_is_heard:
            return PreflightView()
        try:
            return await self._console.link.preflight()
        except HouseflyError as error:
            _LOG.debug("no pre-flight checks: %s", error)
            return PreflightView()

    async def _plan_home(self) -> float:
        if self._console.room is None:
            return 0.0
        try:
            answer = await self._console.link.plan(PlanRequest(goal=self._console.room.home))
        except HouseflyError:
            return self._home_s
        return answer.duration if answer.path else self._home_s
