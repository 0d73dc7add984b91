"""Compiles the numeric code before anything waits for it, and says so."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import suppress
from enum import Enum
from hashlib import sha256
from pathlib import Path

import housefly
from housefly._compiled_function import tell_each
from housefly.config.site import Site
from housefly.numeric import CACHE, made_by
from housefly.sites.loaded_site import open_site, read_site

_Say = Callable[[str], object]
_PACKAGE = Path(housefly.__file__).parent
_KINDS: tuple[dict[str, str], ...] = (
    {"mode": "default"},
    {"mode": "paper"},
    {"map__planner": "grid"},
)
"""Pilots that call all compiled functions of a flight between them."""
_COMPILE_PLANNERS = "from housefly.app.compiling import compile_planners; compile_planners()"
_SAID_EVERY = 3.0
"""A long compilation says where it is about so often [s]."""


class CompiledPart(Enum):
    """Code that is compiled together."""

    CHAIN = "the control loop"
    ENGINE = "the campaign engine"


def compile_once(part: CompiledPart, say: _Say) -> None:
    """Compile a part and say so, unless that was done and no source that it loaded has changed.

    Only functions that a change reaches are compiled again; the others are found on disk.
    """
    mark = CACHE / f"{part.name.lower()}.done"
    if _is_fresh(mark):
        return
    say(f"compiling {part.value} (once, kept for the next start) ...")
    start = time.monotonic()
    tell_each(_Progress(say).begin)
    try:
        _COMPILE[part]()
    finally:
        tell_each(None)
    say(f"compiled in {time.monotonic() - start:.1f} s")
    with suppress(OSError):
        mark.parent.mkdir(parents=True, exist_ok=True)
        mark.write_text(json.dumps({"made_by": made_by(), "sources": _loaded_sources()}))


class _Progress:
    """Says every few seconds how many functions are compiled, and which one is next."""

    def __init__(self, say: _Say) -> None:
        self._say, self._count, self._said = say, 0, time.monotonic()

    def begin(self, name: str) -> None:
        """Count a function; say so when the last words are some seconds old."""
        self._count += 1
        if time.monotonic() - self._said >= _SAID_EVERY:
            self._said = time.monotonic()
            self._say(f"compiling {name.removeprefix('housefly.')} (function {self._count})")


def _is_fresh(mark: Path) -> bool:
    try:
        done = json.loads(mark.read_text())
        return done["made_by"] == made_by() and all(
            _content_digest(_PACKAGE / name) == digest for name, digest in done["sources"].items()
        )
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return False


def _loaded_sources() -> dict[str, str]:
    """Return the digests of all sources of this package that are loaded: what was compiled is in
    them.
    """
    files = {getattr(module, "__file__", None) for module in tuple(sys.modules.values())}
    ours = sorted(Path(file) for file in files if file and Path(file).is_relative_to(_PACKAGE))
    return {str(file.relative_to(_PACKAGE)): _content_digest(file) for file in ours}


def _content_digest(file: Path) -> str:
    return sha256(file.read_bytes()).hexdigest()


def _chain() -> None:
    """Compile the steps here and the planners on another core: what is made there is found here
    when the steps come to it.
    """
    from housefly.pilot.assembly import warm_up

    command = (sys.executable, "-c", _COMPILE_PLANNERS)
    beside = subprocess.Popen(command, stderr=subprocess.DEVNULL) if _cores() > 1 else None
    try:
        for changes in _KINDS:
            loaded = open_site(read_site("bsen", **changes))
            warm_up(loaded.site, loaded.room, loaded.grid)
    finally:
        if beside is not None:
            beside.terminate()
            beside.wait()


def compile_planners() -> None:
    """Compile what plans, beside the process that compiles the steps."""
    from housefly.pilot.assembly import make_pilot

    for changes in _KINDS:
        loaded = open_site(read_site("bsen", **changes))
        pilot = make_pilot(loaded.site, loaded.room, loaded.grid)
        pilot.plan(next(place.viewpoint for place in loaded.room.places if place.name != "home"))


def _cores() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _engine() -> None:
    from housefly.lab.experiments.cases import cases
    from housefly.lab.experiments.engine import fly_many
    from housefly.lab.experiments.flight_plan import FlightPlan, Task

    fly_many(cases(Site()), FlightPlan(Task.PATH, ((0.0, 0.0), (1.0, 0.0)), 1.0), threads=1)


_COMPILE: dict[CompiledPart, Callable[[], None]] = {
    CompiledPart.CHAIN: _chain,
    CompiledPart.ENGINE: _engine,
}
