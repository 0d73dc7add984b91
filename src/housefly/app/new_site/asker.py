"""Where answers come from: options first, then somebody at the terminal, or a script's lines."""

from __future__ import annotations

import sys
from typing import Protocol

from housefly.app.terminal import console


class OutOfAnswers(Exception):
    """A script's lines ended before the last question."""


class Asker(Protocol):
    """Whoever answers."""

    is_patient: bool
    """Whether a wrong answer may be followed by a better one."""

    def ask(self, words: str, default: str) -> str:
        """Return the answer to a question, "" for Enter; raises OutOfAnswers at the end."""
        ...

    def tell(self, words: str) -> None:
        """Say something."""
        ...


class _Printer:
    def tell(self, words: str) -> None:
        """Print lines, set in from the questions."""
        for line in words.splitlines() or [""]:
            console.print(f"  {line}", markup=False, soft_wrap=True)


class TerminalAsker(_Printer):
    """Reads lines from the standard input; a script's are shown, so that its output reads whole."""

    def __init__(self) -> None:
        self.is_patient = sys.stdin.isatty()
        self.typed = 0
        """Keys that were typed so far, Enter included."""

    def ask(self, words: str, default: str) -> str:
        """Ask on one line, with what Enter stands for in brackets."""
        question = f"{words} [{default}]: " if default else f"{words}: "
        console.print(question, end="", markup=False, soft_wrap=True)
        sys.stdout.flush()
        line = sys.stdin.readline()
        if not line:
            console.print()
            raise OutOfAnswers("the answers ended")
        if not self.is_patient:
            console.print(line.rstrip("\n"), markup=False)
        self.typed += len(line)
        return line.strip()


class DefaultsAsker(_Printer):
    """Takes every default: what ``--yes`` does."""

    is_patient = False

    def ask(self, words: str, default: str) -> str:
        """Return Enter."""
        console.print(f"{words} [{default}]" if default else words, markup=False)
        return ""
