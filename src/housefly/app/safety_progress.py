"""How far the flights of the safety case are: a bar in a terminal, a line each minute elsewhere."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Self

from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeRemainingColumn

from housefly.app.terminal import ProgressDisplay, console

LINE_PERIOD = 60.0
"""Between two lines where the output is no terminal [s]."""


class SafetyProgress(ProgressDisplay):
    """How many flights are flown, and at once each unsafe one."""

    def __init__(
        self, what: str, total: int, there: int, clock: Callable[[], float] = time.monotonic
    ) -> None:
        """Prepare the bar.

        Args:
            what: is counted, in words.
            total: flights in all; with 0 nothing is shown.
            there: how many of them an earlier run has flown.
            clock: monotonic time [s].
        """
        super().__init__(
            TextColumn(what),
            BarColumn(30),
            MofNCompleteColumn(),
            TextColumn("{task.fields[unsafe]} unsafe"),
            TimeRemainingColumn(),
        )
        self._task = self._progress.add_task(
            "", total=total, completed=there, unsafe=0, visible=total > 0
        )
        self._what, self._total, self._there, self._clock = what, total, there, clock
        self._flown = self._unsafe = 0
        self._began = self._told_at = clock()

    def __enter__(self) -> Self:
        super().__enter__()
        self._began = self._clock()
        if self._total:
            self._tell()
        return self

    def advance(self, unsafe: str) -> None:
        """Count a flight; takes what was unsafe in it, in words, or ""."""
        self._flown, self._unsafe = self._flown + 1, self._unsafe + bool(unsafe)
        self._progress.update(self._task, advance=1, unsafe=self._unsafe)
        if unsafe:
            console.print(f"unsafe: {unsafe}", markup=False, soft_wrap=True)
        if self._clock() - self._told_at >= LINE_PERIOD:
            self._tell()

    def _tell(self) -> None:
        self._told_at = self._clock()
        if console.is_terminal:
            return
        done = self._there + self._flown
        minutes = (self._told_at - self._began) * (self._total - done) / max(self._flown, 1) / 60
        left = f", about {minutes:.0f} min left" if self._flown else ""
        words = f"{self._what}: {done} of {self._total}, {self._unsafe} unsafe{left}"
        console.print(words, soft_wrap=True)
