"""The progress display of a campaign: drones landed, speed, time left."""

from __future__ import annotations

import time
from typing import Self

from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeRemainingColumn

from housefly.app.terminal import ProgressDisplay


class CampaignProgress(ProgressDisplay):
    """A bar with drones done, drone-seconds a second, and the time left."""

    def __init__(self, drones: int, there: int, duration: float) -> None:
        """Prepare the bar.

        Args:
            drones: in the whole campaign.
            there: how many of them an earlier run has flown.
            duration: of one flight [s].
        """
        super().__init__(
            TextColumn("drones"),
            BarColumn(30),
            MofNCompleteColumn(),
            TextColumn("{task.fields[speed]}"),
            TimeRemainingColumn(),
        )
        self._task = self._progress.add_task("", total=drones, completed=there, speed="")
        self._duration = duration
        self._began = time.monotonic()
        self._flown = 0

    def __enter__(self) -> Self:
        self._began = time.monotonic()
        return super().__enter__()

    def advance(self, drones: int) -> None:
        """Show that some more have landed."""
        self._flown += drones
        speed = self._flown * self._duration / max(time.monotonic() - self._began, 1e-3)
        self._progress.update(self._task, advance=drones, speed=f"{speed:,.0f} drone-s/s")
