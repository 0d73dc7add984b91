"""Whether to go on, to wait or to go around people, decided so that it does not flap.

Three things hold a decision: a trajectory in use may come nearer than a new one (``GIVE``), who
waits or flies slower is faster only after the way was free for a while, and a way around must be
much earlier, not too soon after the last. To be slower needs none of them: it is at once.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum
from math import inf

from housefly.pilot.planning.space.passage import Passage, first_passage

GIVE = 0.1
"""A trajectory in use may come this much nearer than one that begins [m]."""
CLEAR_TIME = 0.6
"""Faster again when the way was free for this long [s]."""
EARLIER = 1.5
"""A way around is taken when it arrives so much earlier [s] ..."""
AGAIN_AFTER = 4.0
"""... and not sooner than this after the last [s]."""


class PassingChoice(Enum):
    """What to do about people on the way."""

    GO_ON = "go on"
    WAIT = "wait"
    AROUND = "go around"


@dataclass(frozen=True, slots=True)
class Passing:
    """What was decided.

    Attributes:
        choice: AROUND lasts one step: a new trajectory begins.
        rate: wanted of the trajectory's time.
        clear_since: since when it could be faster [s]; infinite when it could not.
        around_at: when a way around was last taken [s].
    """

    choice: PassingChoice = PassingChoice.GO_ON
    rate: float = 1.0
    clear_since: float = inf
    around_at: float = -inf


def passed(state: Passing, choices: list[Passage], around: float, now: float) -> Passing:
    """Return the next decision.

    Args:
        state: the last.
        choices: of the trajectory in use (``passage.passages``).
        around: when another trajectory from here would arrive, from now on [s]; infinite when there
            is none, or none was asked for.
        now: time [s].
    """
    lax, strict = first_passage(choices, GIVE), first_passage(choices, 0.0)
    arrival = inf if lax is None else lax.arrival
    if around < arrival - EARLIER and now - state.around_at >= AGAIN_AFTER:
        return Passing(PassingChoice.AROUND, 1.0, inf, now)
    if _rate(lax) < state.rate:
        return _going(state, _rate(lax))
    if _rate(strict) <= state.rate:
        return _going(state, state.rate)
    since = min(state.clear_since, now)
    if now - since < CLEAR_TIME:
        return replace(_going(state, state.rate), clear_since=since)
    return _going(state, _rate(strict))


def _rate(passage: Passage | None) -> float:
    """Return the rate that is wanted at once: 0 to wait, or where there is no way past."""
    return 0.0 if passage is None or passage.wait > 0.0 else passage.rate


def _going(state: Passing, rate: float) -> Passing:
    choice = PassingChoice.GO_ON if rate > 0.0 else PassingChoice.WAIT
    return Passing(choice, rate, inf, state.around_at)
