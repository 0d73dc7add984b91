"""Which time retention believes: after a leap of the clock nothing is deleted for its age.

While the program runs, the monotonic clock tells how much time has passed; over a restart up to
``LEAP`` may have. A wall clock that is further ahead is doubted until it has gone on for ``PROOF``;
until then the time that was believed goes on by the monotonic clock. Setting a clock back is
believed at once: it deletes nothing. A machine that was off for long waits a day too: it cannot
tell that from a leap.
"""

from __future__ import annotations

from dataclasses import dataclass

LEAP = 2 * 86_400.0
"""More than this over a restart is doubted [s]."""
STEP = 3600.0
"""More than this between the two clocks while the program runs is doubted [s]."""
PROOF = 86_400.0
"""How long a doubted clock must go on [s]."""


@dataclass(frozen=True, slots=True)
class ClockLook:
    """What the wall clock shows, and what the monotonic clock knows about it.

    Attributes:
        now: [Unix time, s].
        elapsed: since the last look of this program [s]; None for the first.
        stepped: whether the wall clock was set since then.
    """

    now: float
    elapsed: float | None = None
    stepped: bool = False


class StepWatch:
    """Looks at both clocks of a program that runs."""

    def __init__(self) -> None:
        self._before: tuple[float, float] | None = None

    def look(self, wall: float, monotonic: float) -> ClockLook:
        """Return what can be known now; both clocks in [s]."""
        before, self._before = self._before, (wall, monotonic)
        if before is None:
            return ClockLook(wall)
        elapsed = monotonic - before[1]
        return ClockLook(wall, elapsed, abs(wall - before[0] - elapsed) > STEP)


@dataclass(frozen=True, slots=True)
class BelievedTime:
    """The time by which clips grow old.

    Attributes:
        believed: [Unix time, s].
        doubted: to what the clock leapt [Unix time, s]; None without doubt.
    """

    believed: float
    doubted: float | None = None

    def after(self, look: ClockLook) -> BelievedTime:
        """Return what is believed after a look at the clocks."""
        now, doubted = look.now, self.doubted
        believed = self.believed + (look.elapsed or 0.0)
        if now <= believed + (LEAP if look.elapsed is None else STEP):
            return BelievedTime(now)
        if doubted is None or look.stepped or now < doubted:
            return BelievedTime(believed, now)
        return BelievedTime(now) if now >= doubted + PROOF else BelievedTime(believed, doubted)
