"""Says in which keys two descriptions of a campaign differ."""

from __future__ import annotations

import json
from typing import Any

NAMED = 4
"""Differing keys that are named; the rest is counted."""


def differences(there: str, here: dict[str, Any]) -> str:
    """Return in words what differs between a description on disk (JSON) and ours; empty when
    nothing does.
    """
    try:
        old = json.loads(there)
    except ValueError:
        return "its description cannot be read"
    found = _differing(old, json.loads(json.dumps(here)), "")
    more = f" and {len(found) - NAMED} more" if len(found) > NAMED else ""
    return f"it differs in {', '.join(found[:NAMED])}{more}" if found else ""


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
