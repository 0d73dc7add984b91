"""``housefly preflight --frames`` as a process of its own, and somebody who presses Enter."""

from __future__ import annotations

import asyncio
import re
import sys
from asyncio.subprocess import PIPE, STDOUT, Process
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Self

STEP = re.compile(r"^(\d)/6 ")


class FrameCheckRun:
    """One run; an asynchronous context manager.

    Attributes:
        told: the lines so far.
    """

    def __init__(self, site: Path, *options: str, stdin: int = PIPE) -> None:
        self.told: list[str] = []
        self._command = (
            *(sys.executable, "-m", "housefly.cli", "preflight", "--frames"),
            *("--site", str(site), *options),
        )
        self._stdin = stdin

    async def __aenter__(self) -> Self:
        self.process: Process = await asyncio.create_subprocess_exec(
            *self._command, stdin=self._stdin, stdout=PIPE, stderr=STDOUT
        )
        return self

    async def __aexit__(self, *_: object) -> None:
        if self.process.returncode is None:
            self.process.terminate()
            await self.process.wait()

    async def line(self) -> str:
        """Return the next line, "" at the end."""
        assert self.process.stdout is not None
        line = (await asyncio.wait_for(self.process.stdout.readline(), 200.0)).decode()
        self.told.append(line.rstrip())
        return line

    def press_enter(self) -> None:
        assert self.process.stdin is not None
        self.process.stdin.write(b"\n")

    async def follow(self, do: Callable[[int], Awaitable[None]] | None = None) -> int:
        """Do each step as it is asked, press Enter, stand by it; return the exit code."""
        while line := await self.line():
            if found := STEP.match(line):
                if do is not None:
                    await do(int(found[1]))
                self.press_enter()
            elif "Enter when done" in line:
                self.press_enter()
        return await self.process.wait()

    @property
    def text(self) -> str:
        """All that was told."""
        return "\n".join(self.told)
