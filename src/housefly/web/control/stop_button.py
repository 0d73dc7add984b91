"""STOP on its way to the pilot: it holds at the console until the pilot has taken it."""

from __future__ import annotations

from concurrent.futures import Future

from housefly.clock import Clock
from housefly.web.control.pilot_link import PilotLink
from housefly.web.status.state_feed import StateFeed

_LOG_PERIOD = 0.5
"""STOPs closer together than this make one line of the log [s]."""


class StopButton:
    """Sends STOP, and again to a pilot that was started anew: it knows nothing of it."""

    def __init__(self, feed: StateFeed, link: PilotLink, clock: Clock) -> None:
        self._feed, self._link, self._clock = feed, link, clock
        self._pressed_at = float("-inf")

    def press(self, sender: str) -> bool:
        """Send STOP; return whether it is worth a line: a key held down makes one."""
        now = self._clock.now()
        self._feed.change_stop(lambda one: one.pressed(sender, now))
        self._send(sender)
        is_new = now - self._pressed_at > _LOG_PERIOD
        self._pressed_at = now
        return is_new

    def send_again(self) -> None:
        """Send a STOP that holds once more, when it is time."""
        now, latch = self._clock.now(), self._feed.stop
        if latch.must_send(now):
            self._feed.change_stop(lambda one: one.sent_again(now))
            self._send(latch.by)

    def _send(self, sender: str) -> None:
        sent = self._link.stop(sender)
        if isinstance(sent, Future):
            sent.add_done_callback(self._answered)

    def _answered(self, sent: Future[bool]) -> None:
        """Note whether the pilot acknowledged STOP; called on any thread."""
        if not sent.cancelled() and sent.exception() is None and sent.result():
            self._feed.change_stop(lambda one: one.acknowledged())
