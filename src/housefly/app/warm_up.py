"""Compiles all numeric code, so that no flight or campaign waits for it."""

from __future__ import annotations

from functools import partial

from housefly.app.compiling import CompiledPart, compile_once


def main() -> None:
    """Compile what is not compiled yet, and say so."""
    for part in CompiledPart:
        compile_once(part, partial(print, flush=True))


if __name__ == "__main__":
    main()
