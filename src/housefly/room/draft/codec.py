"""A draft as JSON: what the page and the file ``draft.json`` hold; every value is checked."""

from __future__ import annotations

from pydantic import TypeAdapter, ValidationError

from housefly.config.validation import dotted, explain
from housefly.errors import ConfigError
from housefly.messages.words import Words
from housefly.room.draft.model import SiteDraft

_ADAPTER = TypeAdapter(SiteDraft)


def draft_to_json(draft: SiteDraft) -> str:
    """Return a draft as JSON; ``draft_from_json`` makes the same draft of it."""
    return _ADAPTER.dump_json(draft, indent=1).decode()


def draft_from_json(text: str | bytes, source: str = "") -> SiteDraft:
    """Return the draft of a JSON text; keys that are left out have their defaults.

    Raises:
        ConfigError: naming the first bad key, its value and what is allowed.
    """
    try:
        return _ADAPTER.validate_json(text)
    except ValidationError as error:
        first = error.errors()[0]
        key = dotted(part for part in first["loc"] if part != "json") or "draft"
        unknown = first["type"] == "unexpected_keyword_argument"
        words = Words("is not a known key") if unknown else explain(first)
        raise ConfigError(key, words, source) from error
