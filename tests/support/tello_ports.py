"""The ports of this machine that a Tello's clients take, shared out among tests.

Our driver takes 8890 and 11111 of one loopback address, so many may at once. Other people's take
them of all addresses: nobody else may meanwhile.
"""

from __future__ import annotations

import fcntl
import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

_LOCK = Path(tempfile.gettempdir()) / f"housefly-tello-ports-{os.getuid()}"


@contextmanager
def tello_ports(*, alone: bool = False) -> Iterator[None]:
    """Hold them with others, or alone."""
    with _LOCK.open("a") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX if alone else fcntl.LOCK_SH)
        yield
