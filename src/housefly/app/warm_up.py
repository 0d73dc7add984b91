"""Compiles everything that is compiled, once, so that no flight and no campaign waits for it."""

from __future__ import annotations

from functools import partial

from housefly.app.compiling import CompiledPart, compile_once


def main() -> None:
    """Compile, and say so when there is something to compile."""
    for part in CompiledPart:
        compile_once(part, partial(print, flush=True))


if __name__ == "__main__":
    main()
