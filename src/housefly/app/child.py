"""Entry of each process: ``python -m housefly.app.child PARENT NICENESS WATCHED HELD MODULE ...``.

A process that lands the drone (``HELD`` is a file descriptor) takes SIGINT, SIGTERM and SIGHUP, and
the death of its launcher, for one and the same wish: its module sees SIGTERM. The others stay as
long as one of those is there: they end when ``WATCHED`` ends, and signals do not end them earlier,
but for SIGUSR2, by which the launcher starts one of them anew.
"""

from __future__ import annotations

import atexit
import gc
import os
import runpy
import select
import signal
import sys
import threading
import time
from contextlib import suppress
from types import FrameType

_POLL_PERIOD = 0.5
"""How often a child looks whether its launcher is gone although the pipe is open [s]."""
_LANDING_TIMEOUT = 90.0
"""Longest stay of a process that lands nothing after its launcher is gone [s]."""
_EXIT_TIMEOUT = 10.0
"""Longest time from the wish to end to the end, of a process that lands nothing [s]."""
RENEW_SIGNAL = signal.SIGUSR2
"""Ends a process that lands nothing, because its launcher starts it anew."""
_END_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def main() -> None:
    """Set priority and signals, watch the launcher, and run the module."""
    parent, niceness, watched, held = map(int, sys.argv[1:5])
    module, lands = sys.argv[5], held >= 0
    os.umask(0o077)
    with suppress(PermissionError):
        os.nice(niceness)
    for descriptor in (watched, held) if lands else (watched,):
        os.set_inheritable(descriptor, False)
    if lands:
        for number in (signal.SIGINT, signal.SIGHUP):
            signal.signal(number, lambda *_: os.kill(os.getpid(), signal.SIGTERM))
    else:
        # Threads that start from now on inherit this; the watching one undoes it in the end.
        signal.pthread_sigmask(signal.SIG_BLOCK, _END_SIGNALS)
        signal.signal(RENEW_SIGNAL, _end)
    threading.Thread(
        target=_watch, args=(watched, parent, lands), name="launcher watch", daemon=True
    ).start()
    atexit.register(gc.freeze)  # or Python's own end searches all modules for garbage
    sys.argv = [module, *sys.argv[6:]]
    runpy.run_module(module, run_name="__main__", alter_sys=True)


def _end(number: int, frame: FrameType | None) -> None:
    signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGTERM})
    os.kill(os.getpid(), signal.SIGTERM)


def _watch(watched: int, parent: int, lands: bool) -> None:
    """End this process in order when it is time."""
    _wait(watched, parent, 0.0 if lands else _LANDING_TIMEOUT)
    if lands:
        os.kill(os.getpid(), signal.SIGTERM)
        return
    signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGTERM})
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep(_EXIT_TIMEOUT)
    os._exit(1)


def _wait(watched: int, parent: int, patience: float) -> None:
    """Wait for the end of the pipe, or for so long after the launcher is gone [s].

    A program that forked from the launcher's may hold the pipe open.
    """
    poll = select.poll()
    poll.register(watched, select.POLLIN)
    gone_at = None
    while not poll.poll(1e3 * _POLL_PERIOD):
        if os.getppid() != parent:
            gone_at = gone_at or time.monotonic()
            if time.monotonic() - gone_at >= patience:
                return


if __name__ == "__main__":
    main()
