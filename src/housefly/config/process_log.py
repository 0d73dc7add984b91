"""What a process prints into its log; a full disk there keeps nobody from what they do."""

from __future__ import annotations

import sys
import traceback
from contextlib import suppress
from typing import TextIO


def log_line(words: str, stream: TextIO | None = None) -> None:
    """Print a line at once, and raise nothing where it cannot be written.

    Args:
        words: without the line's end.
        stream: standard output when None.
    """
    # ValueError: the stream is closed, or its encoding lacks a letter.
    with suppress(OSError, ValueError):
        print(words, file=stream, flush=True)


def log_traceback() -> None:
    """Print the exception that is being handled, as ``log_line`` does, to standard error."""
    log_line(traceback.format_exc().rstrip("\n"), sys.stderr)
