"""What somebody may do at the console, in four steps."""

from __future__ import annotations

from enum import Enum


class Role(Enum):
    """What somebody may do; each role includes the ones before it."""

    WATCH = "watch"
    ASK = "ask"
    FLY = "fly"
    ADMIN = "admin"

    def includes(self, other: Role) -> bool:
        """Return whether this role may do what another may."""
        return _RANKS[self] >= _RANKS[other]


_RANKS = {role: rank for rank, role in enumerate(Role)}
