"""The simulated room that the page of a new site opens: ``housefly demo`` as a process of its own.

It serves loopback only, as the user who started ``housefly new``, and ends with that.
"""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import threading
from collections.abc import Sequence
from pathlib import Path

from housefly.web.new_site.draft_answers import OpenedState, OpenedView

_DEMO = (sys.executable, "-m", "housefly.cli", "demo")
_ADDRESS = re.compile(r"http://127\.\S+")
_READY = "ready after"
_PROGRESS = ("compil", "not ready")
"""How a line begins that tells how far it is; the others are for a terminal."""
_LANDING_TIME = 90.0
"""Longest time from the wish to end to the end [s]: it lands first."""
_LINE_MAX = 200


class OpenedRoom:
    """Starts at most one room at a time; safe from any thread.

    Args:
        command: that starts it; ``--site FILE --port 0`` is added.
    """

    def __init__(self, command: Sequence[str] = _DEMO) -> None:
        self._command = tuple(command)
        self._process: subprocess.Popen[str] | None = None
        self._view = OpenedView(OpenedState.CLOSED)
        self._lock = threading.Lock()

    def open(self, site: Path) -> None:
        """Start the room of a site, unless one is there; raises OSError where that cannot be."""
        with self._lock:
            if self._process is not None and self._process.poll() is None:
                return
            self._view = OpenedView(OpenedState.STARTING)
            # A session of its own: Ctrl-C reaches it once, by ``close``, and it lands in peace.
            self._process = subprocess.Popen(
                [*self._command, "--site", str(site), "--port", "0"],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
                errors="replace",
                env={**os.environ, "COLUMNS": "400"},
                start_new_session=True,
            )
            reader = threading.Thread(target=self._read, args=(self._process,), daemon=True)
            reader.start()

    def view(self) -> OpenedView:
        """Return how far it is."""
        return self._view

    def close(self) -> None:
        """Land and end it; returns when it has ended."""
        process = self._process
        if process is None or process.poll() is not None:
            return
        process.send_signal(signal.SIGINT)
        try:
            process.wait(_LANDING_TIME)
        finally:
            process.kill()
            process.wait()

    def _read(self, process: subprocess.Popen[str]) -> None:
        assert process.stdout is not None
        address, state, line, told = "", OpenedState.STARTING, "", ""
        for text in process.stdout:
            line = text.strip()[:_LINE_MAX] or line
            address = found[0] if (found := _ADDRESS.search(text)) else address
            if address and text.startswith(_READY):
                state = OpenedState.READY
            told = line if line.startswith(_PROGRESS) else told
            self._view = OpenedView(state, told, address)
        self._view = OpenedView(OpenedState.ENDED, line)
