"""Who has control of the drone: the lease, who may have it, and what all are told of it."""

from __future__ import annotations

from collections.abc import Callable

from housefly.clock import Clock
from housefly.messages import Severity
from housefly.messages.words import UNSAID, Words, figure
from housefly.web.access.roles import Role
from housefly.web.access.session_auth import SessionAuth
from housefly.web.control.lease import LEASE_TIMEOUT, Lease
from housefly.web.messages.client_messages import LeaseRequest
from housefly.web.messages.server_messages import ViewersMessage, ViewerView, to_text
from housefly.web.status.state_feed import StateFeed
from housefly.web.viewers.viewer import Viewer
from housefly.web.viewers.viewers import Viewers


class ControlLease:
    """The right to fly, of one tab at most.

    Args:
        viewers: who is here.
        feed: whose event log says who took control, and who lost it.
        auth: knows what a session may do.
        clock: of the console.
        is_flying: whether the drone may be off the ground, as far as the console knows.
    """

    def __init__(
        self,
        viewers: Viewers,
        feed: StateFeed,
        auth: SessionAuth,
        clock: Clock,
        is_flying: Callable[[], bool],
    ) -> None:
        self._viewers, self._feed, self._auth, self._clock = viewers, feed, auth, clock
        self._is_flying, self._lease = is_flying, Lease()

    @property
    def holder(self) -> int | None:
        """Number of the tab that has control."""
        return self._lease.holder

    @property
    def holder_name(self) -> str:
        """Name of who has control, or ""."""
        return "" if self.holder is None else self._viewers.name_of(self.holder)

    def objection(self, number: int | None) -> Words:
        """Return why this number may not fly now, in words, or UNSAID."""
        if self.holder is None:
            return Words("nobody has control: take it first")
        if self.holder == number:
            return UNSAID
        return Words("{who} has control", who=self.holder_name)

    def reserve(self, number: int) -> None:
        """Keep control for who had it before a restart of the console."""
        self._lease.reserve(number, self._clock.now())

    def renew(self, viewer: Viewer) -> None:
        """Note a sign of life."""
        self._lease.renew(viewer.number, self._clock.now())

    def numbers_here(self) -> set[int]:
        """Return the numbers of who is here, or may soon be back to its control."""
        here = {one.number for one in self._viewers.present()}
        return here if self.holder is None else {*here, self.holder}

    def give_to_the_first(self, viewer: Viewer) -> None:
        """Give control to who is here alone and may fly, while the drone stands."""
        is_alone = self.holder is None and len(self._viewers.present()) == 1
        if is_alone and viewer.session.role.includes(Role.FLY) and not self._is_flying():
            self._lease.acquire(viewer.number, self._clock.now(), flying=False, held=False)

    def change(self, viewer: Viewer, message: LeaseRequest) -> tuple[Words, Words]:
        """Take, release or hand over control; return the objection, and what was done, in words."""
        now, me, who = self._clock.now(), viewer.number, viewer.name
        if message.action == "take":
            flying = self._is_flying()
            problem = self._lease.acquire(me, now, flying=flying, held=message.held)
            return problem, Words("{who} took control", who=who)
        if message.action == "release":
            return self._lease.release(me), Words("{who} laid down control", who=who)
        if message.to in {other.number for other in self._viewers if self._may_fly(other)}:
            to = self._viewers.name_of(message.to)
            words = Words("{who} handed control to {name}", who=who, name=to)
            return self._lease.hand_over(me, message.to, now), words
        return Words("that viewer is not here any more, or may not fly"), UNSAID

    def expire(self) -> None:
        """Free control when its holder has fallen silent."""
        name = self.holder_name
        if self._lease.expire(self._clock.now()):
            self._lost(
                Words(
                    "{who} was silent for {n} s and lost control: nobody has it now",
                    who=name,
                    n=figure(LEASE_TIMEOUT, ".0f"),
                )
            )

    def take_from_who_may_not_fly(self, viewer: Viewer) -> None:
        """Free control when its holder's session is over, or flies no more."""
        if viewer.present and viewer.number == self.holder and not self._may_fly(viewer):
            self._lease.release(viewer.number)
            self._lost(Words("{who} may not fly any more and lost control", who=viewer.name))

    def broadcast(self) -> None:
        """Send everybody who is here and who has control."""
        people = {viewer.number: viewer.name for viewer in self._viewers.present()}
        here = tuple(ViewerView(number, name) for number, name in sorted(people.items()))
        self._viewers.broadcast("viewers", to_text(ViewersMessage(self.holder, here)))

    def _lost(self, words: Words) -> None:
        self._feed.log_event(Severity.WARNING, "control", words)
        self.broadcast()

    def _may_fly(self, viewer: Viewer) -> bool:
        session = self._auth.renewed(viewer.session) if viewer.present else None
        return session is not None and session.role.includes(Role.FLY)
