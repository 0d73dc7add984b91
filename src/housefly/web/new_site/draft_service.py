"""Keeps the draft of one site for the page: change, undo, write. Blocking; one thread calls it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from hashlib import blake2b
from pathlib import Path

from housefly.errors import StaleEdits
from housefly.messages.words import UNSAID, Words
from housefly.room.draft.codec import draft_to_json
from housefly.room.draft.files import SIMULATED_FILE, SITE_FILE, load_draft, save_draft, write_site
from housefly.room.draft.model import SiteDraft
from housefly.web.new_site.draft_checker import DraftChecker
from housefly.web.new_site.draft_view import DraftView, model_views, without_scan

_UNDO_MAX = 200


class DraftService:
    """The draft of a folder, and what was done to it since the page was started.

    Every change is in the folder's file before it is answered, so that nothing is lost.

    Args:
        folder: of the site.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self._before: list[SiteDraft] = []
        self._after: list[SiteDraft] = []
        self._checker = DraftChecker()
        self._notes: tuple[Words, ...] = ()

    def draft(self) -> SiteDraft:
        """Return the draft as the file has it; the dialog in a terminal may have changed it."""
        return load_draft(self.folder) or SiteDraft(name=self.folder.resolve().name[:60])

    def view(self, words: Words = UNSAID) -> DraftView:
        """Return what the page shows."""
        return self._view(self.draft(), words)

    def change(
        self,
        based_on: str,
        to: Callable[[SiteDraft], SiteDraft],
        words: Words = UNSAID,
        *,
        merges: bool = False,
        notes: tuple[Words, ...] | None = None,
    ) -> DraftView:
        """Change the draft.

        Args:
            based_on: version of the draft that the page shows.
            to: returns the new draft.
            words: what was done.
            merges: whether it goes on with the change before, as the next letter of a word does.
            notes: what a file held; None keeps what the last one said.

        Raises:
            StaleEdits: the draft is another one by now.
            HouseflyError: in words; the draft stays as it is.
        """
        now = self._checked(based_on)
        then = to(now)
        if then == now:
            return self._view(now, words)
        save_draft(then, self.folder)
        if not (merges and self._before):
            self._before = [*self._before, now][-_UNDO_MAX:]
        self._after = []
        self._notes = self._notes if notes is None else notes
        return self._view(then, words)

    def replace_drawn(self, based_on: str, drawn: SiteDraft, *, merges: bool = False) -> DraftView:
        """Take what the page holds; the boxes of a file stay as they are."""
        return self.change(
            based_on,
            lambda now: replace(drawn, scanned=now.scanned, source=now.source),
            merges=merges,
        )

    def undo(self, based_on: str) -> DraftView:
        """Go back to the draft before."""
        return self._step(based_on, self._before, self._after, Words("undone"))

    def redo(self, based_on: str) -> DraftView:
        """Take the last undo back."""
        return self._step(based_on, self._after, self._before, Words("done again"))

    def write(self, based_on: str) -> tuple[Path, ...]:
        """Write room and site file; raises ConfigError in words while something hinders it."""
        return write_site(self._checked(based_on), self.folder)

    def simulated_site(self) -> Path:
        """Return the file by which all of it is simulated, whether it is written or not."""
        return self.folder / (SIMULATED_FILE if self.draft().hardware else SITE_FILE)

    def close(self) -> None:
        """Stop checking."""
        self._checker.close()

    def _step(
        self, based_on: str, back: list[SiteDraft], on: list[SiteDraft], words: Words
    ) -> DraftView:
        now = self._checked(based_on)
        if not back:
            return self._view(now, Words("there is nothing more to go back to"))
        save_draft(back[-1], self.folder)
        on.append(now)
        return self._view(back.pop(), words)

    def _checked(self, based_on: str) -> SiteDraft:
        now = self.draft()
        if _version(now) != based_on:
            raise StaleEdits(
                Words(
                    "the draft was changed elsewhere, in another tab or in a terminal: this is how"
                    " it is now; make your last change again"
                )
            )
        return now

    def _view(self, draft: SiteDraft, words: Words) -> DraftView:
        check, settled = self._checker.of(draft)
        return DraftView(
            version=_version(draft),
            folder=str(self.folder),
            draft=without_scan(draft),
            scanned=len(draft.scanned),
            scan=check.scan,
            grid=check.grid,
            missing=check.missing,
            fit=check.fit,
            models=model_views(),
            settled=settled,
            undoable=bool(self._before),
            redoable=bool(self._after),
            words=words,
            notes=self._notes,
        )


def _version(draft: SiteDraft) -> str:
    return blake2b(draft_to_json(draft).encode(), digest_size=12).hexdigest()
