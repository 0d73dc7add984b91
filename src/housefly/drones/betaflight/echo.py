"""Whether the channels that a controller flies by are ours: it tells them, and they are compared.

What is set is one thing, what it flies by another: a mask that leaves out a stick, a switch of a
radio, a receiver that stands in. So standing, each channel is moved a little, too little to mean
anything, and must come back. Pure.
"""

from __future__ import annotations

from collections import deque
from math import inf

WIGGLE, WIGGLE_TIME = 12, 0.5
"""How far channels are moved while it stands [us], and for how long each way [s]."""
_WINDOW, _KEPT = 0.35, 3.0
"""What was sent for so long before the question may come back [s], and how long it is kept [s]."""
_SLACK = 4
_AFTER = 4
"""Answers in a row of which each says whether a channel is ours."""
_AGE_MAX = 2.0


class Echo:
    """Compares what was sent with what is flown by.

    Args:
        own: which channels must be ours, in the order of the firmware: roll, pitch, yaw, throttle,
            then switches.
    """

    def __init__(self, own: frozenset[int]) -> None:
        self._own = own
        self._sent: deque[tuple[float, tuple[int, ...]]] = deque()
        self._lacking: deque[frozenset[int]] = deque(maxlen=_AFTER)
        self._asked_at = self._heard_at = -inf

    def moved(self, channels: tuple[int, ...], now: float) -> tuple[int, ...]:
        """Return channels moved a little, one way and the other by turns; now is [s]."""
        by = WIGGLE if int(now / WIGGLE_TIME) % 2 else 0
        return tuple(channel + by for channel in channels)

    def sent(self, channels: tuple[int, ...], now: float) -> None:
        """Note what left [us], in the order of the firmware, at a time [s]."""
        self._sent.append((now, channels))
        while self._sent[0][0] < now - _KEPT:
            self._sent.popleft()

    def asked(self, now: float) -> None:
        """Note that it was asked what it flies by, at a time [s]."""
        self._asked_at = now

    def heard(self, channels: tuple[int, ...], now: float) -> None:
        """Take in what it flies by [us]."""
        if not self._sent:
            return
        self._heard_at = now
        recent = [sent for at, sent in self._sent if at >= self._asked_at - _WINDOW]
        self._lacking.append(
            frozenset(
                number
                for number in self._own
                if number >= len(channels)
                or not any(
                    number < len(sent) and abs(sent[number] - channels[number]) <= _SLACK
                    for sent in recent
                )
            )
        )

    def forget(self) -> None:
        """Forget what was heard: it flew by nobody's sticks, or what stood in for them."""
        self._lacking.clear()

    def lacking(self, now: float) -> frozenset[int] | None:
        """Return the channels that are not ours; None while that is not known now [s]."""
        if len(self._lacking) < _AFTER or now - self._heard_at > _AGE_MAX:
            return None
        return frozenset().union(*self._lacking)

    def is_taken(self) -> bool:
        """Return whether none of the newest answers was of channels that are all ours."""
        return len(self._lacking) == _AFTER and all(self._lacking)
