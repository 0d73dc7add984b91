"""Checks drafts on a thread of its own: for a large scan it takes longer than a hand moves."""

from __future__ import annotations

from concurrent.futures import Future, ThreadPoolExecutor
from concurrent.futures import TimeoutError as NotYet
from dataclasses import dataclass

from housefly.hub.api.pilot_queries import GridView
from housefly.room.draft.model import SiteDraft
from housefly.web.new_site.draft_view import (
    FitView,
    MissingView,
    fit_view,
    flyable,
    missing_views,
    scan_view,
)

PATIENCE = 0.6
"""How long an answer waits for the check [s]; then it comes with what the last check found."""


@dataclass(frozen=True, slots=True)
class DraftCheck:
    """What follows from a draft; see ``DraftView``."""

    grid: GridView | None = None
    scan: GridView | None = None
    missing: tuple[MissingView, ...] = ()
    fit: FitView | None = None


class DraftChecker:
    """Checks the newest draft; those that were overtaken meanwhile are left out."""

    def __init__(self) -> None:
        self._pool = ThreadPoolExecutor(1, "check")
        self._wanted: SiteDraft | None = None
        self._last = DraftCheck()
        self._work: Future[DraftCheck] | None = None

    def of(self, draft: SiteDraft, patience: float = PATIENCE) -> tuple[DraftCheck, bool]:
        """Return what is known by now, and whether it is about this draft."""
        if self._work is None or self._wanted != draft:
            self._wanted = draft
            self._work = self._pool.submit(self._checked, draft)
        try:
            return self._work.result(timeout=patience), True
        except NotYet:
            return self._last, False

    def close(self) -> None:
        """Shut the thread down without waiting."""
        self._pool.shutdown(wait=False, cancel_futures=True)

    def _checked(self, draft: SiteDraft) -> DraftCheck:
        if draft is self._wanted:
            self._last = DraftCheck(
                flyable(draft), scan_view(draft), missing_views(draft), fit_view(draft)
            )
        return self._last
