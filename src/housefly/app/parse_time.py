"""Times as people type them: "10:02", "15m", "tuesday", "2026-11-20 10:00"."""

from __future__ import annotations

import re
from datetime import datetime, timedelta

from housefly.errors import ConfigError

_UNITS = {"s": 1.0, "m": 60.0, "min": 60.0, "h": 3600.0, "d": 86400.0}
_DAYS = ("monday", "tuesday", "wednesday", "thursday", "friday", "saturday", "sunday")
_FORMS = ("%Y-%m-%d %H:%M:%S", "%Y-%m-%d %H:%M", "%Y-%m-%dT%H:%M:%S", "%Y-%m-%dT%H:%M", "%Y-%m-%d")
TIME_FORMS = (
    "a time of day (10:02), a time ago (90s, 15m, 2h, 3d), a day (today, yesterday, tuesday), or"
    ' "2026-11-20 10:00"'
)


def parse_time(words: str, now: float, key: str) -> float:
    """Return the Unix time [s] of a local time in words.

    Args:
        words: as typed.
        now: Unix time [s].
        key: names the option in an error.

    Raises:
        ConfigError: with what is allowed.
    """
    text = words.strip().lower()
    today = datetime.fromtimestamp(now).replace(hour=0, minute=0, second=0, microsecond=0)
    if ago := re.fullmatch(r"(\d+(?:\.\d+)?)\s*(s|m|min|h|d)(?: ago)?", text):
        return now - float(ago[1]) * _UNITS[ago[2]]
    if clock := re.fullmatch(r"([01]?\d|2[0-3]):([0-5]\d)(?::([0-5]\d))?", text):
        at = today.replace(
            hour=int(clock[1]), minute=int(clock[2]), second=int(clock[3] or 0)
        ).timestamp()
        return at if at <= now else at - 86400.0
    if text in ("now", "today", "yesterday"):
        return {
            "now": now,
            "today": today.timestamp(),
            "yesterday": (today - timedelta(days=1)).timestamp(),
        }[text]
    if text in _DAYS:
        return (today - timedelta(days=(today.weekday() - _DAYS.index(text)) % 7)).timestamp()
    for form in _FORMS:
        try:
            return datetime.strptime(words.strip(), form).timestamp()
        except ValueError:
            continue
    raise ConfigError(key, f"is {words!r}; allowed: {TIME_FORMS}")
