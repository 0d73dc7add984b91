"""Compiles numeric code, so that no flight or campaign waits for it.

``python -m housefly.app.warm_up`` compiles everything, with ``chain`` behind it the control loop.
"""

from __future__ import annotations

import sys
from functools import partial

from housefly.app.compiling import CompiledPart, compile_once


def main() -> None:
    """Compile what is not compiled yet, and say so."""
    names = [name.upper() for name in sys.argv[1:]]
    for part in [CompiledPart[name] for name in names] or CompiledPart:
        compile_once(part, partial(print, flush=True))


if __name__ == "__main__":
    main()
