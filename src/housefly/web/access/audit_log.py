"""Who asked for what and when: a file that only this user can read, written on a thread of its own.

A power cut takes back some milliseconds of it. Nothing waits for the disk: a line that finds the
queue full is counted as lost and said so in the next one. STOP does not depend on it.
"""

from __future__ import annotations

import json
import logging
import queue
import threading
import time
from contextlib import suppress
from pathlib import Path

from housefly.config.durable import append_lines

_LOG = logging.getLogger(__name__)
_WAITING = 2000
"""Lines that may wait for the disk."""
_TOGETHER = 50
"""Lines for which the disk is waited for once."""
_WORDS_LENGTH = 2000
"""A line is cut after so many characters: few long ones must not drive many short ones out."""
MAX_SIZE = 8 * 2**20
"""A file longer than this [bytes] is put aside, and a new one begun; the one before is removed."""


class AuditLog:
    """Appends one JSON object a line: ``at`` (Unix time [s]), ``who``, ``session``, ``what``.

    Args:
        file: mode 0600; its folder is made if missing.
    """

    def __init__(self, file: Path) -> None:
        self._file = file
        self._lines: queue.Queue[str | None] = queue.Queue(_WAITING)
        self._lost = self._size = 0
        self._thread = threading.Thread(target=self._run, name="audit", daemon=True)
        self._thread.start()

    def record(self, who: str, session: str, what: str) -> None:
        """Write a line soon; never waits, never raises.

        Args:
            who: name of the viewer or program.
            session: the start of its session's name, which is no secret.
            what: what was asked, and what became of it.
        """
        line: dict[str, float | str] = {"at": round(time.time(), 3), "who": who}
        line |= {"session": session[:8], "what": what[:_WORDS_LENGTH]}
        if self._lost:
            line["lost"] = self._lost
        try:
            self._lines.put_nowait(json.dumps(line))
            self._lost = 0
        except queue.Full:
            self._lost += 1

    def close(self) -> None:
        """Write what waits, for at most a second."""
        try:
            self._lines.put(None, timeout=1.0)
        except queue.Full:
            return
        self._thread.join(timeout=1.0)

    def _run(self) -> None:
        is_open = True
        while is_open:
            waiting = [self._lines.get()]
            while not self._lines.empty() and len(waiting) < _TOGETHER:
                waiting.append(self._lines.get())
            is_open = None not in waiting
            try:
                self._append([line for line in waiting if line is not None])
            except OSError as error:
                _LOG.error("the audit log %s cannot be written: %s", self._file, error.strerror)

    def _append(self, lines: list[str]) -> None:
        if not lines:
            return
        self._file.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
        if self._size > MAX_SIZE:
            with suppress(FileNotFoundError):  # somebody took it away
                self._file.replace(self._file.with_suffix(".old.jsonl"))
        self._size = append_lines(self._file, lines)
