"""A connection to a room's HTTP API, from this or another machine."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import asdict
from http.client import HTTPConnection, HTTPException, HTTPSConnection
from urllib.parse import quote, urlencode, urlsplit

from pydantic import TypeAdapter, ValidationError
from websockets.exceptions import WebSocketException
from websockets.sync.client import connect

from housefly.errors import LinkError, WireError
from housefly.hub.api.answers import News
from housefly.hub.api.endpoints import API_PREFIX, ENDPOINTS
from housefly.hub.api.questions import Question

_PATHS = {endpoint.question: endpoint.path for endpoint in ENDPOINTS}
_NEWS: TypeAdapter[News] = TypeAdapter(News)


class HttpRoom:
    """Connects on the first question; not thread-safe.

    Args:
        address: of the console, for example http://127.0.0.1:8080.
        key: bearer token of the run.
        timeout: of one question [s].
    """

    def __init__(self, address: str, key: str, timeout: float) -> None:
        parts = urlsplit(address)
        is_secure = parts.scheme == "https"
        kind = HTTPSConnection if is_secure else HTTPConnection
        self._connection = kind(parts.hostname or "127.0.0.1", parts.port, timeout=timeout)
        self._watch_url = f"{'wss' if is_secure else 'ws'}://{parts.netloc}{API_PREFIX}/watch"
        self._headers = {"Authorization": f"Bearer {key}"}

    def ask(self, question: Question) -> str:
        """Return the answer or the refusal as JSON; raises LinkError if nobody answers."""
        status, text = self._get(room_path(question))
        return checked_answer(status, text)

    def watch(self) -> Iterator[News]:
        """Yield changes as they happen; raises LinkError if the room goes away."""
        try:
            with connect(self._watch_url, additional_headers=self._headers) as socket:
                for text in socket:
                    yield _NEWS.validate_json(text)
        except (OSError, WebSocketException) as error:
            raise LinkError(f"the room went away: {error}") from error
        except ValidationError as error:
            raise WireError(f"these are no news: {error.errors()[0]['msg']}") from error

    def close(self) -> None:
        """Close the connection."""
        self._connection.close()

    def _get(self, path: str) -> tuple[int, str]:
        for last_try in (False, True):
            try:
                self._connection.request("GET", path, headers=self._headers)
                answer = self._connection.getresponse()
                return answer.status, answer.read().decode()
            except (OSError, HTTPException) as error:
                # An idle connection may have been cut: try once more on a new one.
                self._connection.close()
                if last_try:
                    raise LinkError(f"the room does not answer: {error}") from error
        raise AssertionError


def checked_answer(status: int, text: str) -> str:
    """Return an HTTP answer's JSON, as the bus would give it.

    Raises:
        LinkError: who answers does not let us ask, or is not Housefly.
    """
    if status not in (401, 404, 503):
        return text
    try:
        refusal = {"error": str(json.loads(text)["error"])}
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        raise LinkError(f"what answers is not the room: status {status}") from error
    if status == 404:
        return json.dumps(refusal | {"unknown": True})
    raise LinkError(refusal["error"])


def room_path(question: Question) -> str:
    """Return the path and the query that ask a question."""
    given = {
        name: value
        for name, value in asdict(question).items()
        if name != "ask" and value not in (None, "")
    }
    path = _PATHS[type(question)]
    if "{thing}" in path:
        path = path.replace("{thing}", quote(str(given.pop("thing")), safe=""))
    return f"{API_PREFIX}{path}?{urlencode(given)}"
