"""SIGINT, SIGTERM and SIGHUP of a command that flies: one wish to end, however often it comes."""

from __future__ import annotations

import os
import signal
import threading
import time
from types import FrameType, TracebackType
from typing import Any, Self

_DOUBLED = 0.5
"""A second Ctrl-C within this time is the first one, passed on by somebody else too [s]."""


class EndSignals:
    """Turns the first signal into KeyboardInterrupt and takes later ones for the same wish.

    Use it as a context manager, in the main thread; elsewhere it changes nothing.

    Attributes:
        is_impatient: whether a person typed Ctrl-C a second time and will not wait.
    """

    def __init__(self) -> None:
        self.is_impatient = False
        self._is_asked = False
        self._ctrl_c_at: float | None = None
        self._before: dict[int, Any] = {}

    def __enter__(self) -> Self:
        if threading.current_thread() is threading.main_thread():
            for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                # nohup: whoever had it ignored wants the run to outlive the terminal.
                if number == signal.SIGHUP and signal.getsignal(number) is signal.SIG_IGN:
                    continue
                self._before[number] = signal.signal(number, self._on_signal)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        for number, handler in self._before.items():
            signal.signal(number, handler)

    def _on_signal(self, number: int, frame: FrameType | None) -> None:
        if number == signal.SIGINT:
            self._on_ctrl_c(time.monotonic())
        if not self._is_asked:
            self._is_asked = True
            raise KeyboardInterrupt

    def _on_ctrl_c(self, now: float) -> None:
        if self._ctrl_c_at is None:
            self._ctrl_c_at = now
        elif now - self._ctrl_c_at > _DOUBLED and _is_in_foreground():
            self.is_impatient = True


def _is_in_foreground() -> bool:
    """Return whether a Ctrl-C that somebody types now reaches this process."""
    try:
        terminal = os.open("/dev/tty", os.O_RDONLY | os.O_NOCTTY)
    except OSError:
        return False
    try:
        return os.tcgetpgrp(terminal) == os.getpgrp()
    except OSError:
        return False
    finally:
        os.close(terminal)
