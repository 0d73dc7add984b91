"""The progress display of an identification flight: blocks flown, and the phase of the flight."""

from __future__ import annotations

from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeElapsedColumn

from housefly.app.terminal import ProgressDisplay, console

_LINES = 4
"""Lines that an output without a terminal gets in place of the bar."""


class IdentificationProgress(ProgressDisplay):
    """Shows how many of the blocks are flown: a bar on a terminal, elsewhere a line a quarter."""

    def __init__(self, blocks: int) -> None:
        super().__init__(
            TextColumn("{task.description:<16}"),
            BarColumn(24),
            MofNCompleteColumn(),
            TextColumn("blocks"),
            TimeElapsedColumn(),
        )
        self._task = self._progress.add_task("starting", total=blocks)
        self._blocks, self._told = blocks, 0
        self._shown: tuple[int, str] | None = None

    def show(self, done: int, phase: str) -> None:
        """Show how many blocks are done, and what the drone does."""
        if self._shown != (done, phase):
            self._shown = (done, phase)
            self._progress.update(self._task, completed=done, description=phase)
            self._tell(done)

    def _tell(self, done: int) -> None:
        quarter = done * _LINES // self._blocks
        if quarter > self._told and not console.is_terminal:
            self._told = quarter
            console.print(f"{done} of {self._blocks} blocks flown")
