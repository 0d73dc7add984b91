"""What a console must know again after its process died: who flies, whether STOP holds, the log.

One file in the run's folder, one JSON object a line, written on a thread: nothing waits for the
disk. Another run begins with another folder.
"""

from __future__ import annotations

import json
import logging
import os
import queue
import threading
from collections import deque
from collections.abc import Iterable
from dataclasses import asdict, dataclass
from pathlib import Path

from pydantic import TypeAdapter

from housefly.config.durable import append_lines
from housefly.messages.words import with_trees
from housefly.web.messages.server_messages import EventView

_LOG = logging.getLogger(__name__)
_FILE = "console.jsonl"
_WAITING = 2000
"""Lines that may wait for the disk; more are lost."""
_EVENTS_KEPT = 300
_SIZE_MAX = 2**20
"""A longer file is written anew with what still counts [bytes]."""


@dataclass(frozen=True, slots=True)
class KnownTab:
    """A tab that was open: whose session, which tab, its number and the name that others saw."""

    owner: str
    tab: str
    number: int
    name: str


@dataclass(frozen=True, slots=True)
class KeptControl:
    """Who had control, who else was there, and the STOP that held."""

    holder: int | None = None
    tabs: tuple[KnownTab, ...] = ()
    stop_holds: bool = False
    stop_by: str = ""


@dataclass(frozen=True, slots=True)
class KeptConsole:
    """What an earlier console of this run kept; ``is_new`` is False when there was one."""

    is_new: bool = True
    control: KeptControl = KeptControl()
    events: tuple[EventView, ...] = ()


_CONTROL: TypeAdapter[KeptControl] = TypeAdapter(KeptControl)
_EVENT: TypeAdapter[EventView] = TypeAdapter(EventView)


class ConsoleMemory:
    """Reads what was kept, and keeps what changes.

    Args:
        folder: of the run.
    """

    def __init__(self, folder: Path) -> None:
        self._file = folder / _FILE
        self._control, self._events = KeptControl(), deque[EventView](maxlen=_EVENTS_KEPT)
        self._waiting: queue.Queue[KeptControl | EventView | None] = queue.Queue(_WAITING)
        self._thread: threading.Thread | None = None

    def read(self, now: float) -> KeptConsole:
        """Return what an earlier console kept; call it once, before anything is kept.

        Args:
            now: on the machine's monotonic clock [s]; what is stamped later is of another boot.
        """
        try:
            lines = self._file.read_text(encoding="utf-8", errors="replace").splitlines()
        except OSError:
            lines = []
        for line in lines:
            self._take(line)
        events = tuple(one for one in self._events if one.at <= now)
        self._events = deque(events, maxlen=_EVENTS_KEPT)
        self._thread = threading.Thread(target=self._run, name="console-memory", daemon=True)
        self._thread.start()
        return KeptConsole(not lines, self._control, events)

    def keep_control(self, control: KeptControl) -> None:
        """Write soon who has control and whether STOP holds; never waits."""
        self._put(control)

    def keep_event(self, event: EventView) -> None:
        """Write a line of the event log soon; never waits."""
        self._put(event)

    def close(self) -> None:
        """Write what waits, for at most a second."""
        self._put(None)
        if self._thread is not None:
            self._thread.join(timeout=1.0)

    def _put(self, one: KeptControl | EventView | None) -> None:
        try:
            self._waiting.put_nowait(one)
        except queue.Full:
            _LOG.error("%s takes no more: a restart of the console will not know all", self._file)

    def _take(self, line: str) -> None:
        """Read one line; one that was cut off as the process died counts for nothing."""
        try:
            told = json.loads(line)
            if "control" in told:
                self._control = _CONTROL.validate_python(told["control"])
            else:
                self._events.append(_EVENT.validate_python(told["event"]))
        except (ValueError, KeyError, TypeError, RecursionError):
            _LOG.warning("a line of %s is not understood", self._file)

    def _run(self) -> None:
        while (one := self._waiting.get()) is not None:
            if isinstance(one, KeptControl):
                self._control = one
            else:
                self._events.append(one)
            try:
                self._append(_line(one))
            except OSError as error:
                _LOG.error("%s cannot be written: %s", self._file, error.strerror)

    def _append(self, line: str) -> None:
        # The run ends with the power: only what a kill leaves counts here.
        if append_lines(self._file, [line], sync=False) > _SIZE_MAX:
            self._write_anew([*map(_line, self._events), _line(self._control)])

    def _write_anew(self, lines: Iterable[str]) -> None:
        fresh = self._file.with_suffix(".new")
        flags = os.O_WRONLY | os.O_TRUNC | os.O_CREAT | os.O_NOFOLLOW
        with os.fdopen(os.open(fresh, flags, 0o600), "w", encoding="utf-8") as file:
            file.writelines(f"{line}\n" for line in lines)
        fresh.replace(self._file)


def _line(one: KeptControl | EventView) -> str:
    kind = "control" if isinstance(one, KeptControl) else "event"
    told = asdict(one, dict_factory=with_trees)
    return json.dumps({kind: told}, default=lambda value: value.value)
