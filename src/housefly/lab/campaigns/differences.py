"""The keys in which two descriptions of a campaign differ, in words."""

from __future__ import annotations

import json
from typing import Any

_MAX_KEYS_NAMED = 4
"""At most this many differing keys are named; the rest are counted."""


def describe_differences(there: str, here: dict[str, Any]) -> str:
    """Return how a description on disk (JSON) differs from ours; "" when it does not."""
    try:
        old = json.loads(there)
    except (ValueError, RecursionError):
        return "its description cannot be read"
    found = _differing(old, json.loads(json.dumps(here)), "")
    more = f" and {len(found) - _MAX_KEYS_NAMED} more" if len(found) > _MAX_KEYS_NAMED else ""
    return f"it differs in {', '.join(found[:_MAX_KEYS_NAMED])}{more}" if found else ""


def _differing(old: Any, new: Any, key: str) -> list[str]:
    if isinstance(old, dict) and isinstance(new, dict):
        return [
            told
            for name in sorted(set(old) | set(new))
            for told in _differing(old.get(name), new.get(name), f"{key}.{name}" if key else name)
        ]
    return [] if old == new else [f"{key}: there {_short(old)}, here {_short(new)}"]


def _short(value: Any) -> str:
    text = "nothing" if value is None else json.dumps(value)
    return text if len(text) <= 40 else f"{text[:37]}..."
