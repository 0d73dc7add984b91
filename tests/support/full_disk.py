"""Output on a disk that takes no more."""

from __future__ import annotations

import io
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout


@contextmanager
def full_output() -> Iterator[None]:
    """Refuse whatever is printed, as a log on a full disk does."""
    # Without a buffer, which would be refused once more when the file is closed.
    with (
        io.TextIOWrapper(io.FileIO("/dev/full", "w"), write_through=True) as full,
        redirect_stdout(full),
        redirect_stderr(full),
    ):
        yield
