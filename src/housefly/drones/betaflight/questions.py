"""What a controller is asked next: half of its hundred commands a second are sticks. Pure."""

from __future__ import annotations

from math import inf

from housefly.drones.betaflight.controller import QUESTIONS
from housefly.wires.betaflight.commands import Msp

PERIODS = {Msp.ATTITUDE: 0.04, Msp.STATUS_EX: 0.1, Msp.RC: 0.2, Msp.BATTERY_STATE: 1.0}
"""How often each is asked [s]."""
AGAIN_AFTER = 0.2
"""A question that was not answered is asked again [s]."""
LOOK_AGAIN = 0.5
"""While it stands, one of its settings is looked at anew this often [s]."""


class Questions:
    """Knows what was asked, and when."""

    def __init__(self) -> None:
        self._asked_at: dict[Msp, float] = {}
        self._looked_at, self._looked = -inf, 0

    def missing(self, told: frozenset[int], now: float) -> Msp | None:
        """Return the next question of those that are asked before a flight; None while all are out.

        Args:
            told: what was answered.
            now: [s].
        """
        left = [one for one in QUESTIONS if one not in told]
        if not left:
            return None
        next_one = min(left, key=lambda one: self._asked_at.get(one, -inf))
        if now - self._asked_at.get(next_one, -inf) < AGAIN_AFTER:
            return None
        return self._ask(next_one, now)

    def due(self, now: float, *, stands: bool) -> Msp | None:
        """Return what is due now [s], the most overdue first; None for nothing.

        Args:
            now: [s].
            stands: whether its motors are off: then its settings are looked at, too.
        """
        waits = {one: (now - self._asked_at.get(one, -inf)) / PERIODS[one] for one in PERIODS}
        first = max(waits, key=lambda one: waits[one])
        if waits[first] >= 1.0 - 1e-6:
            return self._ask(first, now)
        if stands and now - self._looked_at >= LOOK_AGAIN:
            self._looked_at, self._looked = now, (self._looked + 1) % len(QUESTIONS)
            return QUESTIONS[self._looked]
        return None

    def _ask(self, question: Msp, now: float) -> Msp:
        self._asked_at[question] = now
        return question
