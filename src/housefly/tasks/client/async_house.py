"""Ask a running room and its tasks with asyncio.

import asyncio
import housefly

async def main():
    house = housefly.AsyncHouse()
    print((await house.where("cup")).words)
    task = await house.request("look", subject="refrigerator")
    print((await house.ended(task.id)).words)
    async for news in house.news():
        print(news.events)

asyncio.run(main())
"""

from __future__ import annotations

import asyncio
import ssl
from collections.abc import AsyncGenerator
from typing import Any
from urllib.parse import urlencode

from housefly.errors import LinkError, TaskError
from housefly.hub.api.answers import EventsAnswer, News
from housefly.hub.api.endpoints import API_PREFIX
from housefly.hub.api.json import answer_from_json
from housefly.hub.api.questions import EventsQuestion, Question
from housefly.hub.client.async_http import AsyncHttp
from housefly.hub.client.async_news import NewsSource
from housefly.hub.client.async_room_queries import AsyncRoomQueries
from housefly.hub.client.console_address import console_address_of
from housefly.hub.client.discovery import RoomAddress, find
from housefly.hub.client.http import checked_answer, room_path
from housefly.messages import PilotStep
from housefly.tasks.api.json import task_answer_from_json
from housefly.tasks.api.questions import TaskQuestion
from housefly.tasks.api.values import ENDED, ReasonCode, TaskStatus
from housefly.tasks.client.async_steps import pilot_steps
from housefly.tasks.client.async_task_queries import AsyncTaskQueries
from housefly.tasks.client.http_tasks import checked_task_answer, task_request

_TIMEOUT = 30.0
"""Of one question; rehearsals take seconds [s]."""
_MISSED_MAX = 1000
"""So many events that were missed are asked for, the newest."""
_LOOK_PERIOD = 0.5
"""How often the board is looked at while a task is waited for [s]."""


class AsyncHouse(AsyncRoomQueries, AsyncTaskQueries):
    """A client of one room and its tasks; holds no connection, so any number may be awaited.

    What is cancelled is asked no more; a task that was requested goes on (``cancel`` ends it).

    Args:
        site: name of the site that runs on this machine; "" for the one that was started last.
        address: of a console elsewhere, for example http://10.0.0.7:8080, with its ``key``.
        key: bearer token of that run.
        by: who wants what is asked of the tasks, in words.
        timeout: of one question [s].
        tls: whom to trust at an https address; None for the usual authorities.

    Attributes:
        place: the run.

    Raises:
        LinkError: no room is running here, or that is no address.
    """

    def __init__(
        self,
        site: str = "",
        *,
        address: str = "",
        key: str = "",
        by: str = "a program",
        timeout: float = _TIMEOUT,
        tls: ssl.SSLContext | None = None,
    ) -> None:
        self.place = RoomAddress(site, address, key, 0) if address else find(site)
        self.by, self._tls = by, tls
        self._address = console_address_of(self.place.address)
        self._http = AsyncHttp(self._address, self.place.key, timeout, tls)

    async def ask(self, question: Question) -> Any:
        """Return the answer to a question.

        Raises:
            ThingError: there is no such thing.
            WireError: a value of the question is not allowed.
            LinkError: nobody answers.
        """
        status, text = await self._http.request("GET", room_path(question))
        return answer_from_json(question, checked_answer(status, text))

    async def ask_tasks(self, question: TaskQuestion) -> Any:
        """Return the answer; raises TaskError when it is refused, LinkError if nobody answers."""
        status, text = await self._http.request(*task_request(question))
        return task_answer_from_json(question, checked_task_answer(status, text))

    async def stop(self, drone: str = "") -> None:
        """Send STOP to a drone, to all for ""; raises LinkError if the console does not take it."""
        await self._ordered("/stop", drone)

    async def land(self, drone: str = "") -> None:
        """Land a drone where it is, all that fly for ""; raises LinkError as ``stop``."""
        await self._ordered("/land", drone)

    async def ended(self, task: int) -> TaskStatus:
        """Return a task once it has ended; raises TaskError where there is none."""
        while True:
            board = await self.tasks()
            found = next((one for one in (*board.tasks, *board.ended) if one.id == task), None)
            if found is None:
                raise TaskError(f"there is no task {task}", ReasonCode.UNKNOWN_TASK.value)
            if found.state in ENDED:
                return found
            await asyncio.sleep(_LOOK_PERIOD)

    def news(self, *, reconnect: bool = True) -> AsyncGenerator[News]:
        """Yield the room as it is, then changes as they happen, until cancelled.

        Args:
            reconnect: whether a lost connection is made again: then the room comes as it is, with
                the events that were missed; else its end raises LinkError.
        """
        scheme = "wss" if self._address.is_secure else "ws"
        url = f"{scheme}://{self._address.netloc}{API_PREFIX}/watch"
        source = NewsSource(url, self.place.key, self._tls, self._missed)
        return source.follow(reconnect=reconnect)

    def steps(self, drone: str = "") -> AsyncGenerator[PilotStep]:
        """Yield the steps of a pilot, of the first drone for "", from the bus of this machine.

        Who reads slowly gets the newest. Raises LinkError for a room elsewhere.
        """
        if not self.place.bus:
            raise LinkError("the steps of a pilot are told on the machine where it runs")
        return pilot_steps(self.place.bus, drone or self.place.drones[0])

    async def _missed(self, since: float | None) -> News:
        """Return the room as it is, with what happened since a time [Unix time, s]."""
        picture = await self.picture()
        events = EventsAnswer(())
        if since is not None:
            events = await self.ask(EventsQuestion(since, limit=_MISSED_MAX))
        return News(
            picture.at, picture.things, events.events, picture.situations, picture.obstacles
        )

    async def _ordered(self, path: str, drone: str) -> None:
        given = f"?{urlencode({'drone': drone})}" if drone else ""
        status, text = await self._http.request("POST", f"{path}{given}")
        if status != 200:
            raise LinkError(f"the console does not take it: {text}")
