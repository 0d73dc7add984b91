"""The priority of the processes that see and fly the drone."""

from __future__ import annotations

import os
from contextlib import suppress

_PILOT_NICENESS = -10
"""Nice value of the pilot, where the system allows it."""


def raise_priority() -> None:
    """Put this process before the others of the machine, where the system allows it."""
    with suppress(PermissionError):
        os.setpriority(os.PRIO_PROCESS, 0, _PILOT_NICENESS)
