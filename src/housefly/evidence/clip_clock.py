"""Which time retention believes: after a leap of the clock nothing is deleted for its age.

While the program runs, the monotonic clock tells how much time has passed; over a restart up to
``RESTART_LEAP_MAX`` may have. A wall clock that is further ahead is doubted until it has gone on
for ``PROOF_TIME``; until then the time that was believed goes on by the monotonic clock. Setting a
clock back is believed at once: it deletes nothing. A machine that was off for long waits a day too:
it cannot tell that from a leap.
"""

from __future__ import annotations

from dataclasses import dataclass

RESTART_LEAP_MAX = 2 * 86_400.0
"""More than this over a restart is doubted [s]."""
CLOCK_STEP_MAX = 3600.0
"""More than this between the two clocks while the program runs is doubted [s]."""
PROOF_TIME = 86_400.0
"""How long a doubted clock must go on [s]."""


@dataclass(frozen=True, slots=True)
class ClockReading:
    """What the wall clock shows, and what the monotonic clock knows about it.

    Attributes:
        now: [Unix time, s].
        elapsed: since the last reading of this program [s]; None for the first.
        stepped: whether the wall clock was set since then.
    """

    now: float
    elapsed: float | None = None
    stepped: bool = False


class ClockWatch:
    """Looks at both clocks of a program that runs."""

    def __init__(self) -> None:
        self._before: tuple[float, float] | None = None

    def read(self, wall: float, monotonic: float) -> ClockReading:
        """Return what can be known now; both clocks in [s]."""
        before, self._before = self._before, (wall, monotonic)
        if before is None:
            return ClockReading(wall)
        elapsed = monotonic - before[1]
        return ClockReading(wall, elapsed, abs(wall - before[0] - elapsed) > CLOCK_STEP_MAX)


@dataclass(frozen=True, slots=True)
class BelievedTime:
    """The time by which clips grow old.

    Attributes:
        believed: [Unix time, s].
        doubted: to what the clock leapt [Unix time, s]; None without doubt.
    """

    believed: float
    doubted: float | None = None

    def after(self, reading: ClockReading) -> BelievedTime:
        """Return what is believed after a look at the clocks."""
        now, doubted = reading.now, self.doubted
        believed = self.believed + (reading.elapsed or 0.0)
        if now <= believed + (RESTART_LEAP_MAX if reading.elapsed is None else CLOCK_STEP_MAX):
            return BelievedTime(now)
        if doubted is None or reading.stepped or now < doubted:
            return BelievedTime(believed, now)
        return BelievedTime(now) if now >= doubted + PROOF_TIME else BelievedTime(believed, doubted)
