"""Drafts of a site, as tests begin with them."""

from __future__ import annotations

from dataclasses import replace

from housefly.room.draft.model import SiteDraft, with_size
from housefly.room.draft.site_of_draft import suggested_places
from housefly.room.draft.suggestions import suggested_pad


def completed(draft: SiteDraft) -> SiteDraft:
    """Return a draft with the pad and the places that are suggested for it."""
    draft = replace(draft, pad=suggested_pad(draft))
    return replace(draft, places=suggested_places(draft))


def whole_draft() -> SiteDraft:
    """Return an empty rectangle of 6 m by 4 m, which lacks nothing."""
    return completed(with_size(SiteDraft("lab"), 6.0, 4.0))
