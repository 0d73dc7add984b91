"""The terminal that every command prints to."""

from __future__ import annotations

from collections.abc import Iterable
from types import TracebackType
from typing import Any, Self

from rich.console import Console
from rich.progress import Progress, ProgressColumn
from rich.table import Table

console = Console(highlight=False)
plain_console = Console(highlight=False, markup=False, emoji=False)
"""For words that come from devices and memory: brackets in them are text, never a style."""
note_console = Console(stderr=True, highlight=False, markup=False, emoji=False)
"""For notes about an answer, which must not get into what a script reads."""


def new_table(headings: Iterable[str], **column: Any) -> Table:
    """Return a table without lines; ``column`` holds rich's options for each column."""
    table = Table(box=None, pad_edge=False)
    for heading in headings:
        table.add_column(heading, **column)
    return table


def new_progress(*columns: ProgressColumn) -> Progress:
    """Return a progress display; it vanishes at the end where the output is no terminal."""
    return Progress(*columns, console=console, transient=not console.is_terminal)


class ProgressDisplay:
    """A progress display that runs while its context is open."""

    def __init__(self, *columns: ProgressColumn) -> None:
        self._progress = new_progress(*columns)

    def __enter__(self) -> Self:
        self._progress.start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._progress.stop()
