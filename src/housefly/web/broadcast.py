"""What the server tells all browsers by itself: the state twenty times a second, events, link,
path, the room.
"""

from __future__ import annotations

import asyncio
import logging

from housefly.errors import HouseflyError
from housefly.hub.api.queries import PlanRequest
from housefly.web.console import Console
from housefly.web.vocabulary import LinkNews, RoomNews, to_text

log = logging.getLogger(__name__)

RATE_HZ = 20.0
ROOM_PAUSE = 1.0
"""Pause between two questions for the room while nobody answers [s]."""
HOME_PERIOD = 2.0
"""How often the way home is planned, for the battery bar [s]."""


class Broadcast:
    """The loops that run as long as the server."""

    def __init__(self, console: Console) -> None:
        self._console = console
        self._home_s = 0.0
        self._sequence = -1
        self._path = -1
        self._link: LinkNews | None = None

    async def run(self) -> None:
        """Run until cancelled."""
        async with asyncio.TaskGroup() as tasks:
            tasks.create_task(self._tell())
            tasks.create_task(self._watch_room())
            tasks.create_task(self._watch_way_home())

    async def _tell(self) -> None:
        while True:
            await asyncio.sleep(1.0 / RATE_HZ)
            self._console.check_lease()
            self._tell_link()
            self._tell_path()
            self._tell_state()
            self._console.send_events()

    def _tell_state(self) -> None:
        step = self._console.news.step
        if step is None or step.sequence == self._sequence:
            return
        self._sequence = step.sequence
        if (state := self._console.news.state(self._home_s)) is not None:
            self._console.show("state", to_text(state))

    def _tell_link(self) -> None:
        link = self._console.news.link()
        if link is not None and link is not self._link:
            self._link = link
            self._console.show("link", to_text(link))

    def _tell_path(self) -> None:
        path = self._console.news.path()
        if path.number != self._path:
            self._path = path.number
            self._console.show("path", to_text(path))

    async def _watch_room(self) -> None:
        """Ask for the room until the pilot answers, and again after a new pilot came."""
        known_restarts = -1
        while True:
            restarts = self._console.news.restarts
            if restarts != known_restarts:
                try:
                    self._console.room = await self._console.link.room()
                except HouseflyError as error:
                    log.debug("the room is not known yet: %s", error)
                else:
                    known_restarts = restarts
                    self._console.show("room", to_text(RoomNews(self._console.room)))
            await asyncio.sleep(ROOM_PAUSE)

    async def _watch_way_home(self) -> None:
        while True:
            await asyncio.sleep(HOME_PERIOD)
            self._home_s = await self._plan_home() if self._console.flying else 0.0

    async def _plan_home(self) -> float:
        if self._console.room is None:
            return 0.0
        try:
            answer = await self._console.link.plan(PlanRequest(goal=self._console.room.home))
        except HouseflyError:
            return self._home_s
        return answer.duration if answer.path else self._home_s
