"""Whether the channels that a controller flies by are ours: it tells them, and they are compared.

What is set is one thing, what it flies by another: a mask that leaves out a stick, a switch of a
radio, a receiver that stands in. So standing, each channel is moved a little, too little to mean
anything, and must follow: what lies still where ours lies by chance is not ours. Pure.
"""

from __future__ import annotations

from collections import deque
from math import inf
from typing import NamedTuple

WIGGLE, WIGGLE_TIME = 12, 0.5
"""How far channels are moved while it stands [us], and for how long each way [s]."""
_WINDOW, _KEPT = 1.5, 5.0
"""What was sent for so long before the question may come back [s], and how long it is kept [s]: a
machine that is busy hands on late, and what lies still does not follow anyhow.
"""
_SLACK = 4
_AFTER, _TAKEN_AFTER, _OFTEN = 8, 4, 3
"""Answers that are looked at while it stands, and in the air; and how many must differ."""
_AGE_MAX = 3.0


class _Answer(NamedTuple):
    channels: tuple[int, ...]
    lacking: frozenset[int]


class Echo:
    """Compares what was sent with what is flown by.

    Args:
        own: which channels must be ours, in the order of the firmware: roll, pitch, yaw, throttle,
            then switches.
    """

    def __init__(self, own: frozenset[int]) -> None:
        self._own = own
        self._sent: deque[tuple[float, tuple[int, ...]]] = deque()
        self._answers: deque[_Answer] = deque(maxlen=_AFTER)
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
        lacking = frozenset(one for one in self._own if not _is_among(one, channels, recent))
        self._answers.append(_Answer(channels, lacking))

    def begin_anew(self) -> None:
        """Look again from now on: in the air channels are not moved to and fro."""
        self._answers.clear()

    def lacking(self, now: float) -> frozenset[int] | None:
        """Return the channels that are not ours, of one that stands; None while nobody knows.

        Args:
            now: [s].
        """
        if len(self._answers) < _AFTER or now - self._heard_at > _AGE_MAX:
            return None
        return frozenset(
            one for one in self._own if self._often_differs(one) or not self._follows(one)
        )

    def is_taken(self) -> bool:
        """Return whether none of the newest answers was of channels that are all ours."""
        newest = tuple(self._answers)[-_TAKEN_AFTER:]
        return len(newest) == _TAKEN_AFTER and all(one.lacking for one in newest)

    def _often_differs(self, channel: int) -> bool:
        return sum(channel in one.lacking for one in self._answers) >= _OFTEN

    def _follows(self, channel: int) -> bool:
        positions = [one.channels[channel] for one in self._answers if channel < len(one.channels)]
        return bool(positions) and max(positions) - min(positions) >= WIGGLE - _SLACK


def _is_among(channel: int, heard: tuple[int, ...], sent: list[tuple[int, ...]]) -> bool:
    """Return whether a channel stands where it was sent to."""
    return channel < len(heard) and any(
        channel < len(one) and abs(one[channel] - heard[channel]) <= _SLACK for one in sent
    )
