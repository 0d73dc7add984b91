"""Checks that take long: the answer does not wait, and what was overtaken is left out."""

from __future__ import annotations

import threading

import pytest

from housefly.room.draft.model import SiteDraft, with_size
from housefly.web.new_site import draft_checker
from housefly.web.new_site.draft_checker import DraftChecker
from housefly.web.new_site.draft_view import MissingView, missing_views


def test_an_answer_comes_with_the_last_check_while_a_large_room_is_still_checked(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    may_end, checked = threading.Event(), []

    def slowly(draft: SiteDraft) -> tuple[MissingView, ...]:
        checked.append(draft.name)
        if draft.name != "empty":
            may_end.wait(10.0)
        return missing_views(draft)

    monkeypatch.setattr(draft_checker, "missing_views", slowly)
    checker = DraftChecker()
    first, settled = checker.of(SiteDraft(name="empty"), patience=10.0)
    assert settled and first.missing[0].step == "room"
    rooms = [with_size(SiteDraft(name=name), 6.0, 4.0) for name in ("large", "overtaken", "newest")]
    for room in rooms:
        assert checker.of(room, patience=0.01) == (first, False)
    may_end.set()
    last, settled = checker.of(rooms[-1], patience=10.0)
    assert settled and next(one.step for one in last.missing if one.hinders) == "pad"
    # One more may have been begun before the newest was there.
    assert checked[0] == "empty" and checked[-1] == "newest" and len(checked) <= 3
    checker.close()
