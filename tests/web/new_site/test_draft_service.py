"""Undo and redo of whatever was done to a draft."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.errors import ConfigError
from housefly.room.draft.files import load_draft
from housefly.room.draft.model import SiteDraft
from housefly.web.new_site.draft_service import DraftService

NAMES = st.lists(st.text("abc", max_size=3), max_size=8)


def named(draft: SiteDraft, name: str) -> SiteDraft:
    return replace(draft, name=name)


@settings(max_examples=30, deadline=None)
@given(names=NAMES)
def test_all_that_was_done_can_be_undone_and_done_again_step_by_step(names: list[str]) -> None:
    with TemporaryDirectory() as folder:
        service = DraftService(Path(folder))
        view = service.view()
        seen = [view.draft]
        for name in names:
            view = service.change(view.version, partial(named, name=name))
            if view.draft != seen[-1]:
                seen.append(view.draft)
        for before in reversed(seen[:-1]):
            assert view.undoable
            view = service.undo(view.version)
            assert view.draft == before
        assert not view.undoable
        for after in seen[1:]:
            assert view.redoable
            view = service.redo(view.version)
            assert view.draft == after == load_draft(Path(folder))
        assert not view.redoable
        service.close()


def test_what_fails_leaves_the_draft_and_its_history_alone(tmp_path: Path) -> None:
    service = DraftService(tmp_path)
    view = service.change(service.view().version, partial(named, name="first"))

    def failing(_: SiteDraft) -> SiteDraft:
        raise ConfigError("name", "is odd")

    with pytest.raises(ConfigError):
        service.change(view.version, failing)
    assert service.view() == replace(view, words="")
    service.close()
