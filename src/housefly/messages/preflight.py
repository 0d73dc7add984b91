"""One pre-flight check as people read it."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class PreflightCheck:
    """One line of the list that is looked at before a take-off.

    Attributes:
        code: short name.
        title: what is looked at, in words.
        passed: whether all is well.
        required: no take-off without it.
        value: what was found, in words.
        limit: what is allowed, in words.
        why: what would happen otherwise.
        mend: what to do.
    """

    code: str
    title: str
    passed: bool
    required: bool
    value: str
    limit: str
    why: str
    mend: str
