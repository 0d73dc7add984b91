"""Processes that write to a store and are killed: forked, so that each begins at once."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from pathlib import Path
from types import TracebackType
from typing import Any, Self


class CrashNursery:
    """A process of its own that has loaded the product once, and forks who writes."""

    def __init__(self) -> None:
        self._process = subprocess.Popen(
            [sys.executable, __file__], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )

    def start(self, store: str, folder: Path, *, lies: bool = False) -> int:
        """Let a process write to ``folder/disk`` for ever, and return its number.

        Args:
            store: its name in ``STORES``.
            folder: beside what is written lies ``said``, and ``notes`` of what the disk has.
            lies: whether the disk only says that it has what it was asked for.
        """
        return int(self._asked("start", store, str(folder), lies))

    def stop(self, writer: int) -> None:
        """Let a writer stand still."""
        self._asked("stop", writer)

    def go_on(self, writer: int) -> None:
        """Let it write again."""
        self._asked("go_on", writer)

    def kill(self, writer: int) -> None:
        """Kill a writer; it is gone on return."""
        self._asked("kill", writer)

    def _asked(self, *words: Any) -> Any:
        assert self._process.stdin is not None and self._process.stdout is not None
        self._process.stdin.write(json.dumps(words) + "\n")
        self._process.stdin.flush()
        return json.loads(self._process.stdout.readline())

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._process.communicate(timeout=20.0)


def _start(store: str, folder: str, lies: bool) -> int:
    from crashing_stores import STORES, write_for_ever
    from power_cut import DiskWitness

    home = Path(folder)
    home.mkdir(parents=True)
    if child := os.fork():
        return child
    try:
        os.dup2(os.open(home / "errors", os.O_WRONLY | os.O_CREAT, 0o600), 2)
        os.dup2(2, 1)
        if lies:
            os.fsync = os.fdatasync = lambda descriptor: None  # type: ignore[assignment]
        else:
            DiskWitness(home / "disk", home / "notes").begin()
        write_for_ever(STORES[store], home / "disk", home / "said")
    except BaseException:
        import traceback

        traceback.print_exc()
    finally:
        os._exit(1)


def _serve() -> None:
    """Fork, stop and kill as told, until nobody tells any more; then end all that is left."""
    import crashing_stores

    crashing_stores._house()
    children: set[int] = set()
    for line in sys.stdin:
        word, *more = json.loads(line)
        answer: Any = None
        if word == "start":
            answer = _start(*more)
            children.add(answer)
        else:
            kind = {"stop": signal.SIGSTOP, "go_on": signal.SIGCONT, "kill": signal.SIGKILL}[word]
            os.kill(more[0], kind)
            if word != "go_on":
                os.waitpid(more[0], os.WUNTRACED if word == "stop" else 0)
            if word == "kill":
                children.discard(more[0])
        print(json.dumps(answer), flush=True)
    for child in children:
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)


if __name__ == "__main__":
    _serve()
