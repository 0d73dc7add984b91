"""The console's heart: viewers, who has control, and what each message of a browser does."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable, Coroutine
from typing import Any

from pydantic import ValidationError

from housefly.clock import Clock
from housefly.errors import HouseflyError
from housefly.hub.api.queries import PlanRequest, RoomView
from housefly.messages import OrderKind, Severity
from housefly.web.lease import Lease
from housefly.web.news import PilotNews, on_the_ground
from housefly.web.orders import FOR_EVERYONE, in_words, objection, order_of
from housefly.web.pilot_link import PilotLink
from housefly.web.security import Doorkeeper
from housefly.web.viewer import Viewer
from housefly.web.vocabulary import (
    CLIENT_MESSAGE,
    Accepted,
    EventNews,
    Hello,
    InviteNews,
    InviteRequest,
    LeaseRequest,
    OrderRequest,
    Ping,
    PlanNews,
    PlanQuestion,
    Pong,
    Refused,
    RoomNews,
    StopRequest,
    ViewersNews,
    ViewerView,
    Welcome,
    to_text,
)

log = logging.getLogger(__name__)

VIEWERS_MAX = 32
OVER_MAX = 200
"""A socket that sends this many commands in a row above the limit is closed."""
PILOT_SILENT = 2.0
"""Orders that move the drone are refused when the pilot was not heard for this long [s]."""
STOP_QUIET = 0.5
"""STOPs closer together than this are one line of the log [s]."""
OPENED_ELSEWHERE = 4001


class Console:
    """All open browsers of one drone; everything happens on one asyncio loop."""

    def __init__(
        self, news: PilotNews, link: PilotLink, doorkeeper: Doorkeeper, clock: Clock
    ) -> None:
        self.news, self.link, self.lease = news, link, Lease()
        self.room: RoomView | None = None
        self.viewers: set[Viewer] = set()
        self._doorkeeper, self._clock = doorkeeper, clock
        self._stopped_at = float("-inf")
        self._numbers: dict[str, int] = {}
        self._tasks: set[asyncio.Task[None]] = set()
        self._handlers: dict[type, Callable[[Viewer, Any], None]] = {
            Hello: self._hello,
            Ping: self._ping,
            StopRequest: self._stop,
            OrderRequest: self._order,
            PlanQuestion: self._plan,
            LeaseRequest: self._lease,
            InviteRequest: self._invite,
        }

    # --- sockets
    # ------------------------------------------------------------------------------------

    def enter(self, viewer: Viewer) -> bool:
        """Let a new socket in; False when the house is full."""
        if len(self.viewers) >= VIEWERS_MAX:
            return False
        self.viewers.add(viewer)
        return True

    def leave(self, viewer: Viewer) -> None:
        """Forget a closed socket; control is kept for its tab until the lease runs out."""
        self.viewers.discard(viewer)
        self.show_viewers()

    def heard(self, viewer: Viewer, text: str) -> None:
        """Do what a browser's message asks, or tell the browser why not."""
        try:
            message = CLIENT_MESSAGE.validate_json(text)
        except ValidationError as error:
            first = error.errors()[0]
            key = ".".join(str(part) for part in first["loc"]) or "message"
            viewer.send(Refused(0, f"{key}: {first['msg'][0].lower()}{first['msg'][1:]}"))
            self._count(viewer)
            return
        self.lease.heard(viewer.number, self._clock.now())
        if _is_free(message) or self._count(viewer):
            self._handlers[type(message)](viewer, message)

    def show(self, kind: str, text: str) -> None:
        """Show every browser the newest message of a kind."""
        for viewer in self.viewers:
            if viewer.present:
                viewer.show(kind, text)

    def show_viewers(self) -> None:
        """Tell everybody who is here and who has control."""
        people = {viewer.number: viewer.name for viewer in self.viewers if viewer.present}
        here = tuple(ViewerView(number, name) for number, name in sorted(people.items()))
        self.show("viewers", to_text(ViewersNews(self.lease.holder, here)))

    def send_events(self) -> None:
        """Send every browser the lines of the event log that it has not seen."""
        for viewer in self.viewers:
            if viewer.present and (events := self.news.events_after(viewer.event)):
                viewer.event = events[-1].number
                viewer.send(EventNews(events))

    def check_lease(self) -> None:
        """Free control when its holder has gone silent."""
        holder = self.lease.holder
        if self.lease.expired(self._clock.now()):
            self.news.note(
                Severity.WARNING,
                "control",
                f"{self._name(holder)} lost contact and with it control",
            )
            self.show_viewers()

    def name_at(self, tab: str) -> str:
        """Return the name of who sits before a tab."""
        return self._name(self._numbers.get(tab))

    def objection_at(self, tab: str) -> str:
        """Return why this tab may not change the room now, or "": as with orders, it needs control."""
        return self._no_control(self._numbers.get(tab))

    def told(self, words: str) -> None:
        """Put a line into everybody's log."""
        log.info("%s", words)
        self.news.note(Severity.INFO, "room", words)

    # --- messages
    # -----------------------------------------------------------------------------------

    def _count(self, viewer: Viewer) -> bool:
        if viewer.bucket.spend(self._clock.now()):
            return True
        if viewer.bucket.over > OVER_MAX:
            viewer.close(1008, "too many commands")
        elif viewer.bucket.over == 1:
            viewer.send(Refused(0, "too many commands at once: wait a moment"))
        return False

    def _hello(self, viewer: Viewer, message: Hello) -> None:
        for other in self.viewers:
            if (
                other is not viewer
                and other.present
                and other.number == self._numbers.get(message.tab)
            ):
                other.number = 0
                other.close(OPENED_ELSEWHERE, "this console was opened in another tab")
        viewer.number = self._numbers.setdefault(message.tab, len(self._numbers) + 1)
        viewer.name = message.name or f"Viewer {viewer.number}"
        events = self.news.events_after(0)
        viewer.event = events[-1].number if events else 0
        viewer.send(Welcome(viewer.number, self._clock.now(), events, self.news.trail()))
        if self.room is not None:
            viewer.send(RoomNews(self.room))
        viewer.show("path", to_text(self.news.path()))
        if (link := self.news.link()) is not None:
            viewer.show("link", to_text(link))
        if self.lease.holder is None and sum(other.present for other in self.viewers) == 1:
            self.lease.take(viewer.number, self._clock.now(), flying=False, held=False)
        self.show_viewers()

    def _ping(self, viewer: Viewer, message: Ping) -> None:
        viewer.send(Pong(message.sent, self._clock.now()))

    def _stop(self, viewer: Viewer, message: StopRequest) -> None:
        self.stop(viewer.name)
        viewer.send(Accepted(message.id))

    def stop(self, sender: str) -> None:
        """STOP, from whoever asks; a key held down makes one line of the log, not hundreds."""
        self.link.stop(sender)
        now = self._clock.now()
        if now - self._stopped_at > STOP_QUIET:
            self._audit(sender, "STOP")
        self._stopped_at = now

    def _order(self, viewer: Viewer, message: OrderRequest) -> None:
        if message.order is OrderKind.STOP:
            self._stop(viewer, StopRequest("stop", message.id))
        elif reason := self._order_objection(viewer, message):
            viewer.send(Refused(message.id, reason))
        else:
            self._audit(viewer.name, in_words(message))
            sent = self.link.send(order_of(message, viewer.name, self._clock.now()))
            self._start(self._confirm(viewer, message.id, sent))

    def _order_objection(self, viewer: Viewer, message: OrderRequest) -> str:
        if message.order in FOR_EVERYONE:
            return objection(message, self.room)
        if problem := self._no_control(viewer.number):
            return problem
        if self.news.age > PILOT_SILENT and message.order is not OrderKind.CUT:
            return "no contact with the pilot"
        return objection(message, self.room)

    def _no_control(self, number: int | None) -> str:
        """Return who else has control, in words, or ""."""
        holder = self.lease.holder
        if holder is None:
            return "nobody has control: take it first"
        return "" if holder == number else f"{self._name(holder)} has control"

    async def _confirm(self, viewer: Viewer, number: int, sent: asyncio.Future[str]) -> None:
        problem = await sent
        viewer.send(Refused(number, problem) if problem else Accepted(number))

    def _plan(self, viewer: Viewer, message: PlanQuestion) -> None:
        viewer.question = message
        if not viewer.asking:
            viewer.asking = True
            self._start(self._answer_plans(viewer))

    async def _answer_plans(self, viewer: Viewer) -> None:
        """Answer the newest question; those that came while another was being answered are out of
        date.
        """
        while (question := viewer.question) is not None:
            viewer.question = None
            try:
                answer = await self.link.plan(PlanRequest(question.place, question.goal))
            except HouseflyError as error:
                viewer.send(Refused(question.id, f"no path could be asked for: {error}"))
            else:
                viewer.send(PlanNews(question.id, answer))
        viewer.asking = False

    def _lease(self, viewer: Viewer, message: LeaseRequest) -> None:
        now, me = self._clock.now(), viewer.number
        if message.action == "take":
            problem = self.lease.take(me, now, flying=self.flying, held=message.held)
            words = "took control"
        elif message.action == "release":
            problem, words = self.lease.release(me), "laid down control"
        elif message.to in {other.number for other in self.viewers if other.present}:
            problem, words = (
                self.lease.give(me, message.to, now),
                f"handed control to {self._name(message.to)}",
            )
        else:
            problem, words = "that viewer is not here any more", ""
        if problem:
            viewer.send(Refused(message.id, problem))
            return
        self.news.note(Severity.INFO, "control", f"{viewer.name} {words}")
        viewer.send(Accepted(message.id))
        self.show_viewers()

    def _invite(self, viewer: Viewer, message: InviteRequest) -> None:
        viewer.send(InviteNews(message.id, f"/?token={self._doorkeeper.invite()}"))

    # --- helpers
    # ------------------------------------------------------------------------------------

    @property
    def flying(self) -> bool:
        """Whether the drone is off the ground, as far as the console knows."""
        return not on_the_ground(self.news.step)

    def _name(self, number: int | None) -> str:
        for viewer in self.viewers:
            if viewer.number == number:
                return viewer.name
        return f"Viewer {number}"

    def _audit(self, sender: str, words: str) -> None:
        """Keep who asked for what; the pilot writes it into the event log itself, unless it cannot
        be heard.
        """
        log.info("%s: %s", sender, words)
        if self.news.age > PILOT_SILENT:
            self.news.note(
                Severity.WARNING, "order", f"{sender}: {words}, but the pilot is not heard"
            )

    def _start(self, work: Coroutine[Any, Any, None]) -> None:
        task = asyncio.create_task(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)


def _is_free(message: Any) -> bool:
    """STOP and LAND pass the limit on commands."""
    return isinstance(message, StopRequest) or (
        isinstance(message, OrderRequest) and message.order in FOR_EVERYONE
    )
