"""News of a room for asyncio, through restarts of its console: what was missed is told then."""

from __future__ import annotations

import asyncio
import ssl
from collections import deque
from collections.abc import AsyncGenerator, Awaitable, Callable
from contextlib import aclosing
from dataclasses import dataclass, field, replace

from pydantic import TypeAdapter, ValidationError
from websockets.asyncio.client import connect
from websockets.exceptions import InvalidStatus, WebSocketException

from housefly.errors import LinkError, WireError
from housefly.hub.api.answers import EventAnswer, News

_NEWS: TypeAdapter[News] = TypeAdapter(News)
_PAUSE, _PAUSE_MAX = 0.2, 5.0
"""Between two attempts to connect; twice as long each time [s]."""
LATE_MAX = 60.0
"""How much later than it happened something may be told [s]."""
_REMEMBERED = 1000
_NEWS_MAX = 4 * 2**20
"""Longest news [bytes]."""


@dataclass(slots=True)
class SeenEvents:
    """Which events were told, so that none is told twice. Pure.

    Attributes:
        at: time of the newest news [Unix time, s]; None before the first.
    """

    at: float | None = None
    _keys: deque[tuple[object, ...]] = field(default_factory=lambda: deque(maxlen=_REMEMBERED))

    def fresh(self, news: News) -> News:
        """Return news without the events that were told before."""
        events = tuple(one for one in news.events if _key(one) not in self._keys)
        self._keys.extend(map(_key, events))
        self.at = max(news.at, news.at if self.at is None else self.at)
        return replace(news, events=events)


@dataclass(frozen=True, slots=True)
class NewsSource:
    """Where news are heard.

    Attributes:
        url: of the WebSocket.
        key: bearer token of the run.
        tls: whom to trust; None for the usual authorities.
        missed: returns the room as it is, with what happened since a time [Unix time, s]; None for
            nothing.
    """

    url: str
    key: str
    tls: ssl.SSLContext | None
    missed: Callable[[float | None], Awaitable[News]]

    async def follow(self, *, reconnect: bool) -> AsyncGenerator[News]:
        """Yield news until cancelled; the first is the room as it is.

        Args:
            reconnect: whether a connection that was there is made again and again; else its end
                raises LinkError.

        Raises:
            LinkError: the room is not there, or does not let us listen.
            WireError: these are no news.
        """
        seen, pause, was_there = SeenEvents(), _PAUSE, False
        while True:
            try:
                async with aclosing(self._heard(seen.at)) as heard:
                    async for news in heard:
                        pause, was_there = _PAUSE, True
                        yield seen.fresh(news)
                words = "it closed the connection"
            except InvalidStatus as error:
                if error.response.status_code in (401, 403):
                    raise LinkError("the room does not let us listen: its key") from error
                words = str(error)
            except (OSError, TimeoutError, WebSocketException, LinkError) as error:
                words = str(error)
            except ValidationError as error:
                raise WireError(f"these are no news: {error.errors()[0]['msg']}") from error
            if not (reconnect and was_there):
                raise LinkError(f"the room went away: {words}")
            await asyncio.sleep(pause)
            pause = min(2.0 * pause, _PAUSE_MAX)

    async def _heard(self, since: float | None) -> AsyncGenerator[News]:
        headers = {"Authorization": f"Bearer {self.key}"}
        async with connect(
            self.url, additional_headers=headers, max_size=_NEWS_MAX, proxy=None, ssl=self.tls
        ) as socket:
            # Asked once the new connection hears: between the two nothing is lost.
            yield await self.missed(None if since is None else since - LATE_MAX)
            async for text in socket:
                yield _NEWS.validate_json(text)


def _key(event: EventAnswer) -> tuple[object, ...]:
    return event.kind, event.thing, event.at, event.source, event.cause
