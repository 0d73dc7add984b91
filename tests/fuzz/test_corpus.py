"""Every input that was found worth keeping, and every one that once broke a parser, is parsed.

`make fuzz` finds them: ``run.py`` beside this file, parsers in ``support/fuzz_targets.py``.
"""

from __future__ import annotations

import time
import tracemalloc
from pathlib import Path

import pytest
from fuzz_target import FuzzTarget
from fuzz_targets import TARGETS

from housefly.errors import WireError

HERE = Path(__file__).parent
SECONDS_MAX, MEMORY_MAX = 10.0, 32 * 2**20
"""What one input may take; a good one takes milliseconds."""


def inputs(name: str) -> list[bytes]:
    """Return what is replayed: seeds, corpus, crashes."""
    folders = (HERE / "corpus" / name, HERE / "crashes" / name)
    files = [path for folder in folders if folder.is_dir() for path in sorted(folder.iterdir())]
    return [*TARGETS[name].seeds(), *(path.read_bytes() for path in files)]


@pytest.mark.parametrize("name", TARGETS)
def test_a_parser_raises_only_what_it_says_in_bounded_time_and_memory(name: str) -> None:
    target, found = TARGETS[name], inputs(name)
    target.run(found[0])
    for data in found:
        begun = time.monotonic()
        target.run(data)
        assert time.monotonic() - begun < SECONDS_MAX, data
    tracemalloc.start()
    try:
        for data in found:
            tracemalloc.reset_peak()
            before, _ = tracemalloc.get_traced_memory()
            target.run(data)
            assert tracemalloc.get_traced_memory()[1] - before < MEMORY_MAX, data
    finally:
        tracemalloc.stop()


def test_every_folder_belongs_to_a_parser_and_all_are_small() -> None:
    folders = [path for kind in ("corpus", "crashes") for path in (HERE / kind).glob("*")]
    assert {folder.name for folder in folders} <= set(TARGETS)
    assert {folder.name for folder in folders} >= set(TARGETS)
    sizes = [path.stat().st_size for folder in folders for path in folder.iterdir()]
    assert sum(sizes) < 500_000


def test_an_error_that_a_parser_does_not_document_is_not_hidden() -> None:
    def broken(data: bytes) -> None:
        raise KeyError(data) if data else WireError("empty")

    target = FuzzTarget(broken, tuple, (WireError,))
    target.run(b"")
    with pytest.raises(KeyError):
        target.run(b"x")
