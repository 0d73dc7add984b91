"""Compiles the numeric code before anything waits for it, and says so."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import suppress
from enum import Enum

from housefly.app.loaded_site import open_site, read_site
from housefly.config.site import Site
from housefly.numeric import CACHE

_Say = Callable[[str], object]


class CompiledPart(Enum):
    """Code that is compiled together."""

    CHAIN = "the control loop"
    ENGINE = "the campaign engine"


def compile_once(part: CompiledPart, say: _Say) -> None:
    """Compile a part and say so, unless that was done since the sources changed."""
    mark = CACHE / f"{part.name.lower()}.done"
    if mark.exists():
        return
    say(f"compiling {part.value} (once, kept for the next start) ...")
    start = time.monotonic()
    _COMPILE[part]()
    say(f"compiled in {time.monotonic() - start:.1f} s")
    with suppress(OSError):
        mark.parent.mkdir(parents=True, exist_ok=True)
        mark.touch()


def _chain() -> None:
    from housefly.pilot.assembly import warm_up

    for changes in ({"mode": "default"}, {"mode": "paper"}, {"map__planner": "grid"}):
        loaded = open_site(read_site("bsen", **changes))
        warm_up(loaded.site, loaded.room, loaded.grid)


def _engine() -> None:
    from housefly.lab.experiments.cases import cases
    from housefly.lab.experiments.engine import fly_many
    from housefly.lab.experiments.flight_plan import FlightPlan, Task

    fly_many(cases(Site()), FlightPlan(Task.PATH, ((0.0, 0.0), (1.0, 0.0)), 1.0), threads=1)


_COMPILE: dict[CompiledPart, Callable[[], None]] = {
    CompiledPart.CHAIN: _chain,
    CompiledPart.ENGINE: _engine,
}
