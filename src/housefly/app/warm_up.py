"""Compiles everything that is compiled, once, so that no flight waits for it."""

from __future__ import annotations

import time

from housefly.app.premises import open_premises, read_site
from housefly.pilot import warm_up


def main() -> None:
    """Compile, and say so when it takes long enough to notice."""
    print("compiling the control loop (kept for the next start) ...", flush=True)
    start = time.monotonic()
    premises = open_premises(read_site("bsen"))
    warm_up(premises.site, premises.room, premises.grid)
    print(f"compiled in {time.monotonic() - start:.1f} s")


if __name__ == "__main__":
    main()
