"""The room's memory, asked by whatever answers for it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from housefly.hub.api.questions import Question
from housefly.hub.client.room_queries import RoomQueries


class AskedRoom(RoomQueries):
    """A room behind a function.

    Args:
        ask: returns the answer; raises ThingError, or LinkError when nobody remembers.
    """

    def __init__(self, ask: Callable[[Question], Any]) -> None:
        self._ask = ask

    def ask(self, question: Question) -> Any:
        """Return the answer to a question."""
        return self._ask(question)
