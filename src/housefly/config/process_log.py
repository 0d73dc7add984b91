"""What a process prints into its log; a full disk there keeps nobody from what they do."""

from __future__ import annotations

import sys
import time
import traceback
from contextlib import suppress
from math import inf
from typing import TextIO

REPEAT_PERIOD = 10.0
"""An exception from the same line is printed again after this [s]."""


def log_line(words: str, stream: TextIO | None = None) -> None:
    """Print a line at once, and raise nothing where it cannot be written.

    Args:
        words: without the line's end.
        stream: standard output when None.
    """
    # ValueError: the stream is closed, or its encoding lacks a letter.
    with suppress(OSError, ValueError):
        print(words, file=stream, flush=True)


def log_traceback() -> None:
    """Print the exception that is being handled, as ``log_line`` does, to standard error.

    One that comes from the same line again and again is printed every ten seconds, with how often
    it came: what fails a hundred times a second must not fill the disk.
    """
    error = sys.exception()
    if error is None:
        return
    repeats = _REPEATS.count(error, time.monotonic())
    if repeats is None:
        return
    often = f"\n(and {repeats} times more since the last time)" if repeats else ""
    log_line(traceback.format_exc().rstrip("\n") + often, sys.stderr)


class _Repeats:
    """Counts exceptions by the line that they come from."""

    def __init__(self) -> None:
        self._seen: dict[tuple[type, str, int], tuple[float, int]] = {}

    def count(self, error: BaseException, now: float) -> int | None:
        """Return how many like this were left out before it; None when it is to be, too."""
        place = traceback.extract_tb(error.__traceback__, limit=-1)[0]
        key = (type(error), place.filename, place.lineno or 0)
        printed_at, left_out = self._seen.get(key, (-inf, 0))
        if now - printed_at < REPEAT_PERIOD:
            self._seen[key] = (printed_at, left_out + 1)
            return None
        self._seen[key] = (now, 0)
        return left_out


_REPEATS = _Repeats()
