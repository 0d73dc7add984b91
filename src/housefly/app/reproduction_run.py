"""Everything that a reproduction flies: on a stepped clock and in batches, and beside it on wires.

What fails in real time on a busy machine does not end the run: the flight over wires is flown
again once nothing else runs, and then the one on the stepped clock stands in for it, with a note.
"""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, replace

from housefly.app.reproduction_flights import RecordedService, fly_recorded_service, fly_steps
from housefly.app.reproduction_store import ReproductionStore
from housefly.app.reproduction_wires import WireService, fly_wire_service, read_wire_service
from housefly.config.site import Site
from housefly.errors import LinkError, RecordingError
from housefly.lab.experiments.engine import NICENESS
from housefly.lab.reproduction.evidence import Evidence, gather
from housefly.lab.reproduction.fig11_angles import StepFlight
from housefly.lab.reproduction.routes import MODES

ATTEMPTS = 2
"""Flights over real wires before the one on the stepped clock takes their place."""

_TOLD_EVERY = 0.2
"""Share of the simulated drones between two words about them."""
FlyWires = Callable[[Site, ReproductionStore, Callable[[str], None]], WireService]


@dataclass(frozen=True, slots=True)
class Effort:
    """How much is flown: drones for each cell of a table, repeats of the steps of Fig. 11."""

    seeds: int
    repeats: int
    wires: bool


@dataclass(frozen=True, slots=True)
class Show:
    """Who is told how far it is: words, and the share of a named part that is done, 0 to 1."""

    say: Callable[[str], None]
    share: Callable[[str, float | None], None]


@dataclass(frozen=True, slots=True, eq=False)
class Measured:
    """Everything behind figures and verdicts.

    Attributes:
        evidence: for tables and findings.
        paper, default: services on the stepped clock.
        steps: of Fig. 11.
        wired: the service over real wires; None where none was flown, or none was completed.
        wire_troubles: why flights over real wires were not completed, in words.
    """

    evidence: Evidence
    paper: RecordedService
    default: RecordedService
    steps: StepFlight
    wired: WireService | None
    wire_troubles: tuple[str, ...] = ()


class _Stopped(Exception):
    """The run is to end."""


def measure(
    site: Site,
    store: ReproductionStore,
    effort: Effort,
    show: Show,
    fly_wires: FlyWires = fly_wire_service,
) -> Measured:
    """Fly everything that is not kept, and return what was measured.

    Raises:
        LinkError: a flight on the stepped clock was not completed.
        KeyboardInterrupt: Ctrl-C; a drone in the air has landed.
    """
    stop = threading.Event()

    def tick() -> None:
        if stop.is_set():
            raise _Stopped

    with ThreadPoolExecutor(1, "reproduction", initializer=_yield_to_wires) as pool:
        stepped = pool.submit(_measure_stepped, site, store, effort, show, tick)
        try:
            if not effort.wires:
                return stepped.result()
            wired, troubles = fly_wires_patiently(site, store, show, stepped, fly_wires)
            return replace(stepped.result(), wired=wired, wire_troubles=troubles)
        finally:
            stop.set()


def fly_wires_patiently(
    site: Site,
    store: ReproductionStore,
    show: Show,
    others: Future[Measured],
    fly_wires: FlyWires = fly_wire_service,
) -> tuple[WireService | None, tuple[str, ...]]:
    """Return the service over real wires and why flights before it failed, in words.

    After the first failure it waits until nothing else runs; after the last one it returns None.

    Raises:
        LinkError: what runs beside it failed.
    """
    part = "one service over real wires (about 70 s)"
    kept = read_wire_service(site, store)
    if kept is not None:
        show.say("service over real wires: kept from an earlier run")
        return kept, ()
    troubles: list[str] = []
    while len(troubles) < ATTEMPTS:
        show.share(part, None)
        try:
            found = fly_wires(site, store, _Changes(show.say))
        except (LinkError, RecordingError) as error:
            troubles.append(str(error))
            again = "again, alone" if len(troubles) < ATTEMPTS else "no more"
            show.say(f"service over real wires not completed: {error}; it is flown {again}")
            others.result()
            continue
        show.share(part, 1.0)
        show.say("service over real wires: completed")
        return found, tuple(troubles)
    show.share(part, 1.0)
    return None, tuple(troubles)


class _Changes:
    """Says words over real wires when they change."""

    def __init__(self, say: Callable[[str], None]) -> None:
        self._say, self._last = say, ""

    def __call__(self, words: str) -> None:
        if words != self._last:
            self._last = words
            self._say(f"over real wires: {words}")


def _measure_stepped(
    site: Site, store: ReproductionStore, effort: Effort, show: Show, tick: Callable[[], None]
) -> Measured:
    part = "services and steps on a stepped clock"
    show.say("on a stepped clock: a service in mode paper, one in mode default, steps of the angle")
    show.share(part, 0.0)
    services = []
    for share, mode in ((0.25, MODES[1]), (0.5, MODES[0])):
        words = "kept from an earlier run" if store.is_kept(mode) else "completed"
        services.append(fly_recorded_service(site, mode, store, tick))
        show.share(part, share)
        show.say(f"service in mode {mode}: {words}")
    paper, default = services
    steps = fly_steps(site, effort.repeats, store, tick)
    show.share(part, 1.0)
    show.say("steps of the angle: there")
    evidence = _gathered(site, store, effort, show, tick)
    evidence = replace(evidence, services=(paper.summary, default.summary), pitch=steps.fit)
    return Measured(evidence, paper, default, steps, None)


def _gathered(
    site: Site, store: ReproductionStore, effort: Effort, show: Show, tick: Callable[[], None]
) -> Evidence:
    part, kept, told = "thousands of simulated drones", 0, 0.0

    def on_kept(count: int) -> None:
        nonlocal kept
        kept += count

    def on_share(share: float) -> None:
        nonlocal told
        tick()
        show.share(part, share)
        if share >= told + _TOLD_EVERY:
            told += _TOLD_EVERY
            show.say(f"simulated drones: {100 * told:.0f} %")

    show.share(part, 0.0)
    evidence = gather(site, effort.seeds, on_share, fly=store.batch(on_kept))
    show.share(part, 1.0)
    known = f"; {kept:,} of them kept from an earlier run" if kept else ""
    show.say(f"simulated drones: all flown{known}")
    return evidence


def _yield_to_wires() -> None:
    """Let processes that fly in real time go first."""
    if sys.platform == "linux":  # elsewhere niceness belongs to the whole process
        thread = threading.get_native_id()
        nice = max(NICENESS, os.getpriority(os.PRIO_PROCESS, thread))
        os.setpriority(os.PRIO_PROCESS, thread, nice)
