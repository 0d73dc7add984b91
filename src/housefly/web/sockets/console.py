"""What each message of a browser does, and what all the browsers of one drone are told."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable, Coroutine
from dataclasses import replace
from typing import Any

from pydantic import ValidationError

from housefly.clock import Clock
from housefly.config.pydantic_words import words_of
from housefly.config.validation import dotted
from housefly.errors import MissingPartError
from housefly.hub.api.pilot_queries import PreflightView, RoomView
from housefly.messages import Order, OrderKind, Severity
from housefly.messages.words import UNSAID, Words, figure, literal
from housefly.tasks.api.values import TaskStage
from housefly.web.access.audit_log import AuditLog
from housefly.web.access.refusal_log import RefusalLog
from housefly.web.access.roles import Role, role_for_message, role_objection
from housefly.web.access.session_auth import SessionAuth
from housefly.web.access.session_watch import CLOSE_SESSION_OVER
from housefly.web.control.control_lease import ControlLease
from housefly.web.control.orders import (
    LATE_MAX,
    NEW_TIME,
    ORDER_WORDS,
    ORDERS_WITHOUT_CONTROL,
    nudge_order,
    order_in_words,
    order_objection,
    to_order,
)
from housefly.web.control.pilot_link import PilotLink
from housefly.web.control.plan_answers import answer_plans
from housefly.web.control.stop_button import StopButton
from housefly.web.http.seats import Seats
from housefly.web.messages.client_messages import (
    CLIENT_MESSAGE,
    Hello,
    InviteRequest,
    LeaseRequest,
    NudgeRequest,
    OrderRequest,
    PingRequest,
    PlanQuestion,
    StopRequest,
)
from housefly.web.messages.server_messages import (
    AcceptedReply,
    PongReply,
    PreflightMessage,
    RefusedReply,
    RoomMessage,
    Welcome,
    to_text,
)
from housefly.web.messages.verdict_message import ConsoleVerdict
from housefly.web.status.console_knowledge import PILOT_TIMEOUT, ConsoleKnowledge
from housefly.web.status.console_memory import ConsoleMemory, KeptConsole, KeptControl
from housefly.web.status.goal_words import subject_of_task, task_of_drone
from housefly.web.status.missed_events import missed_events
from housefly.web.status.order_objections import order_objection_now
from housefly.web.status.state_feed import StateFeed
from housefly.web.status.stop_latch import StopLatch
from housefly.web.status.task_feed import TaskFeed
from housefly.web.status.verdict import console_verdict
from housefly.web.viewers.guest_links import GuestLinks
from housefly.web.viewers.tab_numbers import TabNumbers
from housefly.web.viewers.viewer import Viewer
from housefly.web.viewers.viewers import Viewers

_LOG = logging.getLogger(__name__)

_MISSED_MAX = 600.0
"""Where an earlier console had kept no line, so far back is looked for what was missed [s]."""
_MAX_REFUSALS = 200
"""A socket that sends this many commands in a row above the rate limit is closed."""


class Console:
    """All open browsers of one drone; everything happens on one asyncio loop.

    Attributes:
        stop_all: sends STOP to all drones of the room.
        missed_since: when an earlier console of this run kept its last line, on the console's
            clock [s]; None where there was none, or what was missed is in the log.
    """

    def __init__(
        self,
        feed: StateFeed,
        link: PilotLink,
        auth: SessionAuth,
        clock: Clock,
        audit: AuditLog | None = None,
        tasks: TaskFeed | None = None,
        memory: ConsoleMemory | None = None,
        guest_address: str = "",
        name: str = "",
        simulated: bool = False,
    ) -> None:
        self._name, self._simulated, self.stop_all = name, simulated, self.stop
        self.feed, self.link, self.tasks = feed, link, tasks
        self.room: RoomView | None = None
        self.preflight = PreflightView()
        self.viewers = Viewers()
        self.control = ControlLease(self.viewers, feed, auth, clock, lambda: self.flying)
        self.seats = Seats()
        self._auth, self._clock, self._audit_log = auth, clock, audit
        self.refusals = RefusalLog(self._record, clock)
        self._stop_button = StopButton(feed, link, clock)
        self._memory, self._kept, self._newest_kept = memory, KeptControl(), 0
        self.missed_since: float | None = None
        if memory is not None:
            self._restore(memory.read(clock.now()))
        self._links = GuestLinks(
            auth,
            guest_address,
            lambda words: feed.log_event(Severity.INFO, "control", words),
            lambda words: self._record("", "", words),
        )
        self._tasks: set[asyncio.Task[None]] = set()
        self._handlers: dict[type, Callable[[Viewer, Any], None]] = {
            Hello: self._hello,
            PingRequest: self._ping,
            StopRequest: self._stop,
            OrderRequest: self._order,
            NudgeRequest: self._nudge,
            PlanQuestion: self._plan,
            LeaseRequest: self._lease,
            InviteRequest: self._invite,
        }

    # --- sockets

    def remove_viewer(self, viewer: Viewer) -> None:
        """Forget a closed socket; its tab keeps control until the lease expires."""
        self.viewers.remove(viewer)
        self.control.broadcast()

    def receive(self, viewer: Viewer, text: str) -> None:
        """Do what a browser's message asks, or answer why not."""
        if viewer.limiter.is_empty(self._clock.now()) and not _may_be_unlimited(text):
            self._within_rate(viewer)
            return
        try:
            message = CLIENT_MESSAGE.validate_json(text)
        except ValidationError as error:
            first = error.errors()[0]
            key = dotted(first["loc"]) or "message"
            reason = literal(f"{key}: {words_of(first)}")
            self._refuse(viewer, "a message that cannot be read", reason)
            self._within_rate(viewer)
            return
        if objection := self._objection(viewer, message):
            number = getattr(message, "id", 0)
            self._refuse(viewer, f"{message.type} refused", objection, number)
            self._within_rate(viewer)
            return
        self.control.renew(viewer)
        if _is_unlimited(message) or self._within_rate(viewer):
            self._handlers[type(message)](viewer, message)

    def keep_stop(self) -> None:
        """Send a STOP that holds again until the pilot has taken it: a new one knows nothing."""
        if self.pilot_is_heard:
            self._stop_button.send_again()

    def keep_control(self) -> None:
        """Keep, over a restart, who has control, who is known, and whether STOP holds."""
        stop, newest = self.feed.stop, self.viewers.tabs.newest
        kept = KeptControl(self.control.holder, self._kept.tabs, stop.holds, stop.by)
        if self._memory is None or (kept == self._kept and newest == self._newest_kept):
            return
        self._kept, self._newest_kept = replace(kept, tabs=self.viewers.tabs.kept()), newest
        self._memory.keep_control(self._kept)

    def verdict(self) -> ConsoleVerdict:
        """Return what is to be said of the drone now."""
        known = self._knowledge()
        stop = self.feed.stop.view(
            known.now, airborne=known.may_be_airborne, pilot_is_heard=known.pilot_is_heard
        )
        return console_verdict(replace(known, stop=stop))

    def _knowledge(self) -> ConsoleKnowledge:
        """Return what is known now, but for the STOP that holds."""
        now, task = self._clock.now(), None
        told = self.tasks.message() if self.tasks is not None else None
        board = told.board if told is not None and told.running else None
        if board is not None:
            task = task_of_drone(board, self.feed.drone.name)
        return ConsoleKnowledge(
            now=now,
            step=self.feed.step,
            step_age=self.feed.age,
            link=link.link if (link := self.feed.link()) else None,
            preflight=self.preflight,
            room=self.room,
            pilot=self.control.holder,
            control=self.control.holder_name,
            task_subject=subject_of_task(task, self.room.places) if self.room else "",
            task_look=task.look if task is not None else None,
            task_is_paused=task is not None and task.state is TaskStage.PAUSED,
            unix=board.at + now - told.heard_at if board is not None and told is not None else 0.0,
            hand_motion=self.feed.hand_motion,
            told_last=self.feed.last_status,
            has_drone=self.feed.drone.enabled,
        )

    async def learn_missed(self, unix: float) -> None:
        """Add to the log what the pilot said while no console listened; raises HouseflyError.

        Args:
            unix: now, as Unix time [s].
        """
        if self.missed_since is None:
            return
        offset, feed = unix - self._clock.now(), self.feed
        told = await self.link.happened(feed.drone_body, self.missed_since + offset)
        self.missed_since = None
        feed.recall(missed_events(told, feed.events_after(0), offset))

    def check_sessions(self) -> None:
        """Close the sockets of sessions that are over; free control of who may no longer fly."""
        for viewer in self.viewers:
            if self._auth.renewed(viewer.session) is None:
                viewer.close(CLOSE_SESSION_OVER, "this session is over")
            self.control.take_from_who_may_not_fly(viewer)

    def name_of_tab(self, owner: str, tab: str) -> str:
        """Return the name that others see for a tab of a session's owner."""
        return self.viewers.name_of_tab(owner, tab)

    def control_objection(self, owner: str, tab: str) -> Words:
        """Return why this tab of a session's owner does not have control, in words, or UNSAID."""
        return self.control.objection(self.viewers.tabs.number_of(owner, tab))

    def announce(self, words: Words) -> None:
        """Put a line into everybody's event log."""
        _LOG.info("%s", words)
        self._record("", "", words)
        self.feed.log_event(Severity.INFO, "room", words)

    # --- messages

    def _objection(self, viewer: Viewer, message: Any) -> Words:
        """Return why a viewer may not say this at all, in words, or UNSAID."""
        # Who is nobody yet would share number 0, and control with it, with all others.
        if not (viewer.present or isinstance(message, Hello) or _is_unlimited(message)):
            return Words("say hello first")
        return self._role_objection(viewer, message)

    def _role_objection(self, viewer: Viewer, message: Any) -> Words:
        """Return why a viewer's role is not enough, or UNSAID; STOP and LAND look nowhere."""
        needed = role_for_message(message)
        if needed is Role.WATCH:
            return UNSAID
        session = self._auth.renewed(viewer.session)
        if session is None:
            return Words("this session is over")
        return role_objection(session.role, needed)

    def _within_rate(self, viewer: Viewer) -> bool:
        if viewer.limiter.spend(self._clock.now()):
            return True
        self.refusals.flooded(viewer.name, viewer.session.name)
        if viewer.limiter.refused > _MAX_REFUSALS:
            viewer.close(1008, "too many commands")
        elif viewer.limiter.refused == 1:
            viewer.send(RefusedReply(0, Words("too many commands at once: wait a moment")))
        return False

    def _hello(self, viewer: Viewer, message: Hello) -> None:
        owner = viewer.session.owner  # a tab is nobody else's, even if it has the same name
        tabs = self.viewers.tabs
        number = tabs.number_of(owner, message.tab)
        if viewer.present and number != viewer.number:
            reason = Words("another tab says hello on a socket of its own")
            self._refuse(viewer, "hello refused", reason)
            return
        self.viewers.close_others_of(viewer, number)
        viewer.number = tabs.number_for(owner, message.tab, self.control.numbers_here())
        viewer.name = viewer.session.user or message.name or f"Viewer {viewer.number}"
        tabs.rename(owner, message.tab, viewer.name)
        self._welcome(viewer)
        # Whoever comes back has watched or lost control before: taking it is then an act.
        if number is None:
            self.control.give_to_the_first(viewer)
        self.control.renew(viewer)
        self.control.broadcast()

    def _welcome(self, viewer: Viewer) -> None:
        """Send all that is known."""
        events = self.feed.events_after(0)
        viewer.event = events[-1].number if events else 0
        role = viewer.session.role
        now, trail = self._clock.now(), self.feed.trail()
        viewer.send(Welcome(viewer.number, role, now, events, trail, self._simulated))
        if self.room is not None:
            viewer.send(RoomMessage(self.room))
        viewer.send_latest("preflight", to_text(PreflightMessage(self.preflight)))
        if self.tasks is not None:
            viewer.send_latest("tasks", to_text(self.tasks.message()))
        viewer.send_latest("path", to_text(self.feed.path()))
        viewer.send_latest("verdict", to_text(self.verdict()))
        if (link := self.feed.link()) is not None:
            viewer.send_latest("link", to_text(link))

    def _ping(self, viewer: Viewer, message: PingRequest) -> None:
        now = self._clock.now()
        viewer.delay.learn(message.sent, now)
        viewer.send(PongReply(message.sent, now))

    def _stop(self, viewer: Viewer, message: StopRequest) -> None:
        self.stop_all(viewer.name, viewer.session.name)
        viewer.send(AcceptedReply(message.id))

    def stop(self, sender: str, session: str = "") -> None:
        """Send STOP."""
        if self._stop_button.press(sender):
            self._audit(sender, "STOP", session)

    def order_calmly(self, kind: OrderKind, sender: str, session: str = "") -> None:
        """Give an order that needs no control."""
        request = OrderRequest("order", 0, kind)
        self._audit(sender, order_in_words(request), session)
        self.link.send(to_order(request, sender, self._clock.now()))

    def _order(self, viewer: Viewer, message: OrderRequest) -> None:
        if message.order is OrderKind.STOP:
            self._stop(viewer, StopRequest("stop", message.id))
        elif reason := self._order_objection(viewer, message):
            self._refuse(viewer, f"{message.order.value} refused", reason, message.id)
        else:
            self._audit(viewer.name, order_in_words(message), viewer.session.name)
            self._pass_on(viewer, message, to_order(message, viewer.name, self._clock.now()))

    def _nudge(self, viewer: Viewer, message: NudgeRequest) -> None:
        """Pass a nudge on; many of them in a row are one line in the log."""
        now = self._clock.now()
        late = viewer.delay.lateness(message.sent, now)
        reason = self.control.objection(viewer.number) or order_objection_now(
            OrderKind.NUDGE, self.verdict()
        )
        if not reason and late > LATE_MAX:
            reason = Words("the line is slow: this came {n} s late", n=figure(late, ".1f"))
        if reason:
            self._refuse(viewer, f"{ORDER_WORDS[OrderKind.NUDGE]} refused", reason, message.id)
            return
        if now - viewer.nudged_at > NEW_TIME:
            self._audit(viewer.name, ORDER_WORDS[OrderKind.NUDGE], viewer.session.name)
        viewer.nudged_at = now
        self._pass_on(viewer, message, nudge_order(message, viewer.name, now - late))

    def _pass_on(self, viewer: Viewer, message: OrderRequest | NudgeRequest, order: Order) -> None:
        viewer.gave(order)
        self._start(self._confirm(viewer, message, self.link.send(order)))

    def _order_objection(self, viewer: Viewer, message: OrderRequest) -> Words:
        if message.order in ORDERS_WITHOUT_CONTROL:
            return order_objection(message, self.room)
        if problem := self.control.objection(viewer.number):
            return problem
        if not self.pilot_is_heard and message.order is not OrderKind.CUT:
            return Words("no contact with the pilot")
        return order_objection(message, self.room)

    async def _confirm(
        self, viewer: Viewer, asked: OrderRequest | NudgeRequest, sent: asyncio.Future[str]
    ) -> None:
        if problem := await sent:
            self._refuse(viewer, f"{asked.type} was not passed on", literal(problem), asked.id)
        else:
            viewer.send(AcceptedReply(asked.id))

    def _plan(self, viewer: Viewer, message: PlanQuestion) -> None:
        viewer.question = message
        self._start(answer_plans(viewer, self.link))

    def _lease(self, viewer: Viewer, message: LeaseRequest) -> None:
        problem, words = self.control.change(viewer, message)
        if problem:
            self._refuse(viewer, f"{message.action} control refused", problem, message.id)
            return
        self._record(viewer.name, viewer.session.name, words)
        self.feed.log_event(Severity.INFO, "control", words)
        viewer.send(AcceptedReply(message.id))
        self.control.broadcast()

    def _invite(self, viewer: Viewer, message: InviteRequest) -> None:
        self._record(viewer.name, viewer.session.name, f"made a one-time link: {message.role}")
        try:
            viewer.send(self._links.make(viewer, message))
        except MissingPartError as error:
            self._refuse(viewer, f"{message.type} refused", literal(str(error)), message.id)

    # --- helpers

    def _restore(self, kept: KeptConsole) -> None:
        control, now = kept.control, self._clock.now()
        self.viewers.tabs = TabNumbers(control.tabs)
        latch = StopLatch(control.stop_holds, control.stop_by, sent_at=now)
        self.feed.restore(kept.events, latch)
        if control.holder is not None:
            self.control.reserve(control.holder)
        if not kept.is_new:
            text = Words("the console was started again")
            self.feed.log_event(Severity.INFO, "console", text)
            self.missed_since = kept.events[-1].at if kept.events else now - _MISSED_MAX

    @property
    def pilot_is_heard(self) -> bool:
        """Whether what is known of the pilot is of now."""
        return self.feed.age <= PILOT_TIMEOUT

    @property
    def flying(self) -> bool:
        """Whether the drone may be off the ground, as far as the console knows."""
        return self._knowledge().may_be_airborne

    def _audit(self, sender: str, words: str, session: str) -> None:
        """Log who asked for what; the pilot adds it to the event log unless it is silent."""
        _LOG.info("%s: %s", sender, words)
        self._record(sender, session, words)
        if not self.pilot_is_heard:
            text = Words("{who}: {what}, but the pilot is not heard", who=sender, what=words)
            self.feed.log_event(Severity.WARNING, "order", text)

    def _record(self, who: str, session: str, what: str) -> None:
        if self._audit_log is not None:
            self._audit_log.record(who, session, f"{self._name}: {what}" if self._name else what)

    def _refuse(self, viewer: Viewer, what: str, reason: Words, number: int = 0) -> None:
        """Write down that a message was refused, and answer why; 0 where its number is unknown."""
        self.refusals.refused(viewer.name, viewer.session.name, f"{what}: {reason}")
        viewer.send(RefusedReply(number, reason))

    def _start(self, work: Coroutine[Any, Any, None]) -> None:
        task = asyncio.create_task(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)


def _may_be_unlimited(text: str) -> bool:
    """Return whether a message is worth reading although its sender sent too much."""
    return '"stop"' in text or '"land"' in text


def _is_unlimited(message: Any) -> bool:
    """Return whether a message passes the rate limit: STOP and LAND do."""
    return isinstance(message, StopRequest) or (
        isinstance(message, OrderRequest) and message.order in ORDERS_WITHOUT_CONTROL
    )
