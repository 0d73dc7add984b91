"""Starts the processes of a site and joins their bus."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from housefly.app.compiling import CompiledPart, compile_once
from housefly.app.launcher import Launcher, processes_of
from housefly.app.new_runtime import discovery_entry, new_runtime
from housefly.app.ports import refuse_taken_ports
from housefly.app.public.temporary_folder import TemporaryFolder
from housefly.app.readiness import Readiness
from housefly.bus.bus import Bus
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.site import Site
from housefly.errors import LinkError
from housefly.hub.client.discovery import announced
from housefly.hub.store.lock import reserved_store
from housefly.sites.loaded_site import LoadedSite, with_newest_edits
from housefly.twin.installed import require_simulator

_START_TIMEOUT = 120.0
"""Longest time until pilot, tracking and drone answer [s]."""


@contextmanager
def launch(loaded: LoadedSite, *, logs: str | Path | None = None) -> Iterator[Bus]:
    """Start everything that a site needs but the console, and yield its bus when it can fly.

    Pilot, hub and, where the site enables it, the simulated room run as processes of their own
    until the block ends; the drone lands first. ``connect`` finds the room meanwhile.

    Args:
        loaded: what to start, with the newest places and zones of the ROOM screen.
        logs: folder for the output of the processes; None takes a temporary one.

    Raises:
        MissingPartError: the site simulates its room, and MuJoCo is not installed.
        LinkError: a port is taken, or something did not start or answer in time.
        StoreError: another run uses the same memory.
    """
    site, _ = with_newest_edits(loaded.site)
    if site.twin.enabled:
        require_simulator()
    refuse_taken_ports(site, web=False)
    with reserved_store(site), _started(site, logs) as bus:
        yield bus


@contextmanager
def _started(site: Site, logs: str | Path | None) -> Iterator[Bus]:
    compile_once(CompiledPart.CHAIN, lambda words: None)
    temporary = TemporaryFolder() if logs is None else None
    folder = temporary.path if temporary else Path(logs or "")
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    runtime = new_runtime(site, folder)
    with (
        announced(discovery_entry(runtime)),
        Launcher(runtime, folder, processes_of(runtime)) as launcher,
        ZenohBus(connect=runtime.bus) as bus,
    ):
        missing = Readiness(runtime.site(), bus, web=False, video=site.has_picture).wait(
            _START_TIMEOUT, is_hopeless=lambda: launcher.given_up != ()
        )
        if missing:
            if launcher.given_up:
                raise LinkError(str(launcher.given_up[0]))
            raise LinkError(f"not ready after {_START_TIMEOUT:.0f} s: {missing}")
        yield bus
    if temporary is not None:
        temporary.remove()
