"""When a dead process is started again, and what is said about its death."""

from __future__ import annotations

import signal
from dataclasses import dataclass
from pathlib import Path

_PAUSE, _LONGEST_PAUSE = 0.5, 4.0
"""Pause before the first new start, doubled at each further early death; and the longest [s]."""
START_TIME = 20.0
"""A process that ends by itself sooner than this counts as one that cannot start [s]."""
START_ATTEMPTS = 4
"""Starts in a row that fail before it is given up."""
_LAST_LINES, _LAST_BYTES = 3, 4096
"""How much of the log is quoted."""
_FROM_OUTSIDE = frozenset(
    -number for number in (signal.SIGKILL, signal.SIGTERM, signal.SIGINT, signal.SIGHUP)
)
"""Exit codes of a process that somebody else ended."""


@dataclass(frozen=True, slots=True)
class Restart:
    """What follows a death.

    Attributes:
        failures: starts in a row that failed so far, this one included.
        pause: before the next start [s]; None gives the process up.
    """

    failures: int
    pause: float | None


def restart_after(exit_code: int, uptime: float, failures: int) -> Restart:
    """Return what follows a death.

    Args:
        exit_code: as of ``subprocess``: negative is a signal.
        uptime: how long the process was there [s].
        failures: starts in a row that had failed before.
    """
    if exit_code in _FROM_OUTSIDE or uptime >= START_TIME:
        return Restart(0, _PAUSE)
    failures += 1
    if failures >= START_ATTEMPTS:
        return Restart(failures, None)
    return Restart(failures, min(_LONGEST_PAUSE, _PAUSE * 2 ** (failures - 1)))


@dataclass(frozen=True, slots=True)
class Death:
    """One death of a process.

    Attributes:
        name: of the process.
        given_up: whether it is not started again.
        last_words: last lines of its log since it was started; may be empty.
        log: path of the whole log.
    """

    name: str
    given_up: bool
    last_words: tuple[str, ...]
    log: Path

    def __str__(self) -> str:
        if not self.given_up:
            return f"{self.name} died and was started again (its log: {self.log})"
        said = "\n  ".join(self.last_words or ("(nothing: is the disk full?)",))
        return (
            f"{self.name} cannot start and is not tried again. It said:\n  {said}\nmend that, then"
            f" end with Ctrl-C and start anew (its whole log: {self.log})"
        )


def last_words(log: Path, since: int) -> tuple[str, ...]:
    """Return the last lines of a log from a position [bytes] on; empty if it cannot be read."""
    try:
        with log.open("rb") as file:
            end = file.seek(0, 2)
            file.seek(max(since, end - _LAST_BYTES))
            lines = file.read().decode(errors="replace").splitlines()
    except OSError:
        return ()
    return tuple(line.strip()[:500] for line in lines if line.strip())[-_LAST_LINES:]
