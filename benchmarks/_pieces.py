"""Long benchmarks in pieces: what was done is kept in a file, and the same command goes on."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

P = TypeVar("P")


def lines_kept(path: Path) -> Iterator[dict[str, Any]]:
    """Yield the lines of a file; one that was cut short is left out."""
    for line in path.read_text("utf-8").splitlines() if path.exists() else []:
        with suppress(ValueError):
            yield json.loads(line)


def pieces_done(
    wanted: int,
    pieces: dict[int, P],
    work: Callable[[int], P],
    line: Callable[[int, P], dict[str, Any]],
    words: Callable[[P], str],
    path: Path,
    workers: int,
) -> list[P]:
    """Return so many pieces in order; those that are lacking are done now, at the lowest priority.

    Args:
        wanted: how many.
        pieces: done before, by number; what is done now is added.
        work: does one.
        line: what is kept of one.
        words: what is said of one.
        path: where the lines are kept.
        workers: processes.
    """
    with ProcessPoolExecutor(workers, initializer=partial(os.nice, 19)) as pool:
        under_way = {pool.submit(work, n): n for n in range(wanted) if n not in pieces}
        for done in as_completed(under_way):
            number, piece = under_way[done], done.result()
            pieces[number] = piece
            with path.open("a", encoding="utf-8") as file:
                file.write("\n" * bool(file.tell()) + json.dumps(line(number, piece)))
            said = f"{number}: {words(piece)}; {len(pieces)} of {wanted}"
            print(said, file=sys.stderr, flush=True)
    return [pieces[number] for number in range(wanted)]
