"""Who is here: the open sockets of one console, with the numbers and names of their tabs."""

from __future__ import annotations

from collections.abc import Iterator

from housefly.messages import OrderAnswer
from housefly.web.messages.server_messages import EventsMessage, OrderRefused
from housefly.web.status.state_feed import StateFeed
from housefly.web.viewers.tab_numbers import TabNumbers
from housefly.web.viewers.viewer import Viewer

_CLOSE_OPENED_ELSEWHERE = 4001
"""WebSocket close code; the client knows it."""


UNNAMED = "a browser"
"""What others see of a session that has no tab here."""


class Viewers:
    """The open sockets, and the tabs that were open before.

    Attributes:
        tabs: numbers and names of the tabs, those that are gone too.
    """

    def __init__(self) -> None:
        self.tabs = TabNumbers()
        self._open: set[Viewer] = set()

    def __iter__(self) -> Iterator[Viewer]:
        return iter(tuple(self._open))

    def add(self, viewer: Viewer) -> None:
        """Take in a socket that was opened; it is nobody before it says hello."""
        self._open.add(viewer)

    def remove(self, viewer: Viewer) -> None:
        """Forget a closed socket."""
        self._open.discard(viewer)

    def present(self) -> list[Viewer]:
        """Return who has said hello."""
        return [one for one in self._open if one.present]

    def close_others_of(self, viewer: Viewer, number: int | None) -> None:
        """Close what else is open with the number of a tab: it was opened twice."""
        for other in self.present():
            if other is not viewer and other.number == number:
                other.number = 0
                other.close(_CLOSE_OPENED_ELSEWHERE, "this console was opened in another tab")

    def broadcast(self, kind: str, text: str) -> None:
        """Send every browser the newest message of a kind; it replaces one that still waits."""
        for viewer in self.present():
            viewer.send_latest(kind, text)

    def send_events(self, feed: StateFeed) -> None:
        """Send every browser the lines of the event log that it does not have yet."""
        for viewer in self.present():
            if events := feed.events_after(viewer.event):
                viewer.event = events[-1].number
                viewer.send(EventsMessage(events))

    def send_refusals(self, answers: tuple[OrderAnswer, ...]) -> None:
        """Tell each page which of its orders the pilot refused."""
        for viewer in self.present() if answers else ():
            for answer in answers:
                if (kind := viewer.orders.pop(answer.order_id, None)) is not None:
                    viewer.send(OrderRefused(kind, answer.reason))

    def name_of(self, number: int | None) -> str:
        """Return the name that others see for a number, of who is gone too."""
        here = (one.name for one in self._open if one.number == number)
        return next(here, "") or self.tabs.name_of(number) or f"Viewer {number}"

    def name_of_owner(self, owner: str) -> str:
        """Return the name that others see for an owner of a session, of any of its tabs."""
        names = (one.name for one in self.present() if one.session.owner == owner)
        return next(names, UNNAMED)

    def name_of_tab(self, owner: str, tab: str) -> str:
        """Return the name that others see for a tab of a session's owner."""
        return self.name_of(self.tabs.number_of(owner, tab))
